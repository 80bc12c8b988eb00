#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "solvers/event/disk.hpp"

namespace carom::event {

/// A pair whose paths meet, or of which one is in a contact that lasts.  The first can move.
struct Encounter {
  Index first;
  Index second;
  bool lasts = false;  ///< the second of these
};

/// Which balls are of one conflict group in a window.
///
/// Balls that touch at the start of a window are a cluster, which is in one group or not at all: a
/// group has all balls of the clusters that its members are of.  Fixed balls are of every group
/// that comes to them, and join no groups.
///
/// Holds: the groups do not depend on the order of the pairs.
class ConflictSets {
 public:
  struct Group {
    Index root;  ///< its first ball
    std::size_t size;
    bool lasting;  ///< a contact that lasts has brought it together
  };

  /// So many balls; fixed ones are not 0.  They must outlive this.
  void reset(const std::vector<char>& fixed);
  /// Each ball is alone.
  void begin_window();
  /// Pairs that touch at the start of the window.
  void touch(std::span<const Encounter> pairs);
  /// Begins a pass over the pairs.
  void begin_pass() { met_.clear(); }
  /// Pairs that have met in this pass and are of two groups: joins them.
  void meet(std::span<const Encounter> pairs);
  /// The groups of all that has met in this pass, the largest first.
  [[nodiscard]] const std::vector<Group>& joined();
  /// After a window, for every ball that was solved.
  void forget(Index ball);

  /// The second may be fixed.  Any number of threads may ask at once.
  [[nodiscard]] bool together(Index i, Index j) const {
    const Index group = sets_.look_up(i);
    if ((*fixed_)[j] == 0) return group == sets_.look_up(j);
    const std::vector<Index>& fixed = fixed_of_[group];
    return std::find(fixed.begin(), fixed.end(), j) != fixed.end();
  }
  /// The balls of a group that move.
  template <class Visit>
  void each(Index root, Visit visit) const {
    sets_.each(root, visit);
  }
  /// Its fixed balls, each once, since the last `joined`.
  [[nodiscard]] const std::vector<Index>& fixed_of(Index root) const { return fixed_of_[root]; }

 private:
  void join(Index i, Index j);
  void close(Index ball);
  void add(Index root);

  const std::vector<char>* fixed_ = nullptr;
  DisjointSets sets_;
  DisjointSets clusters_;
  std::vector<Encounter> supports_;           // balls and the fixed balls they touch, in order
  std::vector<std::vector<Index>> fixed_of_;  // by root
  std::vector<char> lasting_;  // by ball: it is in a contact that lasts, with another one
  std::vector<Index> met_;     // in this pass
  std::vector<Group> joined_;
  std::vector<char> closed_;    // by root, in `joined`: the group has all of its clusters
  std::vector<Index> roots_;    // of these
  std::vector<Index> closing_;  // the balls of the group that is closed
};

}  // namespace carom::event
