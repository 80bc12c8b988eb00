#include "effects/friction.hpp"

#include <algorithm>
#include <cmath>

#include "contact/dissipation.hpp"

namespace carom::effects {
namespace {

double cut_off(double impulse, double most) {
  return std::clamp(impulse, -most, most);
}

// The impulse by mass along t with which a wall answers a ball that slips along it.
double wall_impulse(double along, double surface, double normal, double coefficient) {
  return cut_off((along + surface) / 3, coefficient * std::abs(normal));
}

}  // namespace

FrictionChange apply_friction(Member& a, Member& b, const LineOfCentres& line, double normal,
                              double coefficient) {
  const Vec2 t = Vec2{-line.r.y(), line.r.x()} / line.length;
  const double slip = (b.velocity - a.velocity).dot(t) - (a.radius * a.spin + b.radius * b.spin);
  const double inverse_masses = a.inverse_mass + b.inverse_mass;
  const double impulse = cut_off(-slip / (3 * inverse_masses), coefficient * normal);
  a.velocity -= impulse * a.inverse_mass * t;
  b.velocity += impulse * b.inverse_mass * t;
  a.spin -= 2 * impulse * a.inverse_mass / a.radius;
  b.spin -= 2 * impulse * b.inverse_mass / b.radius;
  return {impulse, lost_to_friction(slip, impulse, inverse_masses)};
}

FrictionChange apply_wall_friction(Member& member, std::size_t axis, double normal,
                                   double coefficient) {
  const double outwards = normal < 0 ? -1 : 1;
  // n = (outwards, 0) gives t = (0, outwards), n = (0, outwards) gives t = (-outwards, 0).
  const double t = axis == 0 ? outwards : -outwards;
  double& along = member.velocity[1 - axis];
  const double surface = member.radius * member.spin;
  const double slip = -(along * t + surface);
  const double impulse = wall_impulse(along * t, surface, normal, coefficient);
  along -= impulse * t;
  member.spin -= 2 * impulse / member.radius;
  return {impulse, lost_to_friction(slip, impulse, 1)};
}

void apply_wall_frictions(Balls& balls, std::size_t begin, std::size_t count, const Struck& struck,
                          double coefficient, double* lost, FrictionBlock* by_friction) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t k = 0; k < count; ++k) {
      const double normal = struck.normal[axis][k];
      if (normal == 0) continue;
      const std::size_t i = begin + k;
      Member member;
      member.velocity = {balls.velocity[0][i], balls.velocity[1][i]};
      member.radius = balls.radius[i];
      member.spin = balls.spin[i];
      const FrictionChange here = apply_wall_friction(member, axis, normal, coefficient);
      lost[k] += balls.mass[i] * here.lost;
      if (by_friction != nullptr) (*by_friction)[axis][k] = here;
      balls.velocity[1 - axis][i] = member.velocity[1 - axis];
      balls.spin[i] = member.spin;
    }
  }
}

}  // namespace carom::effects
