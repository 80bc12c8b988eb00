#pragma once

#include <algorithm>

#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::note_alone(Index i, const Disk& before, Index partner, const Disk& partner_before,
                         At now) const {
  JournalShare share;
  if (partner >= kWalls) {
    share.ball_wall = 1;
  } else {
    const bool both = !motion_.fixed(disks_[partner]);
    share.ball_ball_halves = both ? 1 : 2;
    share.overlap = overlap_;
    if (both) journal_->note(partner, partner_before, disks_[partner], now, share);
  }
  journal_->note(i, before, disks_[i], now, share);
}

template <class P>
void Tile<P>::take_out(Index i) {
  lift(i);
  disks_[i].leaves = P::Clock::never();
  if (motion_.rules().collisions) neighbours_.take_out(i);
}

template <class P>
void Tile<P>::lift(Index i) {
  unlink(i);
  forget(i);
}

template <class P>
void Tile<P>::put(Index i, const Disk& flight) {
  if (i >= disks_.size()) disks_.resize(i + 1);
  Disk& disk = disks_[i];
  const Time leaves = disk.leaves;
  disk = flight;
  disk.leaves = leaves;
  disk.meets = P::Clock::never();
  disk.partner = kUnknown;
}

template <class P>
void Tile<P>::resume(std::span<const Index> lifted, std::span<const Index> fresh, At now) {
  if (motion_.rules().collisions) {
    for (const Index i : fresh) neighbours_.add(disks_, i, now);
    for (const Index i : lifted) {
      if (motion_.fixed(disks_[i]) || neighbours_.in_square(disks_[i], i, now)) continue;
      // Who is listed anew is looked at with all the others.
      static_cast<void>(neighbours_.renew(disks_, i, now));
    }
    for (const auto& group : {lifted, fresh}) {
      for (const Index i : group) disks_[i].leaves = neighbours_.leaving(disks_[i], i, now);
    }
  }
  for (const auto& group : {lifted, fresh}) {
    for (const Index i : group) scan(i, now);
  }
  for (const auto& group : {lifted, fresh}) {
    for (const Index i : group) announce(i);
  }
}

template <class P>
void Tile<P>::undo(At moment) {
  const auto& entries = journal_->entries();
  std::vector<Index> changed;
  std::size_t kept = entries.size();
  while (kept > 0 && entries[kept - 1].time > moment) {
    const auto& entry = entries[--kept];
    lift(entry.ball);
    entry.before.restore(disks_[entry.ball]);
    changed.push_back(entry.ball);
  }
  journal_->shorten(kept);
  reached_ = moment;
  if (motion_.rules().collisions) {
    for (const Index i : journal_->renewed()) {
      // A straight way from square to square stays in it, a bent one need not.
      if (!motion_.bends() && neighbours_.in_square(disks_[i], i, moment)) continue;
      lift(i);
      changed.push_back(i);
    }
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  resume(changed, {}, moment);
}

template <class P>
bool Tile<P>::is_near(Index i, const Vec<S>& at, double travel, const std::vector<char>& wanted) {
  if (!motion_.rules().collisions) return false;
  if (!neighbours_.sees(travel)) return true;
  const S radius = motion_.kind(disks_[i]).radius;
  for (const Index j : neighbours_.around(static_cast<double>(at.x), static_cast<double>(at.y))) {
    if (wanted[j] == 0) continue;
    const Vec<S> r = motion_.way(at, motion_.place(disks_[j], reached_));
    const S reach = (radius + motion_.kind(disks_[j]).radius + travel) * (1 + 0x1p-20);
    if (r.x * r.x + r.y * r.y <= reach * reach) return true;
  }
  return false;
}

template <class P>
void Tile<P>::commit(At moment) {
  ties_.erase(ties_.begin(), ties_.upper_bound(moment));
}

}  // namespace carom::event
