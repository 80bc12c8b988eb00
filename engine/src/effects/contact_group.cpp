#include "effects/contact_group.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/dissipation.hpp"
#include "effects/friction.hpp"
#include "effects/rest.hpp"
#include "state/stopwatch.hpp"

namespace carom::effects {
namespace {

bool at_side(const Member& member, const Domain& domain, std::size_t axis, double outwards) {
  const double x = member.position[axis];
  return outwards < 0 ? x <= domain.lowest(axis, member.radius)
                      : x >= domain.highest(axis, member.radius);
}

double inside(const Member& member, const Domain& domain, std::size_t axis) {
  const double x = member.position[axis];
  if (!domain.solid(axis)) return x;
  return std::clamp(x, domain.lowest(axis, member.radius), domain.highest(axis, member.radius));
}

// A fixed ball, or one that is at a wall.
bool held(const Member& member, const Domain& domain) {
  if (member.inverse_mass == 0) return true;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain.solid(axis)) continue;
    if (at_side(member, domain, axis, -1) || at_side(member, domain, axis, 1)) return true;
  }
  return false;
}

}  // namespace

void ContactGroup::load(const Balls& balls, std::span<const Pair> pairs, const Domain& domain,
                        double step) {
  members.clear();
  contacts.clear();
  spins = balls.spin.size() > 0;
  pulled = balls.pull[0].size() > 0;
  for (const Pair& pair : pairs) {
    for (const std::uint32_t ball : {pair.first, pair.second}) {
      const std::size_t k = ball;
      Member member;
      member.ball = ball;
      member.position = member.start = balls.at(ball);
      member.velocity = {balls.velocity[0][k], balls.velocity[1][k]};
      member.radius = balls.radius[k];
      member.mass = balls.mass[k];
      member.inverse_mass = balls.inverse_mass[k];
      if (spins) member.spin = balls.spin[k];
      if (pulled) member.pull = {balls.pull[0][k], balls.pull[1][k]};
      members.push_back(member);
    }
  }
  const auto before = [](const Member& m, const Member& n) { return m.ball < n.ball; };
  if (pairs.size() > 1) {
    std::sort(members.begin(), members.end(), before);
    const auto same = [](const Member& m, const Member& n) { return m.ball == n.ball; };
    members.erase(std::unique(members.begin(), members.end(), same), members.end());
  }
  const auto place = [this](std::uint32_t ball) {
    const auto at = std::lower_bound(members.begin(), members.end(), ball,
                                     [](const Member& m, std::uint32_t b) { return m.ball < b; });
    return static_cast<std::uint32_t>(at - members.begin());
  };
  for (const Pair& pair : pairs) {
    Contact contact;
    contact.a = place(pair.first);
    contact.b = place(pair.second);
    const Member& a = members[contact.a];
    const Member& b = members[contact.b];
    const Vec2 r = apart(contact, domain);
    const Vec2 velocity = b.velocity - a.velocity;
    contact.line = line_of_centres(r, velocity);
    contact.inverse_masses = a.inverse_mass + b.inverse_mass;
    contact.reach = a.radius + b.radius;
    contact.touching = contact.line.distance < contact.reach;
    if (contact.touching && !pulled) see_whether_passed(contact, r, velocity, step);
    contacts.push_back(contact);
  }
  if (contacts.size() > 1) put_in_order();
  bound = std::any_of(members.begin(), members.end(),
                      [&](const Member& member) { return held(member, domain); });
}

// Two that were so fast meet where they touched on their straight ways, and are moved apart to the
// sides they came from.
void ContactGroup::see_whether_passed(Contact& contact, const Vec2& r, const Vec2& velocity,
                                      double step) const {
  const Vec2 way = step * velocity;
  const Vec2 before = r - way;
  const double most = 2 * contact.reach;
  if (!(before.dot(r) < 0) || way.squaredNorm() > most * most) return;
  const double closing = before.dot(way);
  const double gap = before.squaredNorm() - contact.reach * contact.reach;
  const double square = closing * closing - way.squaredNorm() * gap;
  const double part = gap > 0 && square > 0 ? gap / (std::sqrt(square) - closing) : 0.0;
  contact.line = line_of_centres(before + part * way, velocity);
  contact.passed = true;
}

// By what neither a mirror nor another order of the balls changes.
void ContactGroup::put_in_order() {
  const auto closing = [this](const Contact& contact) {
    const Vec2 parting = members[contact.b].velocity - members[contact.a].velocity;
    return parting.dot(contact.line.r) / contact.line.length;
  };
  std::stable_sort(contacts.begin(), contacts.end(), [&](const Contact& one, const Contact& two) {
    const auto key = [&](const Contact& contact) {
      return std::tuple(contact.line.distance, closing(contact), contact.inverse_masses,
                        contact.reach);
    };
    return key(one) < key(two);
  });
}

void ContactGroup::store(Balls& balls, const Domain& domain, Turns& turns) const {
  for (const Member& member : members) {
    if (member.inverse_mass == 0) continue;
    const std::size_t k = member.ball;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = inside(member, domain, axis);
      const double image = domain.period[axis] > 0 ? domain.wrapped(axis, x) : x;
      if (image != x && !turns[axis].empty()) {
        turns[axis][k] += static_cast<std::int64_t>(std::rint((x - image) / domain.period[axis]));
      }
      balls.position[axis][k] = image;
      balls.velocity[axis][k] = member.velocity[axis];
    }
    if (spins) balls.spin[k] = member.spin;
  }
}

Vec2 ContactGroup::apart(const Contact& contact, const Domain& domain) const {
  return nearest_image(members[contact.b].position - members[contact.a].position, domain);
}

void ContactGroup::touch_all() {
  for (Contact& contact : contacts) contact.touching = true;
}

double ContactGroup::farthest_push() const {
  double square = 0;
  for (const Member& member : members) {
    square = std::max(square, (member.position - member.start).squaredNorm());
  }
  return std::sqrt(square);
}

double ContactGroup::kinetic_energy() const {
  double sum = 0;
  for (const Member& member : members) sum += member.mass * member.velocity.squaredNorm() / 2;
  if (!spins) return sum;
  for (const Member& member : members) {
    const double speed = member.radius * member.spin;
    sum += member.mass * speed * speed / 4;
  }
  return sum;
}

double ContactGroup::lifting_work(const Vec2& acceleration) const {
  return -sum_over_members([&](const Member& member) {
    return member.mass * acceleration.dot(member.position - member.start);
  });
}

void ContactGroup::keep_inside(Member& member, const Domain& domain) {
  if (member.inverse_mass == 0) return;
  const Vec2 place{inside(member, domain, 0), inside(member, domain, 1)};
  if (place == member.position) return;
  // Even if the ball is moved away from the wall again later on, the wall has held it.
  bound = true;
  member.position = place;
}

bool ContactGroup::collide(Contact& contact, const Domain& domain, const CollisionRule& rule,
                           ImpactCount& count) {
  if (!contact.touching) return false;
  if (pulled) return collide_under_pull(contact, domain, rule, count);
  const Member& a = members[contact.a];
  const Member& b = members[contact.b];
  const LineOfCentres& line = contact.line;
  const double closing = (b.velocity - a.velocity).dot(line.r);
  if (!approaches(closing, line.length, a.velocity, b.velocity)) return false;
  Exchange exchanged;
  exchanged.bounces = true;
  exchanged.j = impulse(closing, line.square, contact.inverse_masses, rule.restitution);
  exchanged.arrival = -closing / line.length;
  exchanged.leaving = rule.restitution * exchanged.arrival;
  exchange(contact, exchanged, domain, rule, count);
  return true;
}

bool ContactGroup::collide_under_pull(Contact& contact, const Domain& domain,
                                      const CollisionRule& rule, ImpactCount& count) {
  const Member& a = members[contact.a];
  const Member& b = members[contact.b];
  const LineOfCentres& line = contact.line;
  // Towards each other; half a step of the pull is still to come.
  const double pull = -(b.pull - a.pull).dot(line.r) / line.length;
  const double half = pull * rule.step / 2;
  const double approach = -(b.velocity - a.velocity).dot(line.r) / line.length;
  const double speed = approach + half;
  if (!approaches(-speed, 1, a.velocity, b.velocity)) return false;
  // They met when they touched, with less than the pull has made of it since.
  const double depth = contact.met ? 0 : contact.reach - line.distance;
  const double arrival = std::sqrt(std::max(0.0, speed * speed - 2 * pull * depth));
  contact.met = true;
  const bool bounces = arrival > rest_speed(pull, rule.step, rule.restitution);
  const double leaving = bounces ? rule.restitution * arrival : 0;
  const double change = approach + leaving + half;
  if (!(change > 0)) return false;
  const double j = change / (line.length * contact.inverse_masses);
  exchange(contact, {j, arrival, leaving, bounces}, domain, rule, count);
  return true;
}

void ContactGroup::exchange(const Contact& contact, const Exchange& exchanged, const Domain& domain,
                            const CollisionRule& rule, ImpactCount& count) {
  Member& a = members[contact.a];
  Member& b = members[contact.b];
  const LineOfCentres& line = contact.line;
  a.velocity -= exchanged.j * a.inverse_mass * line.r;
  b.velocity += exchanged.j * b.inverse_mass * line.r;
  FrictionChange by_friction;
  if (rule.friction > 0) {
    const Stopwatch stopwatch(count.timed, count.friction_seconds);
    by_friction = apply_friction(a, b, line, exchanged.j * line.length, rule.friction);
  }
  if (exchanged.bounces) ++count.ball_ball;
  by_friction.lost +=
      lost_to_restitution(exchanged.arrival, exchanged.leaving, contact.inverse_masses);
  count.lost += by_friction.lost;
  if (count.log.wanted) {
    Impact& impact = note(contact, exchanged.j * line.length, by_friction, count.log);
    if (exchanged.bounces) impact.kind = ImpactKind::ball;
  }
  rebound(a, domain, rule, count);
  rebound(b, domain, rule, count);
}

Impact& ContactGroup::note(const Contact& contact, double normal, const FrictionChange& by_friction,
                           ImpactLog& log) const {
  Impact& impact = log.impacts.emplace_back();
  impact.time = log.time;
  impact.kind = ImpactKind::rest;
  impact.a = members[contact.a].ball;
  impact.b = members[contact.b].ball;
  impact.position = members[contact.a].position;
  impact.normal = contact.line.r / contact.line.length;
  impact.distance = contact.line.distance;
  impact.impulse = normal;
  impact.tangential = by_friction.impulse;
  impact.energy_lost = by_friction.lost;
  return impact;
}

bool ContactGroup::separate(const Contact& contact, const Domain& domain, double share_a,
                            double share_b) {
  constexpr double kClose = 0x1p-40;  // of the sum of the radii: as good as apart
  const Vec2 r = apart(contact, domain);
  const double along = r.dot(contact.line.r) / contact.line.length;
  // Where the centres coincide, or have passed each other, on the sides they came from: their
  // velocities have turned by now.
  const bool as_met = contact.passed || !(along > 0);
  const double square = as_met ? along * std::abs(along) : r.squaredNorm();
  const double close = contact.reach * (1 - kClose);
  if (square >= close * close) return false;
  Member& a = members[contact.a];
  Member& b = members[contact.b];
  const LineOfCentres line = as_met ? contact.line : line_of_centres(r, {0, 0});
  const double depth = contact.reach - (as_met ? along : line.distance);
  const Vec2 move = depth / line.length * line.r;
  a.position -= share_a * move;
  b.position += share_b * move;
  keep_inside(a, domain);
  keep_inside(b, domain);
  return true;
}

void note_wall(const WallImpact& met, std::size_t axis, const Member& ball,
               const FrictionChange& by_friction, ImpactLog& log) {
  Impact& impact = log.impacts.emplace_back();
  impact.time = log.time;
  impact.kind = met.bounces ? ImpactKind::wall : ImpactKind::rest;
  impact.a = ball.ball;
  impact.wall = side_of(axis, met.upper);
  impact.position = ball.position;
  impact.normal[axis] = met.upper ? 1 : -1;
  impact.distance = ball.radius;
  impact.impulse = ball.mass * met.impulse;
  impact.tangential = ball.mass * by_friction.impulse;
  impact.energy_lost =
      ball.mass * (lost_to_restitution(met.arrival, met.leaving, 1) + by_friction.lost);
}

void ContactGroup::rebound(Member& member, const Domain& domain, const CollisionRule& rule,
                           ImpactCount& count) {
  if (member.inverse_mass == 0) return;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain.solid(axis)) continue;
    double& v = member.velocity[axis];
    if (v == 0) continue;
    const double outwards = v < 0 ? -1 : 1;
    if (!at_side(member, domain, axis, outwards)) continue;
    const double normal = v * (1 + rule.wall_restitution);
    const double arrival = std::abs(v);
    v *= -rule.wall_restitution;
    FrictionChange by_friction;
    if (rule.wall_friction > 0) {
      const Stopwatch stopwatch(count.timed, count.friction_seconds);
      by_friction = apply_wall_friction(member, axis, normal, rule.wall_friction);
    }
    ++count.ball_wall;
    count.lost += member.mass * (by_friction.lost + lost_to_restitution(arrival, v, 1));
    if (!count.log.wanted) continue;
    const WallImpact met{member.ball, outwards > 0, true, arrival, std::abs(v), std::abs(normal)};
    note_wall(met, axis, member, by_friction, count.log);
  }
}

}  // namespace carom::effects
