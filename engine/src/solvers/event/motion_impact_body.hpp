#pragma once

#include <algorithm>
#include <limits>

#include "contact/dissipation.hpp"
#include "contact/pair_friction.hpp"
#include "contact/pair_impact.hpp"
#include "contact/rest_rules.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

// What impacts do to flights: at a wall, and of two balls.

template <class P>
double Motion<P>::bounce(Disk& disk, S* spin, Index wall, At now) const {
  const std::size_t axis = (wall - kWalls) / 2;
  const bool upper = (wall - kWalls) % 2 == 1;
  const S& radius = species(disk).radius;
  const S stop = upper ? box_.highest(axis, radius) : box_.lowest(axis, radius);
  const int side = upper ? -1 : 1;
  S& x = axis == 0 ? disk.x : disk.y;
  S& v = axis == 0 ? disk.vx : disk.vy;
  const S arrival = law_of(disk).wall_arrival(axis, side, S(side * (x - stop)), S(side * v),
                                              rules_.scale.seconds(now - disk.start));
  carry(disk, now, spin);
  double lost = 0;
  if (spin != nullptr) lost = apply_wall_friction(disk, *spin, axis, side, arrival);
  x = stop;
  v = with_plain_zero(S(side * wall_impact(arrival, S(rules_.wall_restitution))));
  if (rules_.wall_restitution < 1) {
    const auto speed = static_cast<double>(arrival);
    lost += lost_to_restitution(speed, rules_.wall_restitution * speed,
                                static_cast<double>(species(disk).inverse_mass));
  }
  return lost;
}

template <class P>
double Motion<P>::end_bounce(Disk& disk, Index wall) const {
  const std::size_t axis = (wall - kWalls) / 2;
  const int side = (wall - kWalls) % 2 == 1 ? -1 : 1;
  S& v = axis == 0 ? disk.vx : disk.vy;
  const S pressing = -side * law_.pull(axis);
  S& along = axis == 0 ? disk.vy : disk.vx;
  const S noise = kRounding * std::numeric_limits<S>::epsilon();
  const bool ends = elastic_ ? barely_bounces(S(side * v), pressing, S(2 * species(disk).radius))
                             : !(absolute(v) > noise * absolute(along));
  if (!ends) return 0;
  if (elastic_ && along != 0) {
    const S speed = root(S(along * along + v * v));
    along = along > 0 ? speed : S(-speed);
    v = 0;
    return 0;
  }
  const double lost = moving_energy(disk, v);
  v = 0;
  return lost;
}

template <class P>
double Motion<P>::moving_energy(const Disk& disk, const S& speed) const {
  return lost_to_restitution(static_cast<double>(speed), 0,
                             static_cast<double>(species(disk).inverse_mass));
}

template <class P>
FrictionBody<typename P::Scalar> Motion<P>::friction_body(const Disk& disk, const S& spin) const {
  return {{disk.vx, disk.vy}, spin, species(disk).radius, species(disk).inverse_mass};
}

// Before the normal impulse, which then has the last word on whether the two still approach.
template <class P>
double Motion<P>::apply_friction(Disk& a, S& spin_a, Disk& b, S& spin_b, const Vec<S>& r) const {
  const FrictionBody<S> one = friction_body(a, spin_a);
  const FrictionBody<S> other = friction_body(b, spin_b);
  const S approach = approach_speed(r, other.velocity - one.velocity);
  if (!(approach > 0) || (species(a).fixed() && species(b).fixed())) return 0;
  const FrictionImpact<S> friction(one, other, r, S((1 + S(rules_.restitution)) * approach),
                                   S(rules_.friction));
  const auto take = [](Disk& disk, S& spin, const FrictionChange<S>& got) {
    disk.vx += got.velocity.x;
    disk.vy += got.velocity.y;
    spin += got.spin;
  };
  take(a, spin_a, friction.on(one, -1, S(1)));
  take(b, spin_b, friction.on(other, 1, S(1)));
  return friction.loss();
}

template <class P>
double Motion<P>::apply_wall_friction(Disk& disk, S& spin, std::size_t axis, int side,
                                      const S& arrival) const {
  const FrictionBody<S> ball = friction_body(disk, spin);
  const FrictionBody<S> wall{{S(0), S(0)}, S(0), S(0), S(0)};
  const Vec<S> towards = axis == 0 ? Vec<S>{S(-side), S(0)} : Vec<S>{S(0), S(-side)};
  const FrictionImpact<S> friction(
      ball, wall, towards, S((1 + S(rules_.wall_restitution)) * -arrival), S(rules_.wall_friction));
  const FrictionChange<S> got = friction.on(ball, -1, S(1));
  (axis == 0 ? disk.vy : disk.vx) += axis == 0 ? got.velocity.y : got.velocity.x;
  spin += got.spin;
  return friction.loss();
}

template <class P>
auto Motion<P>::strike(Disk& a, S* spin_a, Disk& b, S* spin_b, At now) const -> Strike {
  const Species& ka = species(a);
  const Species& kb = species(b);
  if (!ka.fixed()) carry(a, now, spin_a);
  if (!kb.fixed()) carry(b, now, spin_b);
  const Vec<S> r = way({a.x, a.y}, {b.x, b.y});
  double lost = 0;
  if (spin_a != nullptr) lost = apply_friction(a, *spin_a, b, *spin_b, r);
  const Vec<S> before = Vec<S>{b.vx, b.vy} - Vec<S>{a.vx, a.vy};
  double restitution = rules_.restitution;
  Velocities<S> after = pair_impact(r, Vec<S>{a.vx, a.vy}, Vec<S>{b.vx, b.vy}, ka.inverse_mass,
                                    kb.inverse_mass, S(rules_.restitution));
  if (clusters() && rules_.restitution < 1 &&
      stays_together(r, after.b - after.a, S(ka.radius + kb.radius))) {
    after = pair_impact(r, Vec<S>{a.vx, a.vy}, Vec<S>{b.vx, b.vy}, ka.inverse_mass, kb.inverse_mass,
                        S(0));
    restitution = 0;
  }
  a.vx = after.a.x;
  a.vy = after.a.y;
  b.vx = after.b.x;
  b.vy = after.b.y;
  if (restitution < 1) {
    const S speed = approach_speed(r, before);
    const S inverse_masses = ka.inverse_mass + kb.inverse_mass;
    if (speed > 0 && inverse_masses > 0) {
      const auto approach = static_cast<double>(speed);
      lost += lost_to_restitution(approach, restitution * approach,
                                  static_cast<double>(inverse_masses));
    }
  }
  const S reach = ka.radius + kb.radius;
  const S square = r.x * r.x + r.y * r.y;
  if (!(square < reach * reach)) return {0, lost};
  const S depth = (reach - root(square)) / std::min(ka.radius, kb.radius);
  return {static_cast<double>(depth), lost};
}

}  // namespace carom::event
