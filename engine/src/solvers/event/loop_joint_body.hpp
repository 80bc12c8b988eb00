#pragma once

#include <algorithm>
#include <vector>

#include "solvers/event/event_loop.hpp"

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
  ++counts_.joint_impacts;
  JointRecord<S> record;
  const auto [report, new_flight] = joint_impacts_.resolve(
      group, notes_.wanted() ? &record : nullptr, gives_up() && motion_.elastic());
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
    const bool looks = std::find(to_predict.begin(), to_predict.end(), m) != to_predict.end();
    if (motion_.fixed(disks_[m]) || (new_flight[k] == 0 && !looks)) continue;
    schedule_.unlink(m);
    schedule_.forget(m);
    changed.push_back(m);
  }
  joint_impacts_.begin_flights(group, new_flight, now);
  for (const Index m : changed) {
    if (disks_[m].start == now) supports_.update(m);
  }
  lost += book_.keep();
  notes_.tell_loss(first_line, lost);
  if (motion_.clusters()) counts_.resting_contacts += joint_impacts_.staying_together(group, now);
  changed_.insert(changed_.end(), changed.begin(), changed.end());
}

}  // namespace carom::event
