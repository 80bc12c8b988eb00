#include "solvers/event/islands/island_rest.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "contact/cone_island.hpp"
#include "contact/contact_graph.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/support.hpp"

namespace carom::event {
namespace {

// Whether pushes along these edges of cones can add up to one against `pull`, within kHeld.
bool hold_up(const std::vector<Vec<double>>& edges, const Vec<double>& pull) {
  const double size = std::sqrt(dot(pull, pull));
  const Vec<double> up = -(1 / size) * pull;
  // The edge next to it on each side, as a way along it and across it.
  Vec<double> left{-1, 0};
  Vec<double> right{-1, 0};
  for (const Vec<double>& edge : edges) {
    const Vec<double> way =
        (1 / std::sqrt(dot(edge, edge))) * Vec<double>{dot(up, edge), cross(up, edge)};
    if (way.x > 0 && std::abs(way.y) <= kHeld) return true;
    Vec<double>& side = way.y > 0 ? left : right;
    if (way.x > side.x) side = way;
  }
  return left.x > -1 && right.x > -1 && cross(right, left) > 0;
}

}  // namespace

void hold_still(const IslandMotion& island, const StepScale& step, DisjointSets& sets,
                const std::vector<char>& presses, std::vector<char>& moves) {
  const std::size_t n = island.bodies.size();
  const std::vector<char> moved = moves;
  const auto find = [&sets](std::size_t k) { return sets.find(static_cast<std::uint32_t>(k)); };
  for (std::size_t first = 0; first < n; ++first) {
    if (find(first) != first || moves[first] != 0) continue;
    std::vector<int> number(n, -1);
    std::vector<ConeBody> bodies;
    bool fresh = false;
    for (std::size_t m = 0; m < n; ++m) {
      if (find(m) != first) continue;
      number[m] = static_cast<int>(bodies.size());
      bodies.push_back({step.span * step.pull, 0, island.bodies[m].inverse_mass});
      fresh = fresh || island.support[m] != kResting;
    }
    if (!fresh) continue;
    const bool many = bodies.size() > kFewHeld;
    std::vector<Vec<double>> edges;
    std::vector<ConeContact> contacts;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      ConeContact contact = island.contacts[k];
      const int a = number[static_cast<std::size_t>(contact.a)];
      if (presses[k] == 0) continue;
      const int b = contact.b == kWall ? -1 : number[static_cast<std::size_t>(contact.b)];
      if (a < 0 && b < 0) continue;
      // What the set leans on and does not move is as a wall.
      if (contact.b != kWall && (a < 0 || b < 0) &&
          moved[find(static_cast<std::size_t>(a < 0 ? contact.a : contact.b))] != 0) {
        continue;
      }
      contact.a = a < 0 ? b : a;
      contact.b = a < 0 || b < 0 ? kWall : b;
      if (a < 0) contact.normal = -contact.normal;
      contact.gap = 0;
      if (!many) {
        contacts.push_back(contact);
      } else if (contact.b == kWall) {
        const Vec<double> along =
            contact.friction * Vec<double>{-contact.normal.y, contact.normal.x};
        edges.push_back(along - contact.normal);
        edges.push_back(-along - contact.normal);
      }
    }
    if (many) {
      if (!hold_up(edges, step.pull)) moves[first] = 1;
      continue;
    }
    ConeIsland whole(bodies, contacts);
    whole.resolve(bodies, 0, kHeld / 4 * step.speed);
    for (const ConeBody& body : bodies) {
      const double most =
          std::max({std::abs(body.velocity.x), std::abs(body.velocity.y), std::abs(body.turning)});
      if (most > kHeld * step.speed) moves[first] = 1;
    }
  }
}

void pass_on_motion(const IslandMotion& island, DisjointSets& sets, std::vector<char>& moves) {
  for (bool more = true; more;) {
    more = false;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const ConeContact& c = island.contacts[k];
      if (c.b == kWall || island.touches[k] == 0) continue;
      const std::uint32_t a = sets.find(static_cast<std::uint32_t>(c.a));
      const std::uint32_t b = sets.find(static_cast<std::uint32_t>(c.b));
      if (moves[a] == moves[b]) continue;
      const ConeBody& moving = island.bodies[static_cast<std::size_t>(moves[a] != 0 ? c.a : c.b)];
      const double nearer = dot(c.normal, moving.velocity) * (moves[a] != 0 ? 1 : -1);
      if (!(nearer > 0)) continue;
      moves[a] = moves[b] = 1;
      more = true;
    }
  }
}

std::vector<char> met(const IslandMotion& island, const std::vector<ConeBody>& before) {
  std::vector<char> met(island.bodies.size(), 0);
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    if (c.b == kWall || island.touches[k] == 0) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = static_cast<std::size_t>(c.b);
    if (dot(c.normal, before[a].velocity - island.bodies[b].velocity) > 0) met[a] = 1;
    if (dot(c.normal, island.bodies[a].velocity - before[b].velocity) > 0) met[b] = 1;
  }
  return met;
}

}  // namespace carom::event
