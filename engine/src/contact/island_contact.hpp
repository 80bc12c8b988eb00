#pragma once

#include <vector>

#include "contact/index.hpp"
#include "contact/island.hpp"

namespace carom::contact {

/// A gap that is none, by the way of the rule's speed in a step.
constexpr double kClosed = kExact;

inline Vec2 across(const Vec2& normal) {
  return {-normal.y(), normal.x()};
}

/// The acceleration of a body.
inline Vec2 acceleration_of(const IslandBody& body, const IslandStep::Rule& rule) {
  return rule.acceleration + body.pull;
}

/// How fast a contact opens, by the velocities of all bodies.
[[nodiscard]] double opening_of(const std::vector<Vec2>& motion, const IslandContact& contact);

/// How fast the two come together when they meet, after the relative pull on the way there; 0 or
/// less: they part.
[[nodiscard]] double arrival(const std::vector<IslandBody>& bodies, const IslandContact& contact,
                             const IslandStep::Rule& rule);

/// Whether the two meet within the step, faster than what comes to rest.
[[nodiscard]] bool bounces(const std::vector<IslandBody>& bodies, const IslandContact& contact,
                           const IslandStep::Rule& rule);

/// How fast the two may come together so that they touch at the end of the step.  An overlap that
/// is less than `tolerated`, by the way of the speed in a step, stays: what lifts balls out of it
/// would have to come from somewhere.  A deeper one comes apart again, at the speed `apart`.
[[nodiscard]] double closing_room(const IslandContact& contact, const IslandStep::Rule& rule,
                                  double tolerated, double apart);

/// The mean speed of an island's balls, which motion they share left out unless something
/// holds them.
[[nodiscard]] double mean_speed(const std::vector<IslandBody>& bodies, bool held);

/// How fast overlaps come apart in an island of that mean speed: what this lifts is paid for by the
/// motion of the balls, so little where they hardly move.
[[nodiscard]] double apart_speed(double moving, const IslandStep::Rule& rule);

}  // namespace carom::contact
