#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/dissipation.hpp"
#include "solvers/event/event_loop.hpp"

namespace carom::event {

/// A ball at rest that moves again from now on.
inline Impact wake_of(const Vec<double>& at, std::size_t i, double seconds) {
  Impact impact;
  impact.time = seconds;
  impact.kind = ImpactKind::wake;
  impact.a = i;
  impact.position = {at.x, at.y};
  return impact;
}

/// A slide along a wall as a contact that does not bounce; `at`: where ball i is then.
template <class P>
Impact impact_of(const typename Motion<P>::Slide& slide, const Vec<double>& at, std::size_t i,
                 double seconds, double radius) {
  const std::size_t axis = (slide.wall - kWalls) / 2;
  const bool upper = (slide.wall - kWalls) % 2 == 1;
  Impact impact;
  impact.time = seconds;
  impact.kind = ImpactKind::rest;
  impact.a = i;
  impact.wall = side_of(axis, upper);
  impact.position = {at.x, at.y};
  impact.normal[axis] = upper ? 1 : -1;
  impact.distance = radius;
  impact.impulse = slide.impulse;
  impact.tangential = slide.tangential;
  impact.energy_lost = slide.lost;
  return impact;
}

template <class P>
void EventLoop<P>::log_wake(Index i, At now) {
  const auto seconds = static_cast<double>(motion_.rules().scale.seconds(now));
  log_->impacts.push_back(wake_of(in_double(motion_.place(disks_[i], now)), i, seconds));
}

/// A contact of ball i with ball j, or with a wall: everything but what it carries.
template <class P>
Impact& EventLoop<P>::log_contact(At now, Index i, Index j, const Vec<S>& r) {
  if (j < i) return log_contact(now, j, i, -r);
  const S length = root(S(r.x * r.x + r.y * r.y));
  const Vec<S> at = motion_.wrapped(motion_.place(disks_[i], now));
  Impact& impact = log_->impacts.emplace_back();
  impact.time = static_cast<double>(motion_.rules().scale.seconds(now));
  impact.a = i;
  impact.position = {static_cast<double>(at.x), static_cast<double>(at.y)};
  // No component is -0.
  impact.normal = {static_cast<double>(S(r.x / length)) + 0.0,
                   static_cast<double>(S(r.y / length)) + 0.0};
  if (j >= kWalls) {
    impact.kind = ImpactKind::wall;
    impact.wall = side_of((j - kWalls) / 2, (j - kWalls) % 2 == 1);
    impact.distance = static_cast<double>(motion_.species(disks_[i]).radius);
  } else {
    impact.b = j;
    impact.distance = static_cast<double>(length);
  }
  return impact;
}

// From the velocities before and after, as the impact has left them.
template <class P>
void EventLoop<P>::log_alone(Index i, Index partner, const Disk& was_a, const Disk& was_b,
                             double lost, At now) {
  const bool wall = partner >= kWalls;
  const bool moves = !wall && !motion_.fixed(disks_[partner]);
  // Which of the two it was found from must not show in the last bits.
  if (moves && partner < i) return log_alone(partner, i, was_b, was_a, lost, now);
  const Disk& a = disks_[i];
  const Vec<S> a_before = motion_.velocity(was_a, now);
  Vec<S> r{S(0), S(0)};
  if (wall) {
    const S side = partner % 2 == kWalls % 2 ? -1 : 1;
    (partner - kWalls < 2 ? r.x : r.y) = side;
  } else {
    r = motion_.way(motion_.place(a, now), motion_.place(disks_[partner], now));
  }
  Impact& impact = log_contact(now, i, partner, r);
  // Both impulses are the same seen from either of the two; here the normal leads away from i.
  const Vec2 n = impact.a == i ? impact.normal : -impact.normal;
  const Vec2 t{-n.y(), n.x()};
  const Vec2 change{static_cast<double>(S(a_before.x - a.vx)),
                    static_cast<double>(S(a_before.y - a.vy))};
  const auto inverse = static_cast<double>(motion_.species(a).inverse_mass);
  impact.impulse = change.dot(n) / inverse;
  impact.energy_lost = lost;
  if (spins_.empty()) return;
  impact.tangential = change.dot(t) / inverse;
}

// Of the flight that ends, or of the one that goes on after all, as its end was taken back.
template <class P>
void EventLoop<P>::log_slides(Index i, At now) {
  const auto seconds = static_cast<double>(motion_.rules().scale.seconds(now));
  if (disks_[i].start != now) {
    std::erase_if(slid_,
                  [&](const Impact& slide) { return slide.a == i && slide.time == seconds; });
    return;
  }
  const S* was = counted_spins_.empty() ? nullptr : &counted_spins_[i];
  for (const auto& slide : motion_.slides_of(counted_[i], was, now)) {
    const Vec<S> at = motion_.wrapped(motion_.place(counted_[i], now));
    slid_.push_back(impact_of<P>(slide, in_double(at), i, seconds,
                                 static_cast<double>(motion_.species(disks_[i]).radius)));
  }
}

template <class P>
void EventLoop<P>::keep_slides() {
  if (log_ != nullptr) log_->impacts.insert(log_->impacts.end(), slid_.begin(), slid_.end());
  slid_.clear();
}

template <class S>
double lost_of(const Stroke<S>& stroke) {
  return static_cast<double>(S(stroke.impulse * stroke.approach * (1 - stroke.restitution) / 2));
}

// One line for each time that a contact is hit; friction, which comes first, with its first.
template <class P>
void EventLoop<P>::log_joint(const SimultaneousImpact& group, const JointLog& joint, At now) {
  const std::uint64_t event = log_->impacts.size() + 1;
  // Where no restitution takes energy, what is held in a gap of zero is all that is lost.
  const bool elastic =
      std::all_of(group.contacts.begin(), group.contacts.end(),
                  [](const Contact<S>& contact) { return contact.restitution == 1; });
  double held = joint.held;
  std::size_t stops = 0;
  for (std::size_t k = 0; k < group.contacts.size(); ++k) {
    const Contact<S>& contact = group.contacts[k];
    const Index i = group.members[static_cast<std::size_t>(contact.a)];
    const Index j = contact.b == kWall ? group.stops[stops++].wall
                                       : group.members[static_cast<std::size_t>(contact.b)];
    const auto note = [&]() -> Impact& {
      Impact& impact = log_contact(now, i, j, contact.r);
      impact.kind = ImpactKind::joint;
      impact.event = event;
      return impact;
    };
    carom::FrictionChange by_friction =
        joint.by_friction.empty() ? carom::FrictionChange{} : joint.by_friction[k];
    for (const Stroke<S>& stroke : joint.strokes) {
      if (stroke.contact != k) continue;
      Impact& impact = note();
      impact.impulse = static_cast<double>(stroke.impulse);
      impact.tangential = by_friction.impulse;
      impact.energy_lost = by_friction.lost + (elastic ? std::exchange(held, 0) : lost_of(stroke));
      by_friction = {};
    }
    if (by_friction.impulse == 0) continue;
    Impact& impact = note();
    impact.kind = ImpactKind::rest;
    impact.tangential = by_friction.impulse;
    impact.energy_lost = by_friction.lost;
  }
}

// What presses without being counted is a contact at rest; the first line has what all lost, or
// the only one where nothing presses.
template <class P>
void EventLoop<P>::log_island(const FoundIsland& island, const IslandLog& log, At now) {
  const std::uint64_t event = log_->impacts.size() + 1;
  const auto counted = std::count(log.counted.begin(), log.counted.end(), 1);
  double lost = log.lost;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const bool last = k + 1 == island.contacts.size();
    if (log.counted[k] == 0 && !(log.impulses[k] > 0) && !(last && lost != 0)) continue;
    const ConeContact& contact = island.contacts[k];
    const Index i = island.members[static_cast<std::size_t>(contact.a)];
    const Index j = contact.b == kWall ? island.near[k].partner
                                       : island.members[static_cast<std::size_t>(contact.b)];
    Impact& impact = log_contact(now, i, j, island.near[k].r);
    impact.impulse = log.impulses[k];
    impact.energy_lost = lost;
    lost = 0;
    if (log.counted[k] == 0) {
      impact.kind = ImpactKind::rest;
    } else if (counted > 1) {
      impact.kind = ImpactKind::joint;
      impact.event = event;
    }
  }
}

template <class P>
void EventLoop<P>::log_loss(std::size_t first, double lost) {
  if (log_ == nullptr || first >= log_->impacts.size()) return;
  double told = 0;
  for (std::size_t k = first; k < log_->impacts.size(); ++k) told += log_->impacts[k].energy_lost;
  log_->impacts[first].energy_lost += lost - told;
}

}  // namespace carom::event
