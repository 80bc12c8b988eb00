#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "solvers/event/disk.hpp"
#include "solvers/event/flight_lanes.hpp"
#include "solvers/event/lanes.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/pair_lanes.hpp"

namespace carom::event {

/// Which of several flying balls one of them meets first, four looked at side by side.
///
/// Holds: the same bits as Motion::pair_event, one after the other.
template <class P>
class LaneSearch {
 public:
  using Disk = typename P::Disk;

  /// Of the flights `disks`, by ball; both must outlive this.
  LaneSearch(const Motion<P>& motion, const Disk* disks) : motion_(motion), disks_(disks) {}

  /// Puts into `best` what ball i meets before it; a meeting in the past is now.  `note_tie(at, i,
  /// other)` is told of what is at the same time as another one; other: i, where it is not known
  /// which of several.
  /// REQUIRES: all of them fly, by the law of motion.
  template <class NoteTie>
  void find(Index i, const Index* others, std::uint32_t count, FixedTime now, Meeting<P>& best,
            const NoteTie& note_tie) const {
    if constexpr (std::is_same_v<typename P::Law, BallisticLaw<double>>) {
      if (!motion_.bends()) {
        find_by(StraightLaw<double>{}, i, others, count, now, best, note_tie);
        return;
      }
    }
    // What the loop does not change, out of the reach of what it calls.
    find_by(typename P::Law(motion_.law()), i, others, count, now, best, note_tie);
  }

 private:
  template <class Law, class NoteTie>
  void find_by(const Law& law, Index i, const Index* others, std::uint32_t count, FixedTime now,
               Meeting<P>& best, const NoteTie& note_tie) const;

  const Motion<P>& motion_;
  const Disk* disks_;
};

template <class P>
template <class Law, class NoteTie>
void LaneSearch<P>::find_by(const Law& law, Index i, const Index* others, std::uint32_t count,
                            FixedTime now, Meeting<P>& best, const NoteTie& note_tie) const {
  const Disk& me = disks_[i];
  const auto place_of = [](const Disk& disk) { return TwoLanes{disk.x, disk.y}; };
  const auto velocity_of = [](const Disk& disk) { return TwoLanes{disk.vx, disk.vy}; };
  const auto times_of = [](const Disk& disk) { return WholeTwoLanes{disk.start, disk.meets}; };
  const auto radius_of = [&](const Disk* disk) { return motion_.species(*disk).radius; };
  const Lanes zero{};
  const WholeLanes never = all(kNever);
  const Lanes longest = all(static_cast<double>(kLongestFlight));
  const double tick = motion_.rules().scale.tick();
  const double per_second = motion_.rules().scale.per_second();
  const bool wraps = motion_.box().periodic(0) || motion_.box().periodic(1);
  const Lanes period_x = all(motion_.periods()[0]);
  const Lanes period_y = all(motion_.periods()[1]);
  const Lanes half_x = period_x / 2;
  const Lanes half_y = period_y / 2;
  const double my_radius = radius_of(&me);
  const Vec<double> my_place{me.x, me.y};
  const Vec<double> my_velocity{me.vx, me.vy};
  const WholeLanes my_start = all(me.start);
  // Each lane keeps the first it sees: which of them is first of all cannot be foreseen.
  WholeLanes soonest = all(best.time);
  WholeLanes partners = all(std::int64_t{kUnknown});
  for (std::uint32_t from = 0; from < count; from += kLanes) {
    // A lane without a ball holds the ball itself, which it does not approach.
    Index ball[kLanes];
    const Disk* disk[kLanes];
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      const Index other = others[std::min(from + l, count - 1)];
      ball[l] = from + l < count ? other : i;
      disk[l] = &disks_[ball[l]];
    }
    const auto [x, y] = unzip<Lanes>(place_of(*disk[0]), place_of(*disk[1]), place_of(*disk[2]),
                                     place_of(*disk[3]));
    const auto [vx, vy] = unzip<Lanes>(velocity_of(*disk[0]), velocity_of(*disk[1]),
                                       velocity_of(*disk[2]), velocity_of(*disk[3]));
    const auto [start, meets] = unzip<WholeLanes>(times_of(*disk[0]), times_of(*disk[1]),
                                                  times_of(*disk[2]), times_of(*disk[3]));

    // Both as they are at the later of the two starts: only the earlier flight has moved by then.
    const WholeLanes later = start > my_start ? start : my_start;
    const Lanes since = __builtin_convertvector(my_start - start, Lanes) * tick;
    RelativeLanes r = relative(law, {x, y, vx, vy, my_place, my_velocity, since});
    if (wraps) {
      r.dx = nearest(r.dx, period_x, half_x);
      r.dy = nearest(r.dy, period_y, half_y);
    }
    Lanes reach = all(2 * my_radius);
    if (!motion_.one_species()) {
      reach = my_radius +
              Lanes{radius_of(disk[0]), radius_of(disk[1]), radius_of(disk[2]), radius_of(disk[3])};
    }
    Lanes wait = pair_times(r.dx, r.dy, r.dvx, r.dvy, reach);
    if constexpr (Law::kStretches) {
      // What is too late without it need not be known.
      const Lanes straight = wait * per_second * (1 - 0x1p-30);
      const WholeLanes early =
          later + __builtin_convertvector(straight < longest ? straight : zero, WholeLanes);
      const WholeLanes wanted =
          (straight < longest) & (early <= meets) & (early <= all(least(soonest)));
      if (!any(wanted)) continue;
      wait = when(law, wait, wanted);
    }
    wait *= per_second;
    WholeLanes at = later + __builtin_convertvector(wait < longest ? wait : zero, WholeLanes);
    at = at > now ? at : all(now);
    at = wait < longest ? at : never;
    const WholeLanes free = at < meets;
    const WholeLanes tie = ((at == meets) | (free & (at == soonest))) & (at < never);
    if (any(tie)) {
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        if (tie[l] != 0 && (free[l] != 0 || disk[l]->partner != i)) note_tie(at[l], i, ball[l]);
      }
    }
    const WholeLanes sooner = free & (at < soonest);
    soonest = sooner ? at : soonest;
    partners = sooner ? WholeLanes{ball[0], ball[1], ball[2], ball[3]} : partners;
  }
  const std::int64_t first = least(soonest);
  std::int64_t partner = partners[0];
  for (std::uint32_t l = 1; l < kLanes; ++l) partner = soonest[l] == first ? partners[l] : partner;
  const bool found = first < best.time;
  const WholeLanes firsts = (soonest == all(first)) & all(std::int64_t{found ? -1 : 0});
  if (several(firsts)) note_tie(first, i, i);
  best.time = found ? first : best.time;
  best.partner = found ? static_cast<Index>(partner) : best.partner;
}

}  // namespace carom::event
