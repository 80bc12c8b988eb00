#include "contact/island_friction.hpp"

#include <algorithm>

namespace carom::contact {

double slip_of(const IslandContact& contact, const SurfaceMotion& a, const SurfaceMotion& b) {
  const Vec2 along{-contact.normal.y(), contact.normal.x()};
  return along.dot(b.velocity - a.velocity) - a.turning - b.turning;
}

// Of uniform disks a third of an impulse goes to the centre, two thirds to the spin.
double friction_against(double slip, double most) {
  return std::clamp(-slip / 3, -most, most);
}

}  // namespace carom::contact
