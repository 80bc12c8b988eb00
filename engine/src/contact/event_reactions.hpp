#pragma once

#include <span>
#include <vector>

#include "contact/event_nonnegative_impulses.hpp"

namespace carom::event {

/// What a group of touching balls does under gravity when its contacts only push.
template <class S>
struct Reactions {
  std::vector<S> forces;              ///< by contact, along its normal, >= 0
  std::vector<Vec<S>> accelerations;  ///< by body
};

/// The forces >= 0 at which no contact accelerates into itself and none pushes that opens: the
/// least constraint (Gauss), as the linear complementarity problem of the contacts' normal
/// accelerations. Two disks that slide on each other bring the acceleration of their curvature,
/// v_t^2 / |r|. Fixed balls feel no gravity. Source: Baraff, SIGGRAPH 1994, 23; Loetstedt, SIAM
/// J. Appl. Math. 42 (1982) 281.
template <class S>
Reactions<S> reactions(std::span<const Body<S>> bodies, std::span<const Contact<S>> contacts,
                       const Vec<S>& gravity) {
  const ContactGraph<S> graph(bodies, contacts);
  std::vector<Vec<S>> motion(bodies.size(), gravity);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].inverse_mass == 0) motion[k] = {S(0), S(0)};
  }
  std::vector<S> parting(contacts.size());
  std::vector<char> all(contacts.size(), 0);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact<S>& c = contacts[k];
    parting[k] = graph.parting(k, motion);
    all[k] = graph.mobility(k) > 0 ? 1 : 0;
    if (c.b == kWall) continue;
    const Vec<S> v = bodies[static_cast<std::size_t>(c.b)].velocity -
                     bodies[static_cast<std::size_t>(c.a)].velocity;
    const S sliding = cross(graph.normal(k), v);
    parting[k] = parting[k] + sliding * sliding / root(S(c.r.x * c.r.x + c.r.y * c.r.y));
  }
  Reactions<S> result{nonnegative_impulses(graph, parting, all), std::move(motion)};
  const std::vector<Vec<S>> totals = graph.totals(result.forces);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    result.accelerations[k] = result.accelerations[k] + bodies[k].inverse_mass * totals[k];
  }
  return result;
}

/// Whether the forces hold every ball against gravity, to 2^-40 of it in double.
template <class S>
bool holds_still(const Reactions<S>& reactions, const Vec<S>& gravity) {
  const S most = root(std::numeric_limits<S>::epsilon()) / 16384 *
                 larger(absolute(gravity.x), absolute(gravity.y));
  for (const Vec<S>& a : reactions.accelerations) {
    if (absolute(a.x) > most || absolute(a.y) > most) return false;
  }
  return true;
}

}  // namespace carom::event
