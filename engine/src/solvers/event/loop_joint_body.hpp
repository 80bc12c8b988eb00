#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/joint_friction.hpp"
#include "solvers/event/event_loop.hpp"
#include "solvers/event/order_by_place.hpp"

namespace carom::event {

// What one impact does, alone or of all that touches: flights, counts, losses and notes.

template <class P>
void EventLoop<P>::meet_and_note(Index i, Index partner, At now) {
  const bool ball = moves(partner);
  const Disk was = disks_[i];
  const Disk partner_was = ball ? disks_[partner] : Disk{};
  for (const Index k : {i, partner}) {
    if (k == partner && !ball) continue;
    schedule_.unlink(k);
    schedule_.forget(k);
  }
  meet_alone(i, partner, now);
  const double lost = book_.keep();
  if (notes_.wanted()) writer_.single(i, partner, was, partner_was, lost, now);
  if (ball) changed_.push_back(partner);
  changed_.push_back(i);
}

template <class P>
void EventLoop<P>::resolve_alone(Index i, Index partner, At now) {
  resolutions_.begin();
  remember(i);
  if (moves(partner)) remember(partner);
  meet_and_note(i, partner, now);
  resolutions_.end();
}

// Of several fixed balls that it touches the flight began at the one that lies first, by place.
template <class P>
void EventLoop<P>::note_left(const SimultaneousImpact& group, At now) {
  std::vector<const Vec<S>*> ways(group.members.size(), nullptr);
  for (const Contact<S>& contact : group.contacts) {
    if (contact.b == kWall) continue;
    const auto a = static_cast<std::size_t>(contact.a);
    const Index b = group.members[static_cast<std::size_t>(contact.b)];
    const Index ball = group.members[a];
    if (!motion_.fixed(disks_[b]) || disks_[ball].start != now) continue;
    const Vec<S>* first = ways[a];
    const Vec<S>& r = contact.r;
    if (first != nullptr && precedes_by_place(*first, r)) continue;
    ways[a] = &r;
    left_[ball] = b;
  }
}

template <class P>
JointReport EventLoop<P>::resolve(SimultaneousImpact& group, JointRecord<S>* record) const {
  const std::span<const Contact<S>> contacts = group.contacts;
  if (spins_.empty()) return resolve_jointly<S>(group.bodies, contacts, nullptr, record);
  std::vector<S> radii;
  for (const Index m : group.members) radii.push_back(motion_.species(disks_[m]).radius);
  JointFriction<S> friction(group.bodies, group.spins, radii, contacts,
                            {motion_.rules().friction, motion_.rules().wall_friction});
  return resolve_jointly<S>(group.bodies, contacts, &friction, record);
}

template <class P>
void EventLoop<P>::resolve_group(SimultaneousImpact& group, const std::vector<Index>& to_predict,
                                 At now) {
  for (const Index m : group.members) remember(m);
  // Nothing else touches: it is an impact like others, however it came to be looked at.
  if (group.contacts.size() == 1 && group.members.size() < 3) {
    const Contact<S>& contact = group.contacts.front();
    const Index i = group.members[static_cast<std::size_t>(contact.a)];
    const Index partner = contact.b == kWall ? group.stops.front().wall
                                             : group.members[static_cast<std::size_t>(contact.b)];
    meet_and_note(i, partner, now);
    return;
  }

  group.each_contact(
      [this](const Contact<S>&, Index i, Index partner) { pairs_.note_resolved(i, partner); });
  const std::vector<Body<S>> before = group.bodies;
  const std::vector<S> spins_before = group.spins;
  ++counts_.joint_impacts;
  JointRecord<S> record;
  const JointReport report = resolve(group, notes_.wanted() ? &record : nullptr);
  const std::size_t first_line = notes_.lines();
  if (notes_.wanted()) writer_.joint(group, record, now);
  const auto walls = static_cast<std::uint64_t>(report.walls);
  const auto balls = static_cast<std::uint64_t>(report.impacts);
  counts_.ball_wall += walls;
  counts_.ball_ball += balls;
  counts_.jammed += gives_up() ? group.contacts.size() : static_cast<std::uint64_t>(report.jammed);
  book_.note(report.lost);
  double lost = book_.keep();

  std::vector<Index> changed;
  for (std::size_t k = 0; k < group.members.size(); ++k) {
    const Index m = group.members[k];
    Disk& disk = disks_[m];
    if (motion_.fixed(disk)) continue;
    bool same = before[k].velocity == group.bodies[k].velocity;
    if (!spins_.empty()) same = same && spins_before[k] == group.spins[k];
    const bool looks = std::find(to_predict.begin(), to_predict.end(), m) != to_predict.end();
    if (same && !looks) continue;
    schedule_.unlink(m);
    schedule_.forget(m);
    changed.push_back(m);
    if (same) continue;
    disk.x = group.places[k].x;
    disk.y = group.places[k].y;
    disk.vx = with_plain_zero(group.bodies[k].velocity.x);
    disk.vy = with_plain_zero(group.bodies[k].velocity.y);
    if (!spins_.empty()) spins_[m] = group.spins[k];
    disk.start = now;
    if (!left_.empty() && !same) left_[m] = kUnknown;
  }
  for (const typename SimultaneousImpact::Stop& stop : group.stops) {
    Disk& disk = disks_[group.members[stop.member]];
    // To move the others would take the energy of their height.
    if (disk.start != now || !stop.meets) continue;
    const S at = motion_.wall(disk, {disk.x, disk.y}, stop.wall).stop;
    (stop.wall - kWalls < 2 ? disk.x : disk.y) = at;
  }
  if (!left_.empty()) note_left(group, now);
  for (const Index m : changed) update_support(m);
  lost += book_.keep();
  notes_.tell_loss(first_line, lost);
  if (motion_.clusters()) {
    for (const Contact<S>& contact : group.contacts) {
      if (contact.b == kWall || contact.restitution == 1) continue;
      const Disk& a = disks_[group.members[static_cast<std::size_t>(contact.a)]];
      const Disk& b = disks_[group.members[static_cast<std::size_t>(contact.b)]];
      if (a.start == now && b.start == now && motion_.stay_together(a, b)) {
        ++counts_.resting_contacts;
      }
    }
  }
  changed_.insert(changed_.end(), changed.begin(), changed.end());
}

}  // namespace carom::event
