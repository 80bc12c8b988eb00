#pragma once

#include <algorithm>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/event_loop.hpp"

namespace carom::event {

template <class P>
void EventLoop<P>::start_resting(At now) {
  if (!motion_.contacts_last()) return;
  island_search_.reset(disks_.size());
  supports_.begin(now);
  book_.keep();
  if (supports_.any_stepped()) schedule_step(now);
}

template <class P>
void EventLoop<P>::schedule_step(At now) {
  if (motion_.pull() > 0) step_clock_.start(now, motion_.step_shift());
}

// Whether one of an island touches, two cling to each other, or they are too many.
template <class P>
bool EventLoop<P>::is_of_island(const SimultaneousImpact& group, At now) const {
  // Elastic ones part again.
  if (motion_.rules().restitution < 1 && group.contacts.size() > kManyContacts) return true;
  for (const Index m : group.members) {
    if (motion_.in_island(disks_[m])) return true;
  }
  return std::any_of(group.contacts.begin(), group.contacts.end(), [&](const Contact<S>& contact) {
    if (contact.b == kWall) return false;
    const auto a = static_cast<std::size_t>(contact.a);
    const auto b = static_cast<std::size_t>(contact.b);
    const Vec<S> v = group.bodies[b].velocity - group.bodies[a].velocity;
    return !(sharp_dot(contact.r, v) > 0) &&
           motion_.sticks(disks_[group.members[a]], disks_[group.members[b]], contact.r, now);
  });
}

// What slid along a wall rolls from now on, or slides the other way.
template <class P>
void EventLoop<P>::settle(Index i, At now) {
  if (!left_.empty()) left_[i] = kUnknown;
  motion_.carry(disks_[i], now, spin(i));
  motion_.put_at_end(disks_[i]);
  motion_.settle(disks_[i], spins_[i]);
  supports_.update(i);
  book_.keep();
  predict_again(i, now);
}

template <class P>
double EventLoop<P>::given_ahead(At now) const {
  return step_clock_.runs() ? supports_.given_ahead(now, step_clock_.next()) : 0;
}

}  // namespace carom::event
