#pragma once

#include <optional>

#include "carom/vector.hpp"

namespace carom {

/// The solid, non-periodic sides of the box.
struct Walls {
  double restitution = 1;
};

/// Balls collide with each other.
struct Collisions {
  double restitution = 1;
};

/// A uniform acceleration, lengths per second squared.
struct Gravity {
  Vec2 acceleration{0, -9.81};
};

/// dv/dt = -rate v, the same rate (1/s) for every ball.
struct Drag {
  double rate = 0;
};

/// Coulomb friction at impacts; balls carry spin.
struct Friction {
  double balls = 0;
  double walls = 0;
};

/// Every ball attracts every other; a negative strength repels.
struct Attraction {
  double strength = 0;
  double softening = 0;
};

/// The whole list of what is simulated: an effect that is not named is not simulated.
struct Effects {
  std::optional<Walls> walls;
  std::optional<Collisions> collisions;
  std::optional<Gravity> gravity;
  std::optional<Drag> drag;
  std::optional<Friction> friction;
  std::optional<Attraction> attraction;
};

}  // namespace carom
