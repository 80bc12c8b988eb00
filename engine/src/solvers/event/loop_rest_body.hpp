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
  for (Index i = 0; i < disks_.size(); ++i) {
    Disk& disk = disks_[i];
    if (motion_.fixed(disk)) continue;
    const unsigned support = motion_.support(disk);
    if (support != kLying && support < kResting && disk.start == now) {
      book_.note(motion_.support_on_walls(disk, spin(i)));
    }
    if (motion_.support(disk) >= kStepped) schedule_step(now);
  }
  book_.keep();
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

template <class P>
void EventLoop<P>::update_support(Index i) {
  Disk& disk = disks_[i];
  if (!motion_.contacts_last() || motion_.fixed(disk)) return;
  const unsigned before = motion_.support(disk);
  book_.note(motion_.support_on_walls(disk, spin(i)));
  const Index fixed_disk = left_[i];
  if (fixed_disk != kUnknown) book_.note(motion_.support_on_fixed_disk(disk, disks_[fixed_disk]));
  if ((axes_of(motion_.support(disk)) & ~axes_of(before)) != 0) ++counts_.resting_contacts;
}

// What slid along a wall rolls from now on, or slides the other way.
template <class P>
void EventLoop<P>::settle(Index i, At now) {
  if (!left_.empty()) left_[i] = kUnknown;
  motion_.carry(disks_[i], now, spin(i));
  motion_.settle(disks_[i], spins_[i]);
  update_support(i);
  book_.keep();
  predict_again(i, now);
}

template <class P>
void EventLoop<P>::wake_around(Index i, At now) {
  // Only collisions let one ball carry another, and only they keep a grid to look into.
  if (!motion_.contacts_last() || !motion_.rules().collisions) return;
  const Vec<S> here = motion_.wrapped(motion_.place(disks_[i], now));
  for (const Index j :
       neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y))) {
    Disk& disk = disks_[j];
    if (motion_.support(disk) != kResting && motion_.support(disk) != kLying) continue;
    const S reach = motion_.species(disks_[i]).radius + motion_.species(disk).radius;
    if (!near(motion_.way(here, motion_.place(disk, now)), reach, S(kNear))) continue;
    motion_.set_support(disk, kJoins);
  }
}

template <class P>
double EventLoop<P>::given_ahead(At now) const {
  double sum = 0;
  if (!step_clock_.runs()) return sum;
  for (const Disk& disk : disks_) {
    if (motion_.fixed(disk) || motion_.support(disk) != kStepped) continue;
    sum += motion_.given_ahead(disk, now, step_clock_.next());
  }
  return sum;
}

}  // namespace carom::event
