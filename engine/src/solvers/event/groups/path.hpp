#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solvers/event/disk.hpp"

namespace carom::event {

/// One flight of a path, the fixed ball at which it began, kUnknown where there is none, and the
/// spin that it has, 0 where balls have no friction.
template <class P>
struct Segment {
  typename P::Disk flight;
  Index left = kUnknown;
  typename P::Scalar spin = 0;
};

/// The flights of some balls, each ball's in the order of time.
///
/// Holds: starts ascend within a path; the first flight may have begun long ago; one that
/// begins at the same moment comes after it.
template <class P>
class Paths {
 public:
  using Path = std::vector<Segment<P>>;

  /// One path for each flight, which it begins with.
  void reset(const std::vector<Segment<P>>& first) {
    if (paths_.size() < first.size()) paths_.resize(first.size());
    for (std::size_t i = 0; i < first.size(); ++i) paths_[i].assign(1, first[i]);
  }
  /// The ball's present flight; flights that a later decision has replaced are dropped.
  void note(Index i, const Segment<P>& segment) {
    Path& path = paths_[i];
    while (path.size() > 1 && !(path.back().flight.start < segment.flight.start)) path.pop_back();
    if (path.size() == 1 && same(path.front(), segment)) return;
    path.push_back(segment);
  }
  [[nodiscard]] const Path& operator[](std::size_t i) const { return paths_[i]; }

 private:
  static bool same(const Segment<P>& one, const Segment<P>& other) {
    const typename P::Disk& a = one.flight;
    const typename P::Disk& b = other.flight;
    return a.start == b.start && a.x == b.x && a.y == b.y && a.vx == b.vx && a.vy == b.vy &&
           a.species == b.species && one.left == other.left && one.spin == other.spin;
  }

  std::vector<Path> paths_;
};

}  // namespace carom::event
