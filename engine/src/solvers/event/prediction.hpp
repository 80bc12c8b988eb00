#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "numbers/scalar.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/lane_search.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/neighbours.hpp"
#include "solvers/event/ties.hpp"

namespace carom::event {

/// What each ball meets next: another ball, a fixed one, a wall, or the end of its flight.
///
/// A meeting counts only if it is before what the other ball is known to meet.  Where two are at
/// one time, that is noted as a tie.
///
/// Holds: what is found does not depend on the order of a ball's neighbours, but for ties.
template <class P>
class Prediction {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;

  /// The flights of balls, by number, and what else is known of them.
  struct Flights {
    const HugeVector<Disk>& disks;
    const std::vector<S>& spins;     ///< empty: they have none
    const std::vector<Index>& left;  ///< the fixed ball at which each began; empty: no matter
    const Time& next_step;           ///< when flights of islands end that move; never: none does
  };

  /// All must outlive this.
  Prediction(const Motion<P>& motion, const Flights& flights, const Neighbours<P>& neighbours,
             Ties<typename P::Clock>& ties)
      : motion_(motion),
        disks_(flights.disks),
        spins_(flights.spins),
        left_(flights.left),
        next_step_(flights.next_step),
        neighbours_(neighbours),
        ties_(ties) {}

  /// What the ball meets before the time it is known to meet nothing until; kUnknown: nothing.
  [[nodiscard]] Meeting<P> next(Index i, At now) const;
  /// The same of these balls, walls and the end of its flight alone.
  /// REQUIRES: it is known when the ball leaves its safe region.
  [[nodiscard]] Meeting<P> next_of(Index i, std::span<const Index> others, At now) const;
  /// When two balls meet, if that is by `now`.
  [[nodiscard]] Time pair_event(Index i, Index j, At now) const {
    const bool from_contact = !left_.empty() && (left_[i] == j || left_[j] == i);
    return motion_.pair_event(disks_[i], disks_[j], from_contact, now);
  }

  /// Calls visit(partner) for all walls and balls that the ball meets by `now`.
  template <class Visit>
  void each_met(Index i, At now, const Visit& visit) const {
    for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
      if (!motion_.rules().domain.solid((wall - kWalls) / 2)) continue;
      if (motion_.wall_event(disks_[i], wall) <= now) visit(wall);
    }
    if (!motion_.rules().collisions) return;
    neighbours_.lists().each(i, [&](Index j) {
      if (pair_event(i, j, now) <= now) visit(j);
    });
  }

 private:
  static constexpr std::uint32_t kSideBySide = 16;

  [[nodiscard]] const S* spin(Index i) const { return spins_.empty() ? nullptr : &spins_[i]; }
  void note_tie(At at, Index i, Index other) const {
    ties_.note(at, i);
    if (other != i) ties_.note(at, other);
  }
  void in_lanes(Index i, const Index* others, std::uint32_t count, At now,
                Meeting<P>& best) const requires kIsDouble<S>;
  void add_pairs(Index i, const Index* others, std::uint32_t count, At now, Meeting<P>& best) const;
  /// Where some of them, or the ball itself, may be fixed or supported.
  void add_mixed(Index i, const Index* others, std::uint32_t count, At now, Meeting<P>& best) const;
  void add_pair(Index i, Index other, At now, Meeting<P>& best) const;
  void add_fixed_disk(Index i, Index fixed_disk, Meeting<P>& best) const;
  void add_alone(Index i, Meeting<P>& best) const;
  /// The first time that is no more of its flight, as far as that is known.
  [[nodiscard]] Time beyond_flight(const Disk& disk) const;

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const std::vector<S>& spins_;
  const std::vector<Index>& left_;
  const Time& next_step_;
  const Neighbours<P>& neighbours_;
  Ties<typename P::Clock>& ties_;
};

}  // namespace carom::event
