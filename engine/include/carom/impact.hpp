#pragma once

#include <cstddef>
#include <cstdint>

#include "carom/vector.hpp"

namespace carom {

/// What an event is.
enum class ImpactKind : std::uint8_t {
  ball,    ///< an impact of two balls
  wall,    ///< an impact of a ball at a wall
  joint,   ///< one contact of several that have their impacts together
  rest,    ///< a contact that does not bounce: it comes to rest, or is held at rest for a step
  wake,    ///< a ball at rest moves again: it was hit, or what it lies with, or a command woke it
  add,     ///< a command added a ball
  remove,  ///< a command removed a ball
  set      ///< a command changed effects or the step
};

/// The side of the box that a wall is.
enum class Side : std::uint8_t { none, left, right, bottom, top };

/// One impact, or one contact of a joint one, or a command: what there is to know of it afterwards.
///
/// Holds: of two balls, `a` has the lower number; n points from a to b, at a wall outwards.  b
/// gains impulse * n + tangential * t with t = (-n_y, n_x), and a loses it.
struct Impact {
  static constexpr std::size_t kNoBall = static_cast<std::size_t>(-1);

  std::uint64_t event = 0;  ///< counted from 0; the contacts of a joint one share it
  double time = 0;
  ImpactKind kind = ImpactKind::ball;
  std::size_t a = kNoBall;  ///< numbers as of Simulation::ids
  std::size_t b = kNoBall;  ///< kNoBall at a wall
  Side wall = Side::none;
  Vec2 position{0, 0};     ///< of ball a
  Vec2 normal{0, 0};       ///< a unit vector; 0 where there is no contact
  double distance = 0;     ///< of the centres, or of the centre from the wall
  double impulse = 0;      ///< along n, not negative
  double tangential = 0;   ///< along t, by friction
  double energy_lost = 0;  ///< by restitution and friction
};

/// The order of a record of events: by time, then the balls, then the wall, then what happened.
[[nodiscard]] bool is_before(const Impact& one, const Impact& other);

}  // namespace carom
