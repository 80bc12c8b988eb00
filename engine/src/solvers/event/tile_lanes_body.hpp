#pragma once

#include "solvers/event/flight_lanes.hpp"
#include "solvers/event/pair_lanes.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::look_in_lanes(Index i, const Index* others, std::uint32_t count, At now,
                            Meeting<P>& best) const requires kIsDouble<S> {
  const Disk& me = disks_[i];
  const auto& rules = motion_.rules();
  const Lanes zero{};
  const WholeLanes none{};
  const double my_radius = motion_.kind(me).radius;
  const auto row_of = [](const Disk& disk) { return Lanes{disk.x, disk.y, disk.vx, disk.vy}; };
  const auto kind_of = [&](const Disk* disk) { return motion_.kind(*disk); };
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
    const WholeLanes since = me.start - start;
    const WholeLanes mine = since > none;
    const WholeLanes later = mine ? none + me.start : start;
    const Lanes elapsed =
        __builtin_convertvector(mine ? since : -since, Lanes) * rules.scale.tick();
    RelativeLanes r =
        relative(motion_.law(), {x, y, vx, vy, {me.x, me.y}, {me.vx, me.vy}, elapsed, mine});
    r.dx = nearest(r.dx, zero + motion_.periods()[0], zero + motion_.periods()[0] / 2);
    r.dy = nearest(r.dy, zero + motion_.periods()[1], zero + motion_.periods()[1] / 2);
    Lanes reach = zero + 2 * my_radius;
    if (!motion_.one_kind()) {
      reach = my_radius + Lanes{kind_of(disk[0]).radius, kind_of(disk[1]).radius,
                                kind_of(disk[2]).radius, kind_of(disk[3]).radius};
    }
    const Lanes wait =
        when(motion_.law(), pair_times(r.dx, r.dy, r.dvx, r.dvy, reach)) * rules.scale.per_second();
    const Lanes longest = zero + static_cast<double>(kLongestFlight);
    WholeLanes at = later + __builtin_convertvector(wait < longest ? wait : zero, WholeLanes);
    at = at > now ? at : none + now;
    at = wait < longest ? at : none + kNever;
    const WholeLanes tie = (at == meets) & (at < kNever);
    if ((tie[0] | tie[1] | tie[2] | tie[3]) != 0) {
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        if (tie[l] != 0 && disk[l]->partner != i) note_tie(at[l]);
      }
    }
    at = at < meets ? at : none + kNever;
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
