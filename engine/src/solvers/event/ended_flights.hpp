#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/event/disk.hpp"
#include "solvers/event/energy_book.hpp"
#include "solvers/event/motion.hpp"
#include "state/totals.hpp"

namespace carom::event {

/// What flights that are over have lost, and how often they were brought back round a periodic axis
/// that gravity pulls along.
///
/// Holds: a flight counts once, whatever was taken back in between: what is taken off for the
/// flight that begins is what it has lost already.
template <class P>
class EndedFlights {
 public:
  using S = typename P::Scalar;
  using At = typename P::At;
  using Disk = typename P::Disk;

  /// Both must outlive this; losses go to the book.
  EndedFlights(const Motion<P>& motion, EnergyBook& book) : motion_(motion), book_(book) {}

  /// Forgets all; the balls are on these flights, with these spins at their starts, if they have
  /// any.
  template <class Disks>
  void reset(const Disks& disks, const std::vector<S>& spins) {
    flights_.clear();
    spins_.clear();
    bool counts = motion_.loses_in_flight();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      turns_[axis].clear();
      if (!motion_.rules().falls_round(axis)) continue;
      turns_[axis].resize(disks.size(), 0);
      counts = true;
    }
    if (!counts) return;
    flights_.assign(disks.begin(), disks.end());
    spins_ = spins;
  }
  /// Whether there is anything to count.
  [[nodiscard]] bool any() const { return !flights_.empty(); }
  /// The flight that the ball was last said to be on, and its spin then; null: it has none.
  /// REQUIRES: any().
  [[nodiscard]] const Disk& flight(Index i) const { return flights_[i]; }
  [[nodiscard]] const S* spin(Index i) const { return spins_.empty() ? nullptr : &spins_[i]; }

  /// The ball goes on by `next`, which began now, or before, if it is on that flight still, or
  /// again.
  /// REQUIRES: any().
  void end(Index i, const Disk& next, const S* spin, At now) {
    if (motion_.loses_in_flight()) {
      book_.add_drag(motion_.flight_loss(flights_[i], this->spin(i), now));
      if (next.start != now) book_.add_drag(-motion_.flight_loss(next, spin, now));
    }
    count_turns(i, next, now);
    flights_[i] = next;
    if (!spins_.empty()) spins_[i] = *spin;
  }

  /// By axis and ball; empty for axes that are not counted.
  [[nodiscard]] const Turns& turns() const { return turns_; }

  /// Counts time from `by` ticks later on.
  void rebase(At by) {
    for (Disk& flight : flights_) {
      if (flight.start != P::Clock::ever()) flight.start -= by;
    }
  }

 private:
  void count_turns(Index i, const Disk& next, At now) {
    if (turns_[0].empty() && turns_[1].empty()) return;
    const Vec<S> came = motion_.place(flights_[i], now);
    const auto count = [&](std::size_t axis, const S& from, const S& to) {
      if (turns_[axis].empty()) return;
      const S period = motion_.periods()[axis];
      turns_[axis][i] += std::llrint(static_cast<double>(S((from - to) / period)));
    };
    count(0, came.x, next.x);
    count(1, came.y, next.y);
  }

  const Motion<P>& motion_;
  EnergyBook& book_;
  std::vector<Disk> flights_;  ///< which losses and turns know of; empty: none are counted
  std::vector<S> spins_;       ///< at their starts
  Turns turns_;
};

}  // namespace carom::event
