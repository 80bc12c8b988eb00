#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/event/event_loop.hpp"

namespace carom::event {

// Impacts of one instant: which wait, which are resolved alone, and which with all that touches.

template <class P>
bool EventLoop<P>::tied(Index i, Index partner, At now) {
  if (!ties_.any(now, i, partner)) return false;
  // A tie may be of what was known of a ball before: whether it was noted depends on what was
  // looked at when.
  const bool ball = partner < kFirstMark && !motion_.fixed(disks_[partner]);
  return meets_another(i, partner, now) || (ball && meets_another(partner, i, now));
}

template <class P>
bool EventLoop<P>::meets_another(Index i, Index partner, At now) const {
  bool meets = false;
  prediction_.each_met(i, now, [&](Index other) { meets = meets || other != partner; });
  return meets;
}

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
      prediction_.each_met(i, now, [&](Index partner) { add(i, partner); });
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

}  // namespace carom::event
