#pragma once

#include <algorithm>
#include <cstddef>

#include "contact/rest_rules.hpp"
#include "solvers/event/groups/path.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// Balls of a contact that lasts may be so much farther apart than those that touch.
inline constexpr double kWidest = 1 + 2 * kAhead;

/// Whether the paths of two balls meet in a window.
template <class P>
class PathMeeting {
 public:
  using Path = typename Paths<P>::Path;
  using Disk = typename P::Disk;
  using Time = typename P::Time;
  using At = typename P::At;

  struct Ball {
    Index number;
    bool fixed;
    const Path& path;
  };

  /// `until`: the end of the window.
  PathMeeting(const Motion<P>& motion, At until) : motion_(motion), until_(until) {}

  /// Whether the two paths meet, or touch where one of them has an impact.
  [[nodiscard]] bool meet(const Ball& one, const Ball& other) const {
    const Path& first = one.path;
    const Path& second = other.path;
    std::size_t a = 0;
    std::size_t b = 0;
    for (;;) {
      const Segment<P>& here = first[a];
      const Segment<P>& there = second[b];
      const Time& here_ends = end_of(first, a);
      const Time& there_ends = end_of(second, b);
      const Time& end = std::min(here_ends, there_ends);
      const bool from_contact = other.fixed && here.left == other.number;
      if (motion_.pair_event(here.flight, there.flight, from_contact, end) <= end) return true;
      const bool more = a + 1 < first.size() || b + 1 < second.size();
      if (!more) return false;
      if (touch(one, here.flight, other, there.flight, end)) return true;
      // Both where they end at once, so that what begins then is held against what begins then.
      const bool next_a = a + 1 < first.size() && !(end < here_ends);
      const bool next_b = b + 1 < second.size() && !(end < there_ends);
      if (next_a) ++a;
      if (next_b) ++b;
      if (!next_a && !next_b) return false;
    }
  }

  /// Whether the two touch at the start of the window: a third ball that meets one of them then has
  /// to do with the other.
  [[nodiscard]] bool touch_at_start(const Ball& one, const Ball& other, At start) const {
    return touch(one, one.path.front().flight, other, other.path.front().flight, start);
  }

  /// Whether one is of an island and the other moves: balls of an island that moves, or is hit, are
  /// looked at with all that are near to them.
  [[nodiscard]] bool lasts(const Ball& one, const Ball& other) const {
    if (!motion_.contacts_last()) return false;
    return (in_island(one) || in_island(other)) && (moves(one) || moves(other));
  }

 private:
  [[nodiscard]] const Time& end_of(const Path& path, std::size_t k) const {
    return k + 1 < path.size() ? path[k + 1].flight.start : until_;
  }

  [[nodiscard]] bool touch(const Ball& one, const Disk& a, const Ball& other, const Disk& b,
                           At at) const {
    using S = typename P::Scalar;
    const S reach = motion_.species(a).radius + motion_.species(b).radius;
    double part = kTouching;
    if (motion_.contacts_last()) {
      const auto in_island = [this](const Ball& ball, const Disk& disk) {
        return !ball.fixed && motion_.in_island(disk);
      };
      if (in_island(one, a) || in_island(other, b)) part = kNear;
    }
    return near(motion_.way(motion_.place(a, at), motion_.place(b, at)), reach, S(part));
  }

  [[nodiscard]] bool in_island(const Ball& ball) const {
    return !ball.fixed && std::any_of(ball.path.begin(), ball.path.end(), [this](const auto& part) {
      return motion_.in_island(part.flight);
    });
  }

  [[nodiscard]] bool moves(const Ball& ball) const {
    return !ball.fixed &&
           (ball.path.size() > 1 || motion_.support(ball.path.front().flight) >= kStepped);
  }

  const Motion<P>& motion_;
  const Time until_;
};

}  // namespace carom::event
