#pragma once

#include <cstdint>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/islands/island_impulses.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// The step of a contact island: what gravity and its contacts do until its next step, and which of
/// its balls come to rest or leave it; rules 3 and 4 of contact/rest_rules.hpp.
///
/// Holds: the flights of the balls are only read; what they become is in the island.
template <class P>
class IslandStepping {
 public:
  using S = typename P::Scalar;
  using Disk = typename P::Disk;
  using Island = FoundIsland<S>;

  /// Of balls on these flights; all must outlive this.
  IslandStepping(const Motion<P>& motion, const HugeVector<Disk>& disks,
                 const IslandImpulses<P>& impulses)
      : motion_(motion), disks_(disks), impulses_(impulses) {}

  /// `whole`: what stands in a large island is asked again whether it does; else only where what
  /// moves comes near to it.
  IslandChange step(Island& island, bool whole = true) const;

 private:
  /// How exactly a step is solved.
  struct Scale {
    Vec<double> pull;    ///< gravity
    SteppedFlight next;  ///< the flight that begins
    double speed;        ///< what gravity makes in a step
    double still;        ///< what is slower is still
    double goal;         ///< what may remain of speeds that are stopped
  };
  [[nodiscard]] Scale scale() const;
  /// The goal of a step in which so many balls move.
  [[nodiscard]] double goal_of(const Island& island, std::size_t moving, const Scale& scale) const;
  /// How balls would move now that had been flying under all that acts on them in this step.
  [[nodiscard]] std::vector<ConeBody> at_end(const Island& island,
                                             const std::vector<ConeBody>& before,
                                             const Scale& scale) const;

  /// What the contacts of a step have done.
  struct Pressed {
    std::vector<double> loads;  ///< normal impulses, by contact
    std::vector<char> lasts;    ///< by contact: it is one of the step
    std::vector<char> presses;  ///< by contact: it closes, and can take a load
  };
  /// Gravity acts, and no contact closes.  `stands`: by ball: it is held, whatever comes.
  Pressed press(Island& island, const std::vector<char>& stands, const Scale& scale) const;

  /// What carries whom.
  struct Carrying {
    std::vector<char> carries;     ///< by contact
    std::vector<int> loaded;       ///< by ball: how many of its contacts carry
    std::vector<char> on_balls;    ///< by ball: one of those is with a ball
    std::vector<char> approaches;  ///< by ball: it came nearer to what it is in contact with
    DisjointSets sets;             ///< of balls that carry each other
  };
  /// `before`: as the balls moved before the step.
  [[nodiscard]] Carrying carrying(const Island& island, const std::vector<ConeBody>& before,
                                  const Pressed& pressed, const Scale& scale) const;
  /// By ball: it does not come to rest.  `pulled`: by ball: nothing can hold it.
  [[nodiscard]] std::vector<char> moving(const Island& island, const std::vector<ConeBody>& before,
                                         const Pressed& pressed, Carrying& carrying,
                                         const std::vector<char>& stands,
                                         const std::vector<char>& pulled, const Scale& scale) const;
  /// Rest, or not, or leave, as `ends` says they move.  `stays`: by ball.  Gives how many contacts
  /// have come to rest.
  std::uint64_t give_support(Island& island, const std::vector<ConeBody>& ends,
                             const Carrying& carrying, const std::vector<char>& moves,
                             const std::vector<char>& stands, const std::vector<char>& stays) const;
  /// What walls carry is exactly there; where nothing else touches it, it slides or rolls on along
  /// them, of the island no more, if it does not come to rest.
  void put_on_walls(Island& island, const std::vector<ConeBody>& ends, const Carrying& carrying,
                    const std::vector<char>& stays, const Scale& scale) const;
  /// Twice what contacts gave that parted before the step, and are pressed in it: what they took
  /// when they did so.
  [[nodiscard]] static double given_by_parting(const Island& island,
                                               const std::vector<ConeBody>& before,
                                               const std::vector<double>& loads, double still,
                                               double span);
  /// All of them rest where none moved before the step or after it.
  static void rest_if_stopped(Island& island, const std::vector<ConeBody>& before,
                              const std::vector<char>& pulled, const Scale& scale);

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const IslandImpulses<P>& impulses_;
};

}  // namespace carom::event
