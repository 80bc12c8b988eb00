#include "solvers/event/islands/island_part.hpp"

#include <cmath>

#include "contact/contact_graph.hpp"

namespace carom::event {

IslandPart::IslandPart(const IslandMotion& island, const std::vector<char>& stands,
                       const std::vector<char>& lasts) {
  const std::size_t n = island.bodies.size();
  std::vector<int> number(n, kWall);
  for (std::size_t m = 0; m < n; ++m) {
    if (stands[m] != 0) continue;
    number[m] = static_cast<int>(bodies.size());
    bodies.push_back(island.bodies[m]);
    body_number.push_back(m);
  }
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (lasts[k] == 0) continue;
    ConeContact contact = island.contacts[k];
    contact.a = number[static_cast<std::size_t>(contact.a)];
    if (contact.b != kWall) contact.b = number[static_cast<std::size_t>(contact.b)];
    if (contact.a == kWall) {
      if (contact.b == kWall) continue;
      contact.a = contact.b;
      contact.b = kWall;
      contact.normal = -contact.normal;
    }
    contacts.push_back(contact);
    contact_number.push_back(k);
  }
}

void IslandPart::pass_on(IslandMotion& island) const {
  for (std::size_t m = 0; m < bodies.size(); ++m) island.bodies[body_number[m]] = bodies[m];
}

bool is_slow(const ConeBody& body, double most) {
  return std::abs(body.velocity.x) <= most && std::abs(body.velocity.y) <= most &&
         std::abs(body.turning) <= most;
}

bool reaches_standing(const IslandMotion& island, const std::vector<char>& stands, double still) {
  for (const ConeContact& c : island.contacts) {
    if (c.b == kWall) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = static_cast<std::size_t>(c.b);
    if (stands[a] == stands[b]) continue;
    if (!is_slow(island.bodies[stands[a] != 0 ? b : a], still)) return true;
  }
  return false;
}

void spread_motion(const IslandMotion& island, int times, std::vector<char>& moves) {
  for (int time = 0; time < times; ++time) {
    const std::vector<char> before = moves;
    for (const ConeContact& c : island.contacts) {
      if (c.b == kWall) continue;
      const auto a = static_cast<std::size_t>(c.a);
      const auto b = static_cast<std::size_t>(c.b);
      if (before[a] != 0) moves[b] = 1;
      if (before[b] != 0) moves[a] = 1;
    }
  }
}

}  // namespace carom::event
