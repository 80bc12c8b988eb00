#pragma once

#include <cstddef>
#include <vector>

#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/jam_level.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/neighbours.hpp"
#include "solvers/event/prediction.hpp"
#include "solvers/event/simultaneous_impact.hpp"
#include "solvers/event/simultaneous_pairs.hpp"

namespace carom::event {

/// What touches at one instant: balls that overlap, that meet now, that are linked by an impact of
/// this instant, or that are as near as balls that are taken as jammed.
///
/// Contacts are followed over balls that can move.  Those of islands are not listed: what touches
/// an island is resolved with it.
template <class P>
class TouchSearch {
 public:
  using S = typename P::Scalar;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Group = SimultaneousImpact<S>;

  /// What is known of the balls.
  struct Balls {
    const HugeVector<Disk>& disks;
    const std::vector<S>& spins;  ///< empty: they have none
    const Neighbours<P>& neighbours;
    const Prediction<P>& prediction;
  };

  /// All must outlive this.
  TouchSearch(const Motion<P>& motion, const Balls& balls, const SimultaneousPairs& pairs,
              const JamLevel& jam)
      : motion_(motion),
        disks_(balls.disks),
        spins_(balls.spins),
        neighbours_(balls.neighbours),
        prediction_(balls.prediction),
        pairs_(pairs),
        jam_(jam) {}

  /// All that can be reached from the first of `seeds`; takes from these those that it has found.
  [[nodiscard]] Group from(std::vector<Index>& seeds, At now) const;

 private:
  void add_member(Group& group, Index i, At now) const;
  void add_contacts(Group& group, std::size_t member, At now) const;
  void add_walls(Group& group, std::size_t member, At now) const;
  void add_contact(Group& group, std::size_t member, Index j, At now, bool meets) const;
  /// The restitution of a contact: what is taken as jammed in vain does not bounce, where it may
  /// lose energy.
  [[nodiscard]] S restitution_of(const S& of_impact) const {
    return jam_.gives_up() && !motion_.elastic() ? S(0) : of_impact;
  }
  [[nodiscard]] bool touch(Index i, Index j, At now, const Vec<S>& r) const;
  [[nodiscard]] bool in_island(Index i) const {
    return motion_.contacts_last() && motion_.in_island(disks_[i]);
  }

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const std::vector<S>& spins_;
  const Neighbours<P>& neighbours_;
  const Prediction<P>& prediction_;
  const SimultaneousPairs& pairs_;
  const JamLevel& jam_;
};

}  // namespace carom::event
