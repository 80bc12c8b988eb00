#pragma once

#include <cstddef>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/islands/stepped_energy.hpp"
#include "solvers/event/jam_level.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// How often what an island's contacts hold, and the energy it keeps, are seen to in turn.
inline constexpr int kMostTurns = 32;

/// The impulses that an island needs until its next step: those by which none of its contacts
/// closes, and those by which it keeps its energy all the same.
///
/// `next`: the flight until the step; of no time: there is none.  `goal`: what may remain of speeds
/// that are stopped.  `loads`: the sums of the normal impulses, by contact.
template <class P>
class IslandImpulses {
 public:
  using S = typename P::Scalar;
  using Island = FoundIsland<S>;

  /// Both must outlive this.
  IslandImpulses(const Motion<P>& motion, const JamLevel& jam) : motion_(motion), jam_(jam) {}

  [[nodiscard]] const SteppedEnergy& energy() const { return energy_; }
  /// What slides opens no faster than that in a step.
  [[nodiscard]] double opens() const {
    return (motion_.elastic() ? kSolved : 1) * kOpens *
           static_cast<double>(motion_.speed_of_step());
  }
  /// What is taken as jammed in vain loses what its contacts have of speed, or keeps its energy
  /// without them, where nothing takes any.
  [[nodiscard]] bool gives_up() const { return jam_.gives_up(); }
  [[nodiscard]] bool loses() const { return gives_up() && !motion_.elastic(); }

  /// Whether the contact is one of a step, and not an impact to come; where balls lose energy, all
  /// near ones are.
  [[nodiscard]] bool lasts(const Island& island, std::size_t contact) const;
  /// Nothing closes before the next step: what touches, but where impacts are elastic, and what is
  /// near among those that stay, as others meet at their own time.
  /// `opens`: see ConeIsland::resolve.
  void press(Island& island, const SteppedFlight& next, double goal, std::vector<double>& loads,
             double opens = 0) const;
  /// What goes faster, so that the island keeps the energy it `had`, may close a contact beyond
  /// touching: then that one is held again, and what it loses goes to the others.
  void keep_gaps(Island& island, double had, const SteppedFlight& next, double goal,
                 std::vector<double>& loads) const;

  /// Whether a contact that is held closes beyond touching before the step all the same, as one
  /// does that was too fast to be held before something else slowed it down.
  [[nodiscard]] bool closes(const Island& island, const SteppedFlight& next) const;
  /// The same of one contact, whether it is held or not.
  [[nodiscard]] bool closes(const Island& island, std::size_t contact,
                            const SteppedFlight& next) const;

 private:
  /// Whether the contact is one of those that stay, and of a step.
  [[nodiscard]] bool holds(const Island& island, std::size_t contact) const;

  const Motion<P>& motion_;
  const JamLevel& jam_;
  SteppedEnergy energy_{
      {in_double(motion_.law().pull()), motion_.keeps_energy(), kTouching* motion_.largest_radius(),
       kStill* kStill* static_cast<double>(motion_.speed_of_step()), !motion_.elastic_impacts()}};
};

}  // namespace carom::event
