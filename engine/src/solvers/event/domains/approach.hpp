#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "solvers/event/domains/near_lists.hpp"
#include "solvers/event/lanes.hpp"

namespace carom::event {

/// The present flight of a ball carried to the start of the window, as if it had begun there: two
/// of these move straight relative to each other.  Positions count from the middle of the domain.
struct alignas(32) Path {
  double x = 0;
  double y = 0;
  double vx = 0;
  double vy = 0;
};

/// When balls can touch at the earliest: a quick bound that decides for which pairs the exact time
/// is worked out.
///
/// Each pair is taken to touch `slack` before it does.  All roundings, of the carried paths too,
/// are far smaller, so that no pair is missed. Times are seconds (of damped flights: their
/// straightened ones) from the start of the window.
class Approach {
 public:
  /// `periods`: of the axes that wrap; 0 for the others.  `radii`: by slot; null: all are `radius`.
  /// `speed`: a usual one, > 0.
  Approach(const std::array<double, 2>& periods, double radius, const double* radii, double slack,
           double speed)
      : wraps_(periods[0] > 0 || periods[1] > 0),
        period_x_(all(periods[0])),
        period_y_(all(periods[1])),
        per_x_(all(periods[0] > 0 ? 1 / periods[0] : 0)),
        per_y_(all(periods[1] > 0 ? 1 / periods[1] : 0)),
        slack_(slack),
        receding_(all(-slack * speed)),
        waiting_(all(slack / speed)),
        reach_square_(all((2 * radius + slack) * (2 * radius + slack))),
        radii_(radii) {}

  /// One ball as the others see it.
  struct Seer {
    Lanes x, y, vx, vy;
    Lanes radius;  ///< with the slack; unless all are equal
    bool wraps;    ///< the paths of others may be in another image
  };
  /// `by_end`: whether it may, on an axis that wraps.
  [[nodiscard]] Seer seer(const Path& path, Slot ball, bool by_end = true) const {
    return {all(path.x),
            all(path.y),
            all(path.vx),
            all(path.vy),
            all(radii_ == nullptr ? 0 : radii_[ball] + slack_),
            by_end && wraps_};
  }

  // Lanes by reference: by value and not inlined, GCC 12 leaves some on the stack at every turn.
  /// Lower bounds for four others; infinite where they do not meet after `now`, or are not asked
  /// for.
  [[nodiscard, gnu::always_inline]] Lanes bounds(const Seer& me, const Path* paths,
                                                 const Slot* others, const Lanes& now,
                                                 const WholeLanes& asked = all(std::int64_t{
                                                     -1})) const {
    const auto xy = [paths](Slot k) { return TwoLanes{paths[k].x, paths[k].y}; };
    const auto v = [paths](Slot k) { return TwoLanes{paths[k].vx, paths[k].vy}; };
    const Lanes never = all(std::numeric_limits<double>::infinity());
    const Slot a = others[0];
    const Slot b = others[1];
    const Slot c = others[2];
    const Slot d = others[3];
    const auto [x, y] = unzip<Lanes>(xy(a), xy(b), xy(c), xy(d));
    const auto [vx, vy] = unzip<Lanes>(v(a), v(b), v(c), v(d));
    // The way from the other to me, and its velocity as I see it.
    const Lanes ux = vx - me.vx;
    const Lanes uy = vy - me.vy;
    Lanes dx = me.x - x;
    Lanes dy = me.y - y;
    if (me.wraps) {
      // The image that is near now: they may have gone round since the start of the window.
      dx = fused(-period_x_, whole(fused(-ux, now, dx) * per_x_), dx);
      dy = fused(-period_y_, whole(fused(-uy, now, dy) * per_y_), dy);
    }
    Lanes reach_square = reach_square_;
    if (radii_ != nullptr) {
      const Lanes reach = me.radius + Lanes{radii_[a], radii_[b], radii_[c], radii_[d]};
      reach_square = reach * reach;
    }
    const Lanes along = fused(dx, ux, dy * uy);
    const Lanes square = fused(ux, ux, uy * uy);
    const Lanes gap = fused(dx, dx, fused(dy, dy, -reach_square));
    const Lanes discriminant = fused(along, along, -(square * gap));
    // The quotient does not wait for the root; no number where they pass each other by.
    const Lanes time = (along - square_root(discriminant)) * (all(1.0) / square);
    // They still come nearer, or all but: along - square now > -slack |u|.  Instead of |u|, as a
    // sum of the axes, is taken s + u^2 / s, which is larger for any s.
    const WholeLanes nearer = fused(-square, now - waiting_, along) > receding_;
    return lesser(choose(nearer & asked, time, never), never);
  }

  /// The least of the bounds of many, whose it is, and the least of the others.
  struct Earliest {
    double first;
    double second;
    Slot ball;
  };
  /// Of `count` others; behind the last, up to the next multiple of eight, are balls, too.
  [[nodiscard, gnu::always_inline]] Earliest earliest(const Seer& me, const Path* paths,
                                                      const Slot* others, std::uint32_t count,
                                                      const Lanes& now) const {
    // Two groups at once: mostly they are all there are.
    const std::int64_t* const asked = kAsked + kBothGroups - std::min(count, kBothGroups);
    const Lanes early = bounds(me, paths, others, now, four(asked));
    const Lanes late = bounds(me, paths, others + kLanes, now, four(asked + kLanes));
    Lanes first = lesser(late, early);
    Lanes second = greater(late, early);
    const WholeLanes is_late = late < early;
    if (count <= kBothGroups) {
      const double least_time = least(first);
      const std::uint32_t lane = lane_of(first, least_time);
      const std::uint32_t at = lane + kLanes * (which(is_late) >> lane & 1U);
      return {least_time, least_but(lane, first, second), others[at]};
    }
    const Lanes numbers{0, 1, 2, 3};
    WholeLanes groups = is_late ? all(std::int64_t{kLanes}) : WholeLanes{};
    for (std::uint32_t k = kBothGroups; k < count; k += kLanes) {
      const Lanes time = bounds(me, paths, others + k, now,
                                numbers + static_cast<double>(k) < all(static_cast<double>(count)));
      second = lesser(second, greater(first, time));
      groups = time < first ? all(std::int64_t{k}) : groups;
      first = lesser(time, first);
    }
    const double least_time = least(first);
    const std::uint32_t lane = lane_of(first, least_time);
    alignas(32) std::int64_t group_of_lane[kLanes];
    std::memcpy(group_of_lane, &groups, sizeof groups);
    return {least_time, least_but(lane, first, second),
            others[static_cast<std::uint32_t>(group_of_lane[lane]) + lane]};
  }

 private:
  static constexpr std::uint32_t kBothGroups = 2 * kLanes;
  /// From kBothGroups - n on, for n others of kBothGroups: which of them there are.
  alignas(64) static constexpr std::int64_t kAsked[2 * kBothGroups] = {-1, -1, -1, -1,
                                                                       -1, -1, -1, -1};
  [[gnu::always_inline]] static WholeLanes four(const std::int64_t* from) {
    WholeLanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  /// The least of `first`, but for one lane, and of `second` in that lane.
  [[gnu::always_inline]] static double least_but(std::uint32_t lane, const Lanes& first,
                                                 const Lanes& second) {
    const Lanes rest = Lanes{0, 1, 2, 3} == all(static_cast<double>(lane)) ? second : first;
    return least(lesser(rest, second));
  }
  [[gnu::always_inline]] static Lanes whole(Lanes a) {
#if defined(__AVX__) && defined(__FMA__)
    return _mm256_round_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
#else
    return Lanes{std::rint(a[0]), std::rint(a[1]), std::rint(a[2]), std::rint(a[3])};
#endif
  }

  bool wraps_;
  Lanes period_x_;
  Lanes period_y_;
  Lanes per_x_;
  Lanes per_y_;
  double slack_;
  Lanes receding_;      ///< slack times a usual speed, negative,
  Lanes waiting_;       ///< and how long that speed takes for it
  Lanes reach_square_;  ///< where all radii are equal
  const double* radii_;
};

}  // namespace carom::event
