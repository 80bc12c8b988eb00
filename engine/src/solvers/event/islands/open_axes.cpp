#include "solvers/event/islands/open_axes.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "contact/contact_graph.hpp"
#include "contact/disjoint_sets.hpp"

namespace carom::event {
void OpenAxes::add(const ConeContact& contact) {
  if (contact.b != kWall) return;
  x = x && contact.normal.x == 0 && contact.friction == 0;
  y = y && contact.normal.y == 0 && contact.friction == 0;
}

OpenAxes open_axes(const IslandMotion& island) {
  OpenAxes open;
  for (const ConeContact& contact : island.contacts) open.add(contact);
  return open;
}

std::vector<char> pulled_along(const IslandMotion& island, const Vec<double>& pull,
                               const std::vector<char>& presses) {
  DisjointSets groups;
  groups.reset(island.bodies.size());
  for (std::size_t k = 0; k < presses.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (presses[k] == 0 || c.b == kWall) continue;
    groups.merge(static_cast<std::uint32_t>(c.a), static_cast<std::uint32_t>(c.b));
  }
  std::vector<OpenAxes> open(island.bodies.size());
  for (std::size_t k = 0; k < presses.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (presses[k] != 0) open[groups.find(static_cast<std::uint32_t>(c.a))].add(c);
  }
  // Less is rounding.
  const double least =
      std::numeric_limits<double>::epsilon() * (std::abs(pull.x) + std::abs(pull.y));
  std::vector<char> pulled;
  for (std::uint32_t m = 0; m < island.bodies.size(); ++m) {
    const OpenAxes& axes = open[groups.find(m)];
    // What leans on nothing here may lean on what stands.
    const Vec<double> along = axes.x && axes.y ? Vec<double>{0, 0} : axes.along(pull);
    pulled.push_back(std::abs(along.x) > least || std::abs(along.y) > least ? 1 : 0);
  }
  return pulled;
}

}  // namespace carom::event
