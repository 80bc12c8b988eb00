#pragma once

#include <algorithm>

#include "solvers/event/event_loop.hpp"
#include "solvers/event/sampled_costs.hpp"

namespace carom::event {

// The event is timed as a whole, what is not the pairs' in it apart.
template <class P>
[[gnu::noinline]] void EventLoop<P>::time_event(Index i, At now) {
  TimedEvent<P> event;
  event.before = disks_[i];
  event.partner = event.before.meets <= event.before.leaves ? event.before.partner : kUnknown;
  const bool at_ball = event.partner < kFirstMark;
  event.other_before = at_ball ? disks_[event.partner] : event.before;

  const double islands = costs_.island_seconds();
  double whole = seconds_of([&] {
    next_event(i, now);
    if (!pairs_.waiting().empty() && first_event(now) == nullptr) resolve_waiting();
  });
  whole -= costs_.island_seconds() - islands;

  event.after = disks_[i];
  event.until = std::min(event.after.meets, event.after.leaves);
  event.spins = !spins_.empty();
  if (event.spins) {
    event.spin = spins_[i];
    if (at_ball) event.other_spin = spins_[event.partner];
  }
  Costs costs = costs_beside_pairs(motion_, event, now);
  if (motion_.rules().collisions) {
    costs.collisions = std::max(0.0, whole - costs.beside_pairs());
  }
  costs_.add(costs);
}

}  // namespace carom::event
