#pragma once

#include <algorithm>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::start_resting(At now) requires kCanRest {
  if (!motion_.hops()) return;
  number_.assign(disks_.size(), -1);
  for (Index i = 0; i < disks_.size(); ++i) {
    Disk& disk = disks_[i];
    if (motion_.fixed(disk)) continue;
    if (motion_.carried(disk) < kLying && disk.start == now) {
      book_.note(motion_.lean_on_walls(disk));
      step_if_it_slips(i);
    }
    if (motion_.carried(disk) >= kStepped) schedule_step(now);
  }
  book_.keep();
}

template <class P>
void Tile<P>::schedule_step(At now) requires kCanRest {
  if (next_step_ != P::Clock::never() || !(motion_.pull() > 0)) return;
  const int shift = motion_.step_shift();
  next_step_ = P::Clock::span(P::Clock::steps(now, shift), shift);
  // Impacts of the very moment of a step come before it, whether or not others are stepped.
  if (next_step_ < now || !(stepped_ < now)) {
    next_step_ = P::Clock::span(P::Clock::steps(now, shift) + 1, shift);
  }
}

template <class P>
void Tile<P>::lean(Index i) requires kCanRest {
  Disk& disk = disks_[i];
  if (!motion_.hops() || motion_.fixed(disk)) return;
  const unsigned before = motion_.carried(disk);
  book_.note(motion_.lean_on_walls(disk));
  const Index peg = left_[i];
  if (peg != kUnknown) book_.note(motion_.lean_on_peg(disk, disks_[peg]));
  if ((motion_.carried(disk) & ~before) != 0) ++counts_.resting_contacts;
  step_if_it_slips(i);
}

// What rubs along a wall is slowed down step by step, until it rolls.
template <class P>
void Tile<P>::step_if_it_slips(Index i) requires kCanRest {
  if (spins_.empty() || !motion_.slips(disks_[i], spins_[i])) return;
  motion_.set_carried(disks_[i], kJoins);
  schedule_step(disks_[i].start);
}

template <class P>
void Tile<P>::wake_around(Index i, At now) requires kCanRest {
  // Only collisions let one ball carry another, and only they keep a grid to look into.
  if (!motion_.hops() || !motion_.rules().collisions) return;
  const Vec<S> here = motion_.wrapped(motion_.place(disks_[i], now));
  for (const Index j :
       neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y))) {
    Disk& disk = disks_[j];
    if (motion_.carried(disk) != kResting && motion_.carried(disk) != kLying) continue;
    const S reach = motion_.kind(disks_[i]).radius + motion_.kind(disk).radius;
    if (!near(motion_.way(here, motion_.place(disk, now)), reach, S(kNear))) continue;
    motion_.set_carried(disk, kJoins);
  }
}

}  // namespace carom::event
