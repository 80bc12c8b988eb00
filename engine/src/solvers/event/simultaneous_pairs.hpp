#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "solvers/event/disk.hpp"

namespace carom::event {

/// A ball, and what it meets: a ball or a wall.
using Pair = std::pair<Index, Index>;

/// Whether the two are among them, in either order.
[[nodiscard]] bool has_pair(const std::vector<Pair>& pairs, Index i, Index j);

/// Impacts that share balls, and the balls of them that move.
struct PairGroup {
  std::vector<Pair> pairs;
  std::vector<Index> balls;
};
/// `moves(ball)`: whether it can be shared; walls and fixed balls are not.
template <class Moves>
std::vector<PairGroup> groups_that_share(std::vector<Pair> left, const Moves& moves) {
  std::vector<PairGroup> groups;
  while (!left.empty()) {
    PairGroup& group = groups.emplace_back();
    group.pairs.push_back(left.back());
    left.pop_back();
    for (std::size_t k = 0; k < group.pairs.size(); ++k) {
      for (const Index ball : {group.pairs[k].first, group.pairs[k].second}) {
        if (!moves(ball) ||
            std::find(group.balls.begin(), group.balls.end(), ball) != group.balls.end()) {
          continue;
        }
        group.balls.push_back(ball);
        std::erase_if(left, [&](const Pair& pair) {
          const bool shares = pair.first == ball || pair.second == ball;
          if (shares) group.pairs.push_back(pair);
          return shares;
        });
      }
    }
  }
  return groups;
}

/// The impacts of one instant, from when they are due to when they are over.
///
/// An impact waits until all of the instant are known.  Then it is resolved: alone, or with all
/// that touches, and what is passed on by those that were is linked to them.  What comes up again,
/// and would change nothing, is pressed together, and comes to rest at the end of the instant.
///
/// Holds: no pair is linked twice.
class SimultaneousPairs {
 public:
  /// Forgets all; there are `balls` balls.
  void reset(std::size_t balls);
  /// What waits or is pressed together stays; the rest was of an instant that is over, or is to be
  /// resolved again.
  void forget_resolved() {
    linked_.clear();
    resolved_.clear();
    for (const Index i : hit_) hits_[i] = 0;
    hit_.clear();
  }

  /// Counts an impact of the ball.
  void count_hit(Index i) {
    if (hits_[i]++ == 0) hit_.push_back(i);
  }
  [[nodiscard]] int hits(Index i) const { return hits_[i]; }

  void wait(Index i, Index partner) { waiting_.emplace_back(i, partner); }
  [[nodiscard]] const std::vector<Pair>& waiting() const { return waiting_; }
  [[nodiscard]] std::vector<Pair> take_waiting() { return std::exchange(waiting_, {}); }
  void drop_waiting() { waiting_.clear(); }

  void link(const Pair& pair) {
    if (!is_linked(pair.first, pair.second)) linked_.push_back(pair);
  }
  [[nodiscard]] const std::vector<Pair>& linked() const { return linked_; }
  /// Only the first `count` pairs were linked.
  void drop_links(std::size_t count) { linked_.resize(count); }
  [[nodiscard]] bool is_linked(Index i, Index j) const { return has_pair(linked_, i, j); }

  /// A contact of a joint impact.
  void note_resolved(Index i, Index partner) { resolved_.emplace_back(i, partner); }
  /// Whether this contact was one of those resolved together: to resolve them again would change
  /// nothing.
  [[nodiscard]] bool is_resolved(Index i, Index j) const {
    return is_linked(i, j) || has_pair(resolved_, i, j);
  }

  void press(const Pair& pair) { pressed_.push_back(pair); }
  [[nodiscard]] bool any_pressed() const { return !pressed_.empty(); }
  [[nodiscard]] std::vector<Pair> take_pressed() { return std::exchange(pressed_, {}); }

  /// Forgets what was resolved or pressed together with balls for which `undone(ball)` holds; gives
  /// the pairs that were pressed together.
  template <class Undone>
  std::vector<Pair> take_back(const Undone& undone) {
    const auto concerns = [&](const Pair& pair) {
      return undone(pair.first) || undone(pair.second);
    };
    std::vector<Pair> released;
    std::erase_if(resolved_, concerns);
    std::erase_if(pressed_, [&](const Pair& pair) {
      if (!concerns(pair)) return false;
      released.push_back(pair);
      return true;
    });
    return released;
  }

 private:
  std::vector<Pair> waiting_;   ///< to be resolved
  std::vector<Pair> linked_;    ///< what met, passed on or not
  std::vector<Pair> resolved_;  ///< contacts of the joint impacts
  std::vector<Pair> pressed_;   ///< to come to rest
  std::vector<int> hits_;       ///< impacts by ball
  std::vector<Index> hit_;      ///< balls of which there are any
};

}  // namespace carom::event
