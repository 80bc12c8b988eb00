#pragma once

#include <cstddef>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/counts.hpp"
#include "solvers/event/energy_book.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/neighbours.hpp"

namespace carom::event {

/// What carries balls where contacts can rest: walls, a fixed ball straight below, or an island.
/// Which it is stands with the flight: Motion::support.
///
/// Holds: where no contacts last, nothing is done.
template <class P>
class Supports {
 public:
  using S = typename P::Scalar;
  using At = typename P::At;
  using Disk = typename P::Disk;

  /// The flights of all balls.
  struct Flights {
    HugeVector<Disk>& disks;
    std::vector<S>& spins;                ///< empty: they have none
    const std::vector<Index>& left;       ///< the fixed ball at which each began
    const std::vector<double>& left_out;  ///< see SteppedEnergy; empty: nothing is
  };
  /// All must outlive this.  What rest takes is noted in the book.
  Supports(const Motion<P>& motion, const Flights& flights, Neighbours<P>& neighbours,
           Counts& counts, EnergyBook& book)
      : motion_(motion),
        disks_(flights.disks),
        spins_(flights.spins),
        left_(flights.left),
        left_out_(flights.left_out),
        neighbours_(neighbours),
        counts_(counts),
        book_(book) {}

  /// Balls whose flights begin now are carried by the walls that they are at.
  void begin(At now) {
    for (Index i = 0; i < disks_.size(); ++i) {
      Disk& disk = disks_[i];
      if (motion_.fixed(disk)) continue;
      const unsigned support = motion_.support(disk);
      if (support != kLying && support < kResting && disk.start == now) {
        book_.note(motion_.support_on_walls(disk, spin(i)));
      }
    }
  }
  /// Whether any ball is of an island that moves.
  [[nodiscard]] bool any_stepped() const {
    for (const Disk& disk : disks_) {
      if (!motion_.fixed(disk) && motion_.support(disk) >= kStepped) return true;
    }
    return false;
  }
  /// The ball has a new flight: it is supported by what it lies on.
  void update(Index i) {
    Disk& disk = disks_[i];
    if (!motion_.contacts_last() || motion_.fixed(disk)) return;
    const unsigned before = motion_.support(disk);
    book_.note(motion_.support_on_walls(disk, spin(i)));
    const Index fixed_disk = left_[i];
    if (fixed_disk != kUnknown) book_.note(motion_.support_on_fixed_disk(disk, disks_[fixed_disk]));
    if ((axes_of(motion_.support(disk)) & ~axes_of(before)) != 0) ++counts_.resting_contacts;
  }
  /// Who rests on this ball, or carries it, moves again.
  void wake_around(Index i, At now) {
    // Only collisions let one ball carry another, and only they keep a grid to look into.
    if (!motion_.contacts_last() || !motion_.rules().collisions) return;
    const Vec<S> here = motion_.wrapped(motion_.place(disks_[i], now));
    for (const Index j :
         neighbours_.around(static_cast<double>(here.x), static_cast<double>(here.y))) {
      Disk& disk = disks_[j];
      if (motion_.support(disk) != kResting && motion_.support(disk) != kLying) continue;
      const S reach = motion_.species(disks_[i]).radius + motion_.species(disk).radius;
      if (!near(motion_.way(here, motion_.place(disk, now)), reach, S(kNear))) continue;
      motion_.set_support(disk, kJoins);
    }
  }
  /// The energy that gravity has given to islands ahead of what they will have fallen at `next`,
  /// when they are stepped, less what these flights are counted without.
  [[nodiscard]] double given_ahead(At now, At next) const {
    double sum = 0;
    for (Index i = 0; i < disks_.size(); ++i) {
      const Disk& disk = disks_[i];
      if (motion_.fixed(disk) || motion_.support(disk) != kStepped) continue;
      sum += motion_.given_ahead(disk, now, next);
      if (!left_out_.empty()) sum -= left_out_[i];
    }
    return sum;
  }

 private:
  [[nodiscard]] S* spin(Index i) { return spins_.empty() ? nullptr : &spins_[i]; }

  const Motion<P>& motion_;
  HugeVector<Disk>& disks_;
  std::vector<S>& spins_;
  const std::vector<Index>& left_;
  const std::vector<double>& left_out_;
  Neighbours<P>& neighbours_;
  Counts& counts_;
  EnergyBook& book_;
};

}  // namespace carom::event
