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

  /// `next`: the flight until the next step; of no time: there is none.  `steps`: a step is made at
  /// the same time, and only what comes before the next one is an impact.
  IslandChange resolve(Island& island, const SteppedFlight& next, At now,
                       bool steps = false) const {
    return resolve(island, next, now, steps ? Kind::step : Kind::impact);
  }
  /// A step has come out as `change` and has held what moves: what presses in it is an impact, by
  /// which that turns round.  `island`: as it was before the step.
  IslandChange turn(Island& island, const IslandChange& change, At now) const;

 private:
  enum class Kind { impact, step, turn };
  IslandChange resolve(Island& island, const SteppedFlight& next, At now, Kind kind) const;
  struct Reflection {
    std::uint64_t jammed = 0;  ///< contacts; see JointReport
    double held = 0;           ///< energy of a jammed group that nothing of it can move with
  };
  /// What leaves falls by itself.  `way`: see SteppedFlight, until the next step; 0: it is now.
  void take_back(Island& island, double way) const;
  /// A joint impact of all that touches.
  Reflection reflect(Island& island) const;
  void note_who_stays(const Island& island, IslandHits& hits) const;
  /// How fast contact `k`, which bounces, is to part.
  [[nodiscard]] double parting(const Island& island, std::size_t k, const IslandHits& hits,
                               const SteppedFlight& next) const;
  /// Who is of the island from now on.  Adds those that were at rest to `woken`.
  void give_support(Island& island, const IslandHits& hits, const SteppedFlight& next,
                    std::vector<Index>& woken) const;
  void put_on_walls(Island& island) const;
  /// What an impact is resolved with.
  struct Try {
    std::vector<double> parting;  ///< by contact: how fast it is to part
    SteppedFlight next;
    double goal;   ///< what may remain of speeds that are stopped
    double opens;  ///< see ConeIsland::resolve
    std::vector<ConeBody> before;
    double had;   ///< twice the energy that the island has,
    double kept;  ///< less what jammed groups hold
  };
  /// Whether nothing of an impact on few loses energy: then it is a joint impact.
  [[nodiscard]] bool reflects(const Island& island, const IslandHits& hits) const;
  /// Whether all contacts part as they are asked to, and nothing closes: what has no room does not.
  [[nodiscard]] bool has_room(const Island& island, const Try& of) const;
  [[nodiscard]] double solved_to(double fastest) const;
  enum class Bounce { done, has_no_room, makes_energy };
  /// The impact, of which a part bounces.
  Bounce bounce(Island& island, const IslandHits& hits, const Try& of, double part,
                IslandChange& change) const;
  void hold_on(Island& island, const Try& of, std::vector<double>& loads) const;
  void hold_elastic(Island& island, const Try& of, std::vector<double>& loads) const;
  /// Balls that have left, and that something stepped which they touch closes in on.
  [[nodiscard]] std::vector<std::size_t> who_comes_back(const Island& island,
                                                        const SteppedFlight& next) const;
  /// What gravity owes a ball, and makes in the first half of its next flight.
  void pull(Island& island, std::size_t m, const SteppedFlight& next) const;

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const IslandImpulses<P>& impulses_;
};

}  // namespace carom::event
