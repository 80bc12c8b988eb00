#pragma once

#include <cstdint>
#include <vector>

#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/islands/island_hits.hpp"
#include "solvers/event/islands/island_impulses.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// The impact of balls on a contact island, resolved for all of it at once: rule 3 of
/// contact/rest_rules.hpp.
///
/// Holds: the flights of the balls are only read; what they become is in the island.
template <class P>
class IslandImpact {
 public:
  using S = typename P::Scalar;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Island = FoundIsland<S>;

  /// Of balls on these flights; all must outlive this.
  IslandImpact(const Motion<P>& motion, const HugeVector<Disk>& disks,
               const IslandImpulses<P>& impulses)
      : motion_(motion), disks_(disks), impulses_(impulses) {}

  /// `span`: how far a speed of 1 goes until the next step, seconds; 0: there is none.  `steps`: a
  /// step is made at the same time, and only what comes before the next one is an impact.
  IslandChange resolve(Island& island, double span, At now, bool steps = false) const;

 private:
  struct Reflection {
    std::uint64_t jammed = 0;  ///< contacts; see JointReport
    double held = 0;           ///< energy of a jammed group that nothing of it can move with
  };
  void take_back(Island& island, double span) const;
  Reflection reflect(Island& island, IslandHits& hits) const;
  void note_who_stays(const Island& island, IslandHits& hits) const;
  /// How fast contact `k`, which bounces, is to part.
  [[nodiscard]] double parting(const Island& island, std::size_t k, const IslandHits& hits,
                               double span) const;
  /// Who is of the island from now on.  Adds those that were at rest to `woken`.  `gives`: those
  /// that are stepped do not have what gravity makes until the next step.
  void give_support(Island& island, const IslandHits& hits, double span, bool gives,
                    std::vector<Index>& woken) const;
  void put_on_walls(Island& island) const;
  /// What an impact is resolved with.
  struct Try {
    std::vector<double> parting;  ///< by contact: how fast it is to part
    double span;
    bool gives;    ///< see give_support
    double goal;   ///< what may remain of speeds that are stopped
    double opens;  ///< see ConeIsland::resolve
    double had;    ///< twice the energy that the island has,
    double kept;   ///< less what jammed groups hold
  };
  /// The impact, of which a part bounces.  False: that would make energy.
  bool bounce(Island& island, const IslandHits& hits, const Try& of, double part,
              IslandChange& change) const;
  void hold_on(Island& island, double span, double goal, std::vector<double>& loads,
               double opens) const;

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const IslandImpulses<P>& impulses_;
};

}  // namespace carom::event
