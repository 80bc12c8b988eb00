#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/joint_impact.hpp"

namespace carom::test {

using event::Body;
using event::Contact;
using event::JointReport;
using event::kWall;
using V = event::Vec<double>;

/// Balls that touch each other, walls or fixed balls.
struct Group {
  std::vector<Body<double>> bodies;
  std::vector<Contact<double>> contacts;

  JointReport resolve() {
    return event::joint_impact<double>(bodies, std::span<const Contact<double>>(contacts));
  }
};

inline double energy(const Group& group) {
  double sum = 0;
  for (const auto& body : group.bodies) {
    if (body.inverse_mass == 0) continue;
    sum += (body.velocity.x * body.velocity.x + body.velocity.y * body.velocity.y) /
           body.inverse_mass / 2;
  }
  return sum;
}

inline V momentum(const Group& group) {
  V sum{0, 0};
  for (const auto& body : group.bodies) {
    sum = sum + (1 / body.inverse_mass) * body.velocity;
  }
  return sum;
}

/// Whether two that touch come nearer.
inline bool approaches(const Group& group) {
  return std::any_of(group.contacts.begin(), group.contacts.end(), [&](const auto& c) {
    const auto& a = group.bodies[static_cast<std::size_t>(c.a)];
    const auto b =
        c.b == kWall ? Body<double>{{0, 0}, 0} : group.bodies[static_cast<std::size_t>(c.b)];
    return a.inverse_mass + b.inverse_mass > 0 && sharp_dot(c.r, b.velocity - a.velocity) < 0;
  });
}

/// Balls on a triangular lattice, rows of 1, 2, 3 ... behind a cue ball on the axis y = 0.
struct Rack {
  Group group;
  std::vector<V> place;

  Rack(int rows, double e) {
    place.push_back({-1, 0});
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k <= row; ++k) place.push_back({row * std::sqrt(0.75), k - row / 2.0});
    }
    for (const V& p : place) group.bodies.push_back({{0, 0}, 1 + 0.1 * std::abs(p.y)});
    group.bodies[0] = {{1, 0}, 1};
    for (int a = 0; a < static_cast<int>(place.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(place.size()); ++b) {
        const V r = place[static_cast<std::size_t>(b)] - place[static_cast<std::size_t>(a)];
        if (std::hypot(r.x, r.y) < 1.001) group.contacts.push_back({a, b, r, e});
      }
    }
  }
};

}  // namespace carom::test
