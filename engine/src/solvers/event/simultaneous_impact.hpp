#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contact/contact_graph.hpp"
#include "solvers/event/disk.hpp"

namespace carom::event {

/// The balls that touch at one instant, and all their contacts.
template <class S>
struct SimultaneousImpact {
  std::vector<Index> members;  ///< balls and fixed balls; the first is the one it began with
  std::vector<Vec<S>> places;
  std::vector<Body<S>> bodies;
  std::vector<S> spins;  ///< only where balls have friction
  std::vector<Contact<S>> contacts;
  struct Stop {
    std::size_t member;
    Index wall;
    bool meets;  ///< it is at the wall: not only so near that it is taken as jammed
  };
  std::vector<Stop> stops;  ///< the contacts with walls, in their order

  [[nodiscard]] std::size_t find(Index i) const {
    return static_cast<std::size_t>(std::find(members.begin(), members.end(), i) - members.begin());
  }
  /// Calls visit(contact, i, partner) for all contacts, of ball i with a ball or a wall.
  template <class Visit>
  void each_contact(Visit visit) const {
    auto stop = stops.begin();
    for (const Contact<S>& contact : contacts) {
      const Index partner =
          contact.b == kWall ? (stop++)->wall : members[static_cast<std::size_t>(contact.b)];
      visit(contact, members[static_cast<std::size_t>(contact.a)], partner);
    }
  }
};

}  // namespace carom::event
