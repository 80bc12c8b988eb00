#pragma once

#include <cstddef>
#include <vector>

#include "contact/cone_island.hpp"
#include "numbers/scalar.hpp"
#include "solvers/event/counts.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/impact_lines.hpp"
#include "solvers/event/islands/island_motion.hpp"

namespace carom::event {

/// The balls of one island, those that come to it, and their near contacts, at one instant.
template <class S>
struct FoundIsland : IslandMotion {
  /// A near contact, beside what its impulse depends on.
  struct Near {
    Vec<S> r;                  ///< between balls: from the first centre to the second
    Index partner = kUnknown;  ///< what it is with, where that never moves: a wall or a ball
    bool comes = false;  ///< it will touch before the next step, and is resolved ahead of that
  };

  std::vector<Index> members;  ///< by ball, as are places
  std::vector<Vec<S>> places;
  std::vector<Near> near;          ///< by contact
  std::size_t few = kFewContacts;  ///< it is large that has more contacts
  double deepest = 0;              ///< overlap of two balls / smaller radius
  bool complete = false;           ///< the search for it began with all of its members
};

/// Whether it has many contacts: what comes to it is resolved ahead of its time.
template <class S>
bool is_large(const FoundIsland<S>& island) {
  return island.contacts.size() > island.few;
}

/// Whether a contact is with a wall, not with a fixed ball.
template <class S>
bool is_at_wall(const FoundIsland<S>& island, std::size_t contact) {
  return island.contacts[contact].b == kWall && island.near[contact].partner >= kFirstMark;
}

/// What an impact or a step has done to an island, beside the motion of its balls.
struct IslandChange {
  Counts counts;             ///< of what it was
  IslandCarried carried;     ///< by its contacts
  std::vector<Index> woken;  ///< balls that were at rest, where it was an impact
};

}  // namespace carom::event
