#pragma once

#include <memory>
#include <vector>

#include "solvers/event/core.hpp"

namespace carom::event {

/// A core in more digits than double has: whatever it does is done in their precision.
class WideCore final : public Core {
 public:
  /// REQUIRES: digits of 34, 50 or 100.
  WideCore(CoreStart start, int digits);

  [[nodiscard]] std::vector<Phase> phases() override;
  [[nodiscard]] std::size_t aim(double time) override;
  void set_workers(std::size_t workers) override;
  void add(const Ball& ball) override;
  void remove(std::size_t ball) override;
  void set(const Domain& domain, const Effects& effects, bool bends) override;
  [[nodiscard]] const std::vector<Ball>& balls() const override { return core_->balls(); }
  using Core::look;
  void look(std::size_t first, std::span<Ball> balls) const override;
  [[nodiscard]] std::vector<ExactPosition> exact_positions() const override;
  [[nodiscard]] Turns turns() const override;
  [[nodiscard]] double energy_ahead() const override;
  [[nodiscard]] double dissipated() const override;
  [[nodiscard]] std::vector<double> losses() const override;
  void go_on_from_losses(const std::vector<double>& losses) override;
  [[nodiscard]] Tally tally() const override;
  void save(Continuation& continuation) const override;
  void visit_flights(const std::function<void(const SavedFlight&)>& visit) const override;
  void record_impacts(bool wanted) override;
  void take_impacts(std::vector<Impact>& impacts) override;
  void tell_slides(std::size_t ball, std::vector<Impact>& impacts) const override;

 private:
  int digits_;
  std::unique_ptr<Core> core_;
};

}  // namespace carom::event
