#include "simulation_record.hpp"

#include <numeric>
#include <utility>

namespace carom {

SimulationRecord::SimulationRecord(Solver& solver)
    : solver_(solver), ids_(solver.balls()), next_id_(solver.balls()) {
  std::iota(ids_.begin(), ids_.end(), std::size_t{0});
}

void SimulationRecord::save(Bookkeeping& bookkeeping) const {
  bookkeeping.ids = ids_;
  bookkeeping.next_id = next_id_;
  bookkeeping.next_event = record_.next_event();
}

void SimulationRecord::go_on_from(const Bookkeeping& earlier) {
  ids_ = earlier.ids;
  next_id_ = earlier.next_id;
  record_ = ImpactRecord(earlier.next_event);
}

void SimulationRecord::record(bool wanted) {
  solver_.record_impacts(wanted);
  wanted_ = wanted;
  record_ = ImpactRecord(record_.next_event());
}

std::vector<Impact> SimulationRecord::take(bool at_the_end) {
  collect(at_the_end);
  for (std::size_t i = 0; i < ids_.size() && at_the_end; ++i) tell_slides(i);
  return record_.take();
}

void SimulationRecord::added(const Vec2& position, double time) {
  ids_.push_back(next_id_++);
  note({.kind = ImpactKind::add, .a = ids_.back(), .position = position}, time);
}

void SimulationRecord::removes(std::size_t ball, double time) {
  if (wanted_) {
    before_change();
    tell_slides(ball);
    const Vec2 position = solver_.state().at(ball).position;
    note({.kind = ImpactKind::remove, .a = ids_[ball], .position = position}, time);
  }
  ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(ball));
}

void SimulationRecord::collect(bool of_all) {
  if (!wanted_) return;
  std::vector<Impact> impacts;
  solver_.take_impacts(impacts, of_all);
  record_.add(std::move(impacts), ids_);
}

void SimulationRecord::note(Impact command, double time) {
  if (!wanted_) return;
  collect(true);
  command.time = time;
  record_.add(command);
}

// Contacts that end without an event.
void SimulationRecord::tell_slides(std::size_t ball) {
  if (!wanted_) return;
  std::vector<Impact> impacts;
  solver_.tell_slides(ball, impacts);
  record_.add(std::move(impacts), ids_);
}

}  // namespace carom
