#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "contact/joint_friction.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/loop_island_search_body.hpp"
#include "solvers/event/loop_touching_body.hpp"

namespace carom::event {

template <class P>
void EventLoop<P>::resolve_together(std::vector<Pair> alone, const std::vector<Pair>& joint,
                                    At now) {
  // Of all of them it is not known any more what they meet next.
  std::vector<Index> to_predict;
  for (const Pair& pair : joint) {
    pairs_.link(pair);
    for (const Index k : {pair.first, pair.second}) {
      if (moves(k) && std::find(to_predict.begin(), to_predict.end(), k) == to_predict.end()) {
        to_predict.push_back(k);
      }
    }
  }
  const std::size_t links = pairs_.linked().size();
  for (const Pair& pair : alone) pairs_.link(pair);
  std::vector<SimultaneousImpact> groups = groups_of(to_predict, now);
  pairs_.drop_links(links);
  std::erase_if(alone, [&](const Pair& pair) {
    const bool found =
        std::any_of(groups.begin(), groups.end(), [&](const SimultaneousImpact& group) {
          return group.find(pair.first) < group.members.size();
        });
    if (!found) return false;
    pairs_.link(pair);
    for (const Index k : {pair.first, pair.second}) {
      if (moves(k)) to_predict.push_back(k);
    }
    return true;
  });
  std::vector<std::vector<Index>> islands;
  std::vector<SimultaneousImpact> others;
  for (SimultaneousImpact& group : groups) {
    if (!motion_.contacts_last() || !is_of_island(group, now)) {
      others.push_back(std::move(group));
      continue;
    }
    std::vector<Index>& island = islands.emplace_back();
    std::copy_if(group.members.begin(), group.members.end(), std::back_inserter(island),
                 [this](Index m) { return !motion_.fixed(disks_[m]); });
  }
  if (motion_.contacts_last()) {
    std::erase_if(alone, [&](const Pair& pair) {
      if (!is_hit_of_island(pair.first, pair.second, now)) return false;
      std::vector<Index>& island = islands.emplace_back();
      island.push_back(pair.first);
      if (moves(pair.second)) island.push_back(pair.second);
      return true;
    });
  }
  hit_islands(std::move(islands), now);
  // What an island has taken with it has other velocities now: its contacts are looked for again.
  const auto is_taken = [&](std::vector<Index> balls) {
    if (std::none_of(balls.begin(), balls.end(),
                     [&](Index m) { return moves(m) && resolutions_.contains(m); })) {
      return false;
    }
    for (const Index m : balls) {
      if (!moves(m) || resolutions_.contains(m)) continue;
      schedule_.unlink(m);
      schedule_.forget(m);
      changed_.push_back(m);
    }
    return true;
  };
  std::erase_if(others, [&](const SimultaneousImpact& group) { return is_taken(group.members); });
  std::erase_if(alone, [&](const Pair& pair) { return is_taken({pair.first, pair.second}); });
  for (SimultaneousImpact& group : others) {
    resolutions_.begin();
    resolve_group(group, to_predict, now);
    resolutions_.end();
  }
  for (const auto& [i, partner] : alone) resolve_alone(i, partner, now);
}

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

// Whether an impact is to be resolved with all that touches; nothing, where it waits for the
// impacts of the instant to be over: what has been resolved, and is only pressed together from then
// on.
template <class P>
std::optional<bool> EventLoop<P>::is_joint(Index i, Index partner, At now) {
  const bool ball = moves(partner);
  const bool again = resolutions_.contains(i) || (ball && resolutions_.contains(partner));
  const int hits = std::max(pairs_.hits(i), ball ? pairs_.hits(partner) : 0);
  if (again &&
      (pairs_.is_resolved(i, partner) || hits > kManyAtOnce || !comes_nearer(i, partner, now))) {
    return std::nullopt;
  }
  return again || jam_watch_.level().jammed() || tied(i, partner, now) ||
         (motion_.clusters() && ball && motion_.collapses(disks_[i], disks_[partner], now));
}

// A ball that has been hit at this instant may be sent into several at once, of which its event is
// only one: to be linked whichever that is, all of them wait.
template <class P>
void EventLoop<P>::wait_for_all_that_are_met(At now) {
  const std::size_t known = pairs_.waiting().size();
  const auto add = [&](Index i, Index j) {
    if (has_pair(pairs_.waiting(), i, j) || pairs_.is_resolved(i, j) || !comes_nearer(i, j, now))
      return;
    pairs_.wait(i, j);
  };
  for (std::size_t k = 0; k < known; ++k) {
    const Pair pair = pairs_.waiting()[k];
    for (const Index i : {pair.first, pair.second}) {
      if (!moves(i) || !resolutions_.contains(i)) continue;
      const Disk& disk = disks_[i];
      for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
        if (!motion_.rules().domain.solid((wall - kWalls) / 2)) continue;
        if (motion_.wall_event(disk, wall) <= now) add(i, wall);
      }
      if (!motion_.rules().collisions) continue;
      neighbours_.lists().each(i, [&](Index j) {
        if (prediction_.pair_event(i, j, now) <= now) add(i, j);
      });
    }
  }
}

template <class P>
void EventLoop<P>::resolve_waiting() {
  const auto now = impact_time_;
  if (resolutions_.any()) wait_for_all_that_are_met(now);
  for (const auto& [i, partner] : pairs_.waiting()) {
    pairs_.count_hit(i);
    if (moves(partner)) pairs_.count_hit(partner);
  }
  if (pairs_.waiting().size() == 1) {
    const auto [i, partner] = pairs_.waiting().front();
    const std::optional<bool> joint = is_joint(i, partner, now);
    if (joint && !*joint && !(motion_.contacts_last() && is_hit_of_island(i, partner, now))) {
      pairs_.drop_waiting();
      resolve_alone(i, partner, now);
      predict_changed(now);
      return;
    }
  }
  std::vector<Pair> alone;
  std::vector<Pair> joint;
  std::vector<Index> balls;
  for (const Pair& pair : pairs_.take_waiting()) {
    const std::optional<bool> together = is_joint(pair.first, pair.second, now);
    if (!together) {
      pairs_.press(pair);
      continue;
    }
    (*together ? joint : alone).push_back(pair);
    balls.push_back(pair.first);
    if (moves(pair.second)) balls.push_back(pair.second);
  }
  // What shares a ball is resolved together.
  std::sort(balls.begin(), balls.end());
  const auto shares = [&](Index k) {
    const auto [first, last] = std::equal_range(balls.begin(), balls.end(), k);
    return last - first > 1;
  };
  std::erase_if(alone, [&](const Pair& pair) {
    if (!shares(pair.first) && !(moves(pair.second) && shares(pair.second))) return false;
    joint.push_back(pair);
    return true;
  });
  resolve_together(std::move(alone), joint, now);
  predict_changed(now);
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
