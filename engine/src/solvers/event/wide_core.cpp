#include "solvers/event/wide_core.hpp"

#include <utility>

#include "numbers/wide_number.hpp"
#include "solvers/event/loop_core.hpp"
#include "solvers/event/wide_physics.hpp"

namespace carom::event {

WideCore::WideCore(CoreStart start, int digits) : digits_(digits) {
  const WidePrecision precision(digits_);
  core_ = std::make_unique<LoopCore<WidePhysics>>(std::move(start));
}

std::vector<Phase> WideCore::phases() {
  std::vector<Phase> phases = core_->phases();
  for (Phase& phase : phases) {
    phase.work = [this, work = std::move(phase.work)](Share share) {
      const WidePrecision precision(digits_);
      work(share);
    };
    phase.finish = [this, finish = std::move(phase.finish)] {
      const WidePrecision precision(digits_);
      return finish();
    };
  }
  return phases;
}

std::size_t WideCore::aim(double time) {
  const WidePrecision precision(digits_);
  return core_->aim(time);
}

void WideCore::set_workers(std::size_t workers) {
  const WidePrecision precision(digits_);
  core_->set_workers(workers);
}

void WideCore::add(const Ball& ball) {
  const WidePrecision precision(digits_);
  core_->add(ball);
}

void WideCore::remove(std::size_t ball) {
  const WidePrecision precision(digits_);
  core_->remove(ball);
}

void WideCore::set(const Domain& domain, const Effects& effects, bool bends) {
  const WidePrecision precision(digits_);
  core_->set(domain, effects, bends);
}

void WideCore::look(std::size_t first, std::span<Ball> balls) const {
  const WidePrecision precision(digits_);
  core_->look(first, balls);
}

std::vector<ExactPosition> WideCore::exact_positions() const {
  const WidePrecision precision(digits_);
  return core_->exact_positions();
}

Turns WideCore::turns() const {
  const WidePrecision precision(digits_);
  return core_->turns();
}

double WideCore::energy_ahead() const {
  const WidePrecision precision(digits_);
  return core_->energy_ahead();
}

double WideCore::dissipated() const {
  const WidePrecision precision(digits_);
  return core_->dissipated();
}

std::vector<double> WideCore::losses() const {
  const WidePrecision precision(digits_);
  return core_->losses();
}

void WideCore::go_on_from_losses(const std::vector<double>& losses) {
  core_->go_on_from_losses(losses);
}

Tally WideCore::tally() const {
  const WidePrecision precision(digits_);
  return core_->tally();
}

void WideCore::save(Continuation& continuation) const {
  const WidePrecision precision(digits_);
  core_->save(continuation);
}

void WideCore::visit_flights(const std::function<void(const SavedFlight&)>& visit) const {
  const WidePrecision precision(digits_);
  core_->visit_flights(visit);
}

void WideCore::record_impacts(bool wanted) {
  const WidePrecision precision(digits_);
  core_->record_impacts(wanted);
}

void WideCore::take_impacts(std::vector<Impact>& impacts) {
  const WidePrecision precision(digits_);
  core_->take_impacts(impacts);
}

void WideCore::tell_slides(std::size_t ball, std::vector<Impact>& impacts) const {
  const WidePrecision precision(digits_);
  core_->tell_slides(ball, impacts);
}

}  // namespace carom::event
