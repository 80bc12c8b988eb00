#pragma once

#include "solvers/event/flight_lanes.hpp"
#include "solvers/event/pair_lanes.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::look_in_lanes(Index i, const Index* others, std::uint32_t count, At now,
                            Meeting<P>& best) const requires kIsDouble<S> {
  const Disk& me = disks_[i];
  const auto row_of = [](const Disk& disk) { return Lanes{disk.x, disk.y, disk.vx, disk.vy}; };
  const auto radius_of = [&](const Disk* disk) { return motion_.kind(*disk).radius; };
  // What the loop does not change, out of the reach of what it calls.
  const typename P::Law law = motion_.law();
  const Lanes zero{};
  const WholeLanes never = all(kNever);
  const Lanes longest = all(static_cast<double>(kLongestFlight));
  const double tick = motion_.rules().scale.tick();
  const double per_second = motion_.rules().scale.per_second();
  const bool wraps = motion_.room().periodic(0) || motion_.room().periodic(1);
  const Lanes period_x = all(motion_.periods()[0]);
  const Lanes period_y = all(motion_.periods()[1]);
  const Lanes half_x = period_x / 2;
  const Lanes half_y = period_y / 2;
  const double my_radius = radius_of(&me);
  const Vec<double> my_place{me.x, me.y};
  const Vec<double> my_velocity{me.vx, me.vy};
  const WholeLanes my_start = all(me.start);
  for (std::uint32_t from = 0; from < count; from += kLanes) {
    // A lane without a ball holds the ball itself, which it does not approach.
    const Disk* disk[kLanes];
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      disk[l] = &disks_[from + l < count ? others[from + l] : i];
    }
    Lanes x = row_of(*disk[0]);
    Lanes y = row_of(*disk[1]);
    Lanes vx = row_of(*disk[2]);
    Lanes vy = row_of(*disk[3]);
    transpose(x, y, vx, vy);
    const WholeLanes start{disk[0]->start, disk[1]->start, disk[2]->start, disk[3]->start};
    const WholeLanes meets{disk[0]->meets, disk[1]->meets, disk[2]->meets, disk[3]->meets};

    // Both as they are at the later of the two starts: only the earlier flight has moved by then.
    const WholeLanes later = start > my_start ? start : my_start;
    const Lanes since = __builtin_convertvector(my_start - start, Lanes) * tick;
    RelativeLanes r = relative(law, {x, y, vx, vy, my_place, my_velocity, since});
    if (wraps) {
      r.dx = nearest(r.dx, period_x, half_x);
      r.dy = nearest(r.dy, period_y, half_y);
    }
    Lanes reach = all(2 * my_radius);
    if (!motion_.one_kind()) {
      reach = my_radius +
              Lanes{radius_of(disk[0]), radius_of(disk[1]), radius_of(disk[2]), radius_of(disk[3])};
    }
    Lanes wait = pair_times(r.dx, r.dy, r.dvx, r.dvy, reach);
    if constexpr (P::Law::kStretches) {
      // What is too late without it need not be known.
      const Lanes least = wait * per_second * (1 - 0x1p-30);
      const WholeLanes early =
          later + __builtin_convertvector(least < longest ? least : zero, WholeLanes);
      const WholeLanes wanted = (least < longest) & (early <= meets) & (early <= all(best.time));
      if (!any(wanted)) continue;
      wait = when(law, wait, wanted);
    }
    wait *= per_second;
    WholeLanes at = later + __builtin_convertvector(wait < longest ? wait : zero, WholeLanes);
    at = at > now ? at : all(now);
    at = wait < longest ? at : never;
    const WholeLanes tie = (at == meets) & (at < never);
    if (any(tie)) {
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        if (tie[l] != 0 && disk[l]->partner != i) note_tie(at[l]);
      }
    }
    at = at < meets ? at : never;
    if (!any((at <= all(best.time)) & (at < never))) continue;
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      if (at[l] > best.time) continue;
      if (at[l] < best.time) {
        best = {at[l], others[from + l]};
      } else if (at[l] != kNever) {
        note_tie(at[l]);
      }
    }
  }
}

}  // namespace carom::event
