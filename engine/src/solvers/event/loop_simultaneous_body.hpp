#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "solvers/event/event_loop.hpp"

namespace carom::event {

// Impacts of one instant in their order: alone, with all that touches, with an island; at its end
// those that are pressed together come to rest.

template <class P>
bool EventLoop<P>::is_late(Index i, At now) {
  if (motion_.fixed(disks_[i]) || resolutions_.contains(i)) return false;
  const Disk& me = disks_[i];
  for (const typename FlightsBefore<P>::Before& before : before_.all()) {
    const Disk& other = before.disk;
    const bool meets =
        motion_.pair_event(me, other, false, now) <= now && motion_.rules().collisions;
    if (!meets) continue;
    schedule_.forget(i);
    pairs_.wait(i, before.ball);
    return true;
  }
  return false;
}

template <class P>
void EventLoop<P>::resolve_waiting() {
  const auto now = impact_time_;
  if (resolutions_.any()) choice_.add_all_met(now);
  for (const auto& [i, partner] : pairs_.waiting()) {
    pairs_.count_hit(i);
    if (moves(partner)) pairs_.count_hit(partner);
  }
  if (pairs_.waiting().size() == 1) {
    const auto [i, partner] = pairs_.waiting().front();
    if (choice_.way_of(i, partner, now) == SimultaneousChoice<P>::Way::alone &&
        !(motion_.contacts_last() && is_hit_of_island(i, partner, now))) {
      pairs_.drop_waiting();
      resolve_alone(i, partner, now);
      predict_changed(now);
      return;
    }
  }
  auto [alone, together] = choice_.take_waiting(now);
  resolve_together(std::move(alone), together, now);
  predict_changed(now);
}

// The groups of balls that touch, from these on. What has been resolved at this instant, and now
// shares a ball with more, is taken back: its balls are looked for, too.
template <class P>
auto EventLoop<P>::groups_of(std::vector<Index>& to_predict, At now)
    -> std::vector<SimultaneousImpact> {
  for (;;) {
    std::vector<Index> seeds = to_predict;
    std::vector<SimultaneousImpact> groups;
    std::vector<Index> past;
    while (!seeds.empty()) {
      groups.push_back(touch_search_.from(seeds, now));
      const std::vector<Index>& members = groups.back().members;
      std::copy_if(members.begin(), members.end(), std::back_inserter(past),
                   [this](Index m) { return resolutions_.contains(m); });
    }
    if (past.empty()) return groups;
    take_back(past);
    for (const Index k : past) {
      if (std::find(to_predict.begin(), to_predict.end(), k) == to_predict.end()) {
        to_predict.push_back(k);
      }
    }
  }
}

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
  hit_islands(islands, now);
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

// What touches these would hit their island at once, and take it back, for ever.
template <class P>
std::vector<Index> EventLoop<P>::with_all_that_touches(std::vector<Index> balls, At now) const {
  std::vector<Index> all;
  while (!balls.empty()) {
    for (const Index m : touch_search_.from(balls, now).members) {
      if (!motion_.fixed(disks_[m])) all.push_back(m);
    }
  }
  return all;
}

// Those that share a ball become one island; what lies straight on a fixed ball, or is of none, is
// looked at alone.
template <class P>
void EventLoop<P>::settle_pressed() {
  const auto now = impact_time_;
  std::vector<std::vector<Index>> islands;
  std::vector<std::vector<Pair>> others;
  const auto is_moving = [this](Index partner) { return moves(partner); };
  for (PairGroup& group : groups_that_share(pairs_.take_pressed(), is_moving)) {
    const auto hits = [&](const Pair& pair) {
      return is_hit_of_island(pair.first, pair.second, now);
    };
    if (motion_.contacts_last() && std::any_of(group.pairs.begin(), group.pairs.end(), hits)) {
      islands.push_back(motion_.rules().restitution < 1
                            ? with_all_that_touches(std::move(group.balls), now)
                            : std::move(group.balls));
    } else {
      others.push_back(std::move(group.pairs));
    }
  }
  hit_islands(islands, now);
  for (const auto& pairs : others) {
    resolutions_.begin();
    for (const auto& [i, partner] : pairs) {
      remember(i);
      if (moves(partner)) remember(partner);
      meet_alone(i, partner, now);
      book_.keep();
    }
    resolutions_.end();
    for (const auto& [i, partner] : pairs) {
      if (moves(partner)) changed_.push_back(partner);
      changed_.push_back(i);
    }
  }
  predict_changed(now);
}

}  // namespace carom::event
