#include "solvers/event/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/event_flight.hpp"
#include "contact/event_impulse.hpp"
#include "contact/event_pair_time.hpp"
#include "contact/event_peg_time.hpp"
#include "contact/event_wall_time.hpp"
#include "solvers/event/lanes.hpp"

namespace carom::event {
namespace {

Flight<double> flight(const Disk& disk) {
  return {{disk.x, disk.y}, {disk.vx, disk.vy}};
}

}  // namespace

Motion::Motion(Rules rules)
    : rules_(std::move(rules)), falls_(rules_.gravity[0] != 0 || rules_.gravity[1] != 0) {
  for (const Kind& kind : rules_.kinds) largest_radius_ = std::max(largest_radius_, kind.radius);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double period = rules_.domain.period[axis];
    periods_[axis] = period > 0 ? period : std::numeric_limits<double>::infinity();
    // Two balls whose nearest images do not meet while each goes this far meet in no other image.
    reach_[axis] = std::min(period / 8, (period / 2 - 2 * largest_radius_) * 0.4375);
  }
}

Vec<double> Motion::place(const Disk& disk, Ticks now) const {
  const double elapsed = rules_.scale.seconds(now - disk.start);
  if (!falls_) return {disk.x + disk.vx * elapsed, disk.y + disk.vy * elapsed};
  if (fixed(disk)) return {disk.x, disk.y};
  const BallisticLaw<double> law{{rules_.gravity[0], rules_.gravity[1]}};
  return Vec<double>{disk.x, disk.y} + law.displacement(flight(disk), elapsed);
}

Vec<double> Motion::velocity(const Disk& disk, Ticks now) const {
  if (!falls_ || fixed(disk)) return {disk.vx, disk.vy};
  const double elapsed = rules_.scale.seconds(now - disk.start);
  return {disk.vx + rules_.gravity[0] * elapsed, disk.vy + rules_.gravity[1] * elapsed};
}

Vec<double> Motion::way(const Vec<double>& a, const Vec<double>& b) const {
  return {nearest(b.x - a.x, periods_[0], periods_[0] / 2),
          nearest(b.y - a.y, periods_[1], periods_[1] / 2)};
}

Vec<double> Motion::wrapped(const Vec<double>& at) const {
  const Domain& domain = rules_.domain;
  return {domain.period[0] > 0 ? domain.wrapped(0, at.x) : at.x,
          domain.period[1] > 0 ? domain.wrapped(1, at.y) : at.y};
}

Ticks Motion::pair_meets(const Disk& a, const Disk& b, bool from_contact) const {
  const bool swap = b.start < a.start;
  const Disk& earlier = swap ? b : a;
  const Disk& later = swap ? a : b;
  const double elapsed = rules_.scale.seconds(later.start - earlier.start);
  const double reach = kind(a).radius + kind(b).radius;
  double wait = 0;
  if (falls_ && (fixed(a) || fixed(b))) {
    const Disk& ball = fixed(a) ? b : a;
    const Disk& peg = fixed(a) ? a : b;
    const Vec<double> r = way({peg.x, peg.y}, {ball.x, ball.y});
    wait = peg_time(r, Vec<double>{ball.vx, ball.vy},
                    Vec<double>{rules_.gravity[0], rules_.gravity[1]}, reach, from_contact);
    const Ticks ticks = rules_.scale.ticks(wait);
    return ticks == kNever ? kNever : ball.start + ticks;
  }
  Relative<double> relative{};
  if (falls_) {
    const BallisticLaw<double> law{{rules_.gravity[0], rules_.gravity[1]}};
    relative = relative_at_later_start(law, flight(earlier), elapsed, flight(later));
  } else {
    relative =
        relative_at_later_start(StraightLaw<double>{}, flight(earlier), elapsed, flight(later));
  }
  relative.r.x = nearest(relative.r.x, periods_[0], periods_[0] / 2);
  relative.r.y = nearest(relative.r.y, periods_[1], periods_[1] / 2);
  wait = pair_time(relative.r, relative.v, reach);
  const Ticks ticks = rules_.scale.ticks(wait);
  return ticks == kNever ? kNever : later.start + ticks;
}

Motion::Wall Motion::wall(const Disk& disk, const Vec<double>& at, Index wall) const {
  const std::size_t axis = (wall - kWalls) / 2;
  const double x = axis == 0 ? at.x : at.y;
  const double radius = kind(disk).radius;
  if ((wall - kWalls) % 2 == 0) {
    const double stop = rules_.domain.lowest(axis, radius);
    return {x - stop, stop};
  }
  const double stop = rules_.domain.highest(axis, radius);
  return {stop - x, stop};
}

Ticks Motion::wall_meets(const Disk& disk, Index wall) const {
  const std::size_t axis = (wall - kWalls) / 2;
  const double sign = (wall - kWalls) % 2 == 0 ? 1 : -1;
  const double gap = this->wall(disk, {disk.x, disk.y}, wall).gap;
  const double v = axis == 0 ? disk.vx : disk.vy;
  const Ticks wait = rules_.scale.ticks(wall_time(gap, sign * v, sign * rules_.gravity[axis]));
  return wait == kNever ? kNever : disk.start + wait;
}

Meeting Motion::wall_meeting(const Disk& disk, std::size_t axis) const {
  const double x = axis == 0 ? disk.x : disk.y;
  const double v = axis == 0 ? disk.vx : disk.vy;
  const double a = rules_.gravity[axis];
  const double radius = kind(disk).radius;
  const double below = x - rules_.domain.lowest(axis, radius);
  const double above = rules_.domain.highest(axis, radius) - x;
  const double low = wall_time(below, v, a);
  const double high = wall_time(above, -v, -a);
  const Ticks wait = rules_.scale.ticks(std::min(low, high));
  if (wait == kNever) return {};
  const auto side = static_cast<Index>(2 * axis) + (high < low ? 1U : 0U);
  return {disk.start + wait, kWalls + side};
}

Meeting Motion::alone(const Disk& disk) const {
  Meeting first{disk.start + kLongestFlight, kCarry};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (rules_.domain.solid(axis)) {
      const Meeting wall = wall_meeting(disk, axis);
      if (wall.time < first.time) first = wall;
    } else if (rules_.domain.period[axis] > 0) {
      const double speed = std::abs(axis == 0 ? disk.vx : disk.vy);
      const double a = std::abs(rules_.gravity[axis]);
      const double longest =
          2 * reach_[axis] / (speed + std::sqrt(speed * speed + 2 * a * reach_[axis]));
      const Ticks wait = rules_.scale.ticks(longest);
      if (wait != kNever && disk.start + wait < first.time) first = {disk.start + wait, kCarry};
    }
  }
  return first;
}

void Motion::carry(Disk& disk, Ticks now) const {
  const Vec<double> at = wrapped(place(disk, now));
  const Vec<double> v = velocity(disk, now);
  disk.x = at.x;
  disk.y = at.y;
  disk.vx = v.x;
  disk.vy = v.y;
  disk.start = now;
}

void Motion::bounce(Disk& disk, Index wall, Ticks now) const {
  const std::size_t axis = (wall - kWalls) / 2;
  const bool upper = (wall - kWalls) % 2 == 1;
  const double radius = kind(disk).radius;
  const double stop =
      upper ? rules_.domain.highest(axis, radius) : rules_.domain.lowest(axis, radius);
  const double sign = upper ? -1 : 1;
  double& x = axis == 0 ? disk.x : disk.y;
  double& v = axis == 0 ? disk.vx : disk.vy;
  const double arrival =
      wall_arrival_velocity(sign * (x - stop), sign * v, sign * rules_.gravity[axis]);
  carry(disk, now);
  x = stop;
  v = sign * wall_impact(arrival, rules_.wall_restitution);
}

double Motion::strike(Disk& a, Disk& b, Ticks now) const {
  const Kind& ka = kind(a);
  const Kind& kb = kind(b);
  if (!ka.fixed()) carry(a, now);
  if (!kb.fixed()) carry(b, now);
  const Vec<double> r = way({a.x, a.y}, {b.x, b.y});
  const Velocities<double> after =
      pair_impact(r, Vec<double>{a.vx, a.vy}, Vec<double>{b.vx, b.vy}, ka.inverse_mass,
                  kb.inverse_mass, rules_.restitution);
  a.vx = after.a.x;
  a.vy = after.a.y;
  b.vx = after.b.x;
  b.vy = after.b.y;
  const double reach = ka.radius + kb.radius;
  const double square = r.x * r.x + r.y * r.y;
  if (!(square < reach * reach)) return 0;
  return (reach - std::sqrt(square)) / std::min(ka.radius, kb.radius);
}

}  // namespace carom::event
