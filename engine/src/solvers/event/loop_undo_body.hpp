#pragma once

#include <algorithm>
#include <vector>

#include "solvers/event/event_loop.hpp"

namespace carom::event {

// The undo log of an instant: what is resolved alone, and then found to share a ball with more, is
// taken back, and nothing else.

template <class P>
void EventLoop<P>::begin_simultaneous() {
  for (const Past& past : past_) resolution_of_[past.ball] = -1;
  past_.clear();
  resolutions_.clear();
  for (const Index i : hit_) hits_[i] = 0;
  hit_.clear();
  linked_.clear();
  resolved_.clear();
  book_.begin_simultaneous();
  keep_slides();
}

template <class P>
void EventLoop<P>::begin_resolution() {
  const std::size_t lines = log_ != nullptr ? log_->impacts.size() : 0;
  const std::size_t number = resolutions_.size();
  resolution_sets_.make_room(number + 1);
  resolution_sets_.isolate(static_cast<std::uint32_t>(number));
  resolutions_.push_back({counts_, book_.kept(), lines, {}, 0, 0});
}

template <class P>
void EventLoop<P>::end_resolution() {
  Resolution& last = resolutions_.back();
  last.counts_after = counts_;
  last.kept_after = book_.kept();
  last.log_after = log_ != nullptr ? log_->impacts.size() : 0;
}

template <class P>
void EventLoop<P>::remember(Index i) {
  if (motion_.fixed(disks_[i])) return;
  const auto present = static_cast<std::uint32_t>(resolutions_.size() - 1);
  if (is_past(i)) {
    resolution_sets_.merge(static_cast<std::uint32_t>(resolution_of_[i]), present);
    return;
  }
  resolution_of_[i] = static_cast<int>(present);
  past_.push_back({i, disks_[i], spins_.empty() ? S(0) : spins_[i], left(i)});
}

template <class P>
void EventLoop<P>::take_back(const Resolution& resolution) {
  const Counts& from = resolution.counts;
  const Counts& to = resolution.counts_after;
  counts_.ball_ball -= to.ball_ball - from.ball_ball;
  counts_.ball_wall -= to.ball_wall - from.ball_wall;
  counts_.joint_impacts -= to.joint_impacts - from.joint_impacts;
  counts_.jammed -= to.jammed - from.jammed;
  counts_.resting_contacts -= to.resting_contacts - from.resting_contacts;
  counts_.wakes -= to.wakes - from.wakes;
  book_.take_back(resolution.kept, resolution.kept_after);
  const std::size_t lines = resolution.log_after - resolution.log;
  if (lines == 0) return;
  const auto at = log_->impacts.begin() + static_cast<std::ptrdiff_t>(resolution.log);
  const auto next = log_->impacts.erase(at, at + static_cast<std::ptrdiff_t>(lines));
  // A joint impact is numbered as its first line.
  for (auto line = next; line != log_->impacts.end(); ++line) {
    if (line->event != 0) line->event -= lines;
  }
  for (Resolution& other : resolutions_) {
    if (other.log <= resolution.log) continue;
    other.log -= lines;
    other.log_after -= lines;
  }
}

template <class P>
void EventLoop<P>::take_back(std::vector<Index>& balls) {
  std::vector<char> undone(resolutions_.size(), 0);
  for (const Index k : balls) {
    if (is_past(k)) undone[set_of(k)] = 1;
  }
  const auto add = [&balls](Index k) {
    if (std::find(balls.begin(), balls.end(), k) == balls.end()) balls.push_back(k);
  };
  const auto is_undone = [&](Index k) { return moves(k) && is_past(k) && undone[set_of(k)] != 0; };
  const auto concerns = [&](const Pair& pair) {
    return is_undone(pair.first) || is_undone(pair.second);
  };
  std::erase_if(resolved_, concerns);
  std::erase_if(pressed_, [&](const Pair& pair) {
    if (!concerns(pair)) return false;
    for (const Index k : {pair.first, pair.second}) {
      if (moves(k)) add(k);
    }
    return true;
  });
  std::vector<char> whole(resolutions_.size(), 0);
  for (std::size_t k = 0; k < resolutions_.size(); ++k) {
    whole[k] = undone[resolution_sets_.find(static_cast<std::uint32_t>(k))];
  }
  for (const Past& past : past_) {
    const Index k = past.ball;
    if (!is_undone(k)) continue;
    add(k);
    unlink(k);
    const Time leaves = disks_[k].leaves;
    disks_[k] = past.disk;
    disks_[k].leaves = leaves;
    if (!spins_.empty()) spins_[k] = past.spin;
    if (!left_.empty()) left_[k] = past.left;
    forget(k);
  }
  std::erase_if(past_, [&](const Past& past) { return is_undone(past.ball); });
  for (const Index k : balls) {
    if (is_undone(k)) resolution_of_[k] = -1;
  }
  for (std::size_t k = resolutions_.size(); k-- > 0;) {
    if (whole[k] == 0) continue;
    take_back(resolutions_[k]);
    Resolution& taken = resolutions_[k];
    taken.counts_after = taken.counts;
    taken.kept_after = taken.kept;
    taken.log_after = taken.log;
  }
}

}  // namespace carom::event
