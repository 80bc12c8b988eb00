#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "solvers/event/event_solver.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// Method `event` under gravity with drag: hops that drag makes ever shorter come to rest.
///
/// P flies and hits; at the first hop that rule 1 of event_rest.hpp would not let a ball do, Rest,
/// which also knows what rests, and costs more for it, goes on from the same flights.  When that is
/// follows from the flights alone.
template <class P, class Rest>
class SettlingSolver final : public Solver {
 public:
  SettlingSolver(const Scene& scene, std::vector<Ball> balls)
      : flying_(std::make_unique<EventSolver<P>>(scene, std::move(balls), alone())),
        work_(flying_->phases().front().work) {}

  [[nodiscard]] std::vector<Phase> phases() override {
    return {{"impacts",
             [this](Share share) {
               if (share.index == 0) advance();
             },
             [] { return Phase::kFrameDone; }}};
  }
  void set_workers(std::size_t) override {}
  [[nodiscard]] std::size_t aim(double time) override {
    target_ = time;
    return present().aim(time);
  }
  void add(const Ball& ball) override { present().add(ball); }
  void remove(std::size_t ball) override { present().remove(ball); }
  void set(const Effects& effects) override { present().set(effects); }
  void set_step(double) override {}
  [[nodiscard]] std::size_t balls() const override { return present().balls(); }
  [[nodiscard]] std::vector<Ball> state() const override { return present().state(); }
  [[nodiscard]] std::vector<ExactPosition> exact_positions() const override {
    return present().exact_positions();
  }
  [[nodiscard]] std::string state_hash() const override { return present().state_hash(); }
  [[nodiscard]] double energy() const override { return present().energy(); }
  [[nodiscard]] Vec2 momentum() const override { return present().momentum(); }
  void count(Measurements& measurements) const override { present().count(measurements); }
  void save(Scene& scene) const override { present().save(scene); }
  void record_impacts(bool wanted) override { present().record_impacts(wanted); }
  void take_impacts(std::vector<Impact>& impacts) override { present().take_impacts(impacts); }

 private:
  /// In one tile, for windows would have to stop at the same hop.
  static typename EventSolver<P>::Choice alone() {
    typename EventSolver<P>::Choice choice;
    choice.parts = 1;
    return choice;
  }

  [[nodiscard]] Solver& present() { return flying_ ? static_cast<Solver&>(*flying_) : *resting_; }
  [[nodiscard]] const Solver& present() const {
    return flying_ ? static_cast<const Solver&>(*flying_) : *resting_;
  }

  void advance() {
    work_({0, 1});
    if (!flying_ || !flying_->settles()) return;
    resting_ = std::make_unique<EventSolver<Rest>>(*flying_);
    flying_.reset();
    work_ = resting_->phases().front().work;
    if (resting_->aim(target_) != Phase::kFrameDone) work_({0, 1});
  }

  std::unique_ptr<EventSolver<P>> flying_;      // till the first comes to rest
  std::unique_ptr<EventSolver<Rest>> resting_;  // from then on
  std::function<void(Share)> work_;             // of the present one
  double target_ = 0;
};

}  // namespace carom
