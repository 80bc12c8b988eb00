#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/impact.hpp"
#include "contact/dissipation.hpp"

namespace carom::event {

// What contacts carry, as lines of a log.  A contact is given as its line with everything else: the
// time, the balls, the place, the normal.

/// An impact of two balls, or of one at a wall, from what it has changed.
struct SingleImpact {
  bool from_a = true;       ///< the change is that of the line's ball a
  Vec2 change{0, 0};        ///< of the velocity: the one before less the one after
  double inverse_mass = 0;  ///< of the same ball
  bool friction = false;    ///< balls have friction
  double lost = 0;
};
[[nodiscard]] Impact single_line(Impact contact, const SingleImpact& impact);

/// What the contacts of a joint impact carry.
struct JointCarried {
  /// The normal impulse of a contact in one of its rounds.
  struct Push {
    std::size_t contact;
    double impulse;
    double lost;  ///< to restitution
  };
  std::vector<Push> pushes;
  std::vector<carom::FrictionChange> by_friction;  ///< by contact; empty: there is no friction
  double held = 0;                                 ///< see JointReport
  bool elastic = false;                            ///< no restitution takes energy
};
/// One line for each time that a contact is hit; friction, which comes first, with its first.
/// `event`: the number that the lines share.
[[nodiscard]] std::vector<Impact> joint_lines(std::span<const Impact> contacts,
                                              const JointCarried& carried, std::uint64_t event);

/// What the contacts of an island carry at an impact or for a step.
struct IslandCarried {
  std::vector<double> impulses;  ///< by contact
  std::vector<char> counted;     ///< by contact: it is one of the impacts that are counted
  double lost = 0;
};
/// What presses without being counted is a contact at rest; the first line has what all lost, or
/// the last contact's where nothing presses.
[[nodiscard]] std::vector<Impact> island_lines(std::span<const Impact> contacts,
                                               const IslandCarried& carried, std::uint64_t event);

}  // namespace carom::event
