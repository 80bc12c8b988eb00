#include "contact/island_friction.hpp"

#include <algorithm>

namespace carom::contact {

double slip_of(const IslandContact& contact, const SurfaceMotion& a, const SurfaceMotion& b) {
  const Vec2 along{-contact.normal.y(), contact.normal.x()};
  return along.dot(b.velocity - a.velocity) - a.turning - b.turning;
}

// Of uniform disks an impulse changes the spin times the radius twice as much as the velocity.
double friction_against(double slip, double most, double fading) {
  return std::clamp(-slip / (2 + fading), -most, most);
}

}  // namespace carom::contact
