#pragma once

#include <string>
#include <vector>

#include "solvers/event/core_in_precision.hpp"
#include "solvers/solver.hpp"

namespace carom {

/// Method `event`: balls fly on their closed-form paths from impact to impact, in the order of
/// time.  There is no step; a frame only looks.
///
/// The same for every law of flight and number of digits: those are the core's.
///
/// Holds: the same bits at any frame rate, number of workers and order in memory.
class EventSolver final : public Solver {
 public:
  EventSolver(const Scene& scene, std::vector<Ball> balls, const event::Sharing& sharing = {});

  [[nodiscard]] std::vector<Phase> phases() override { return core_.phases(); }
  void set_workers(std::size_t workers) override { core_->set_workers(workers); }
  [[nodiscard]] std::size_t aim(double time) override { return core_->aim(time); }
  void add(const Ball& ball) override;
  void remove(std::size_t ball) override;
  void set(const Effects& effects) override;
  void set_step(double) override {}
  [[nodiscard]] std::size_t balls() const override { return core_->balls().size(); }
  void visit_state(const BallVisitor& visit) const override;
  [[nodiscard]] std::vector<ExactPosition> exact_positions() const override {
    return core_->exact_positions();
  }
  [[nodiscard]] std::string state_hash() const override;
  [[nodiscard]] double energy() const override { return sums().energy; }
  [[nodiscard]] double dissipated() const override { return core_->dissipated(); }
  [[nodiscard]] std::vector<double> losses() const override { return core_->losses(); }
  void go_on_from_losses(const std::vector<double>& losses) override {
    core_->go_on_from_losses(losses);
  }
  [[nodiscard]] Vec2 momentum() const override { return sums().momentum; }
  [[nodiscard]] Sums sums() const override;
  void count(Measurements& measurements) const override;
  void save(Scene& scene) const override;
  void visit_flights(const FlightVisitor& visit) const override { core_->visit_flights(visit); }
  void record_impacts(bool wanted) override { core_->record_impacts(wanted); }
  void take_impacts(std::vector<Impact>& impacts, bool /*of_all*/) override {
    core_->take_impacts(impacts);
  }
  void tell_slides(std::size_t ball, std::vector<Impact>& impacts) const override {
    core_->tell_slides(ball, impacts);
  }

 private:
  void refuse_other_places(const Scene& scene) const;

  Domain domain_;
  Effects effects_;
  event::CoreInPrecision core_;
};

}  // namespace carom
