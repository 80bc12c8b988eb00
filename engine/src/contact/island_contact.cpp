#include "contact/island_contact.hpp"

#include <algorithm>
#include <cmath>

namespace carom::contact {
namespace {

constexpr double kApart = 0x1p-8;  // of the rule's speed: how fast what overlaps comes apart
const Vec2 kStill{0, 0};

double opening(const IslandContact& c, const Vec2& a, const Vec2& b) {
  return c.b < 0 ? -c.normal.dot(a) : c.normal.dot(b - a);
}

double opening_before(const std::vector<IslandBody>& bodies, const IslandContact& c) {
  return opening(c, bodies[index(c.a)].before, c.b < 0 ? kStill : bodies[index(c.b)].before);
}

}  // namespace

double opening_of(const std::vector<Vec2>& motion, const IslandContact& c) {
  return opening(c, motion[index(c.a)], c.b < 0 ? kStill : motion[index(c.b)]);
}

double arrival(const std::vector<IslandBody>& bodies, const IslandContact& c,
               const IslandStep::Rule& rule) {
  const double closing = -opening_before(bodies, c);
  if (!(closing > 0)) return closing;
  const IslandBody& a = bodies[index(c.a)];
  const double pull = c.b < 0 ? acceleration_of(a, rule).dot(c.normal)
                              : (a.pull - bodies[index(c.b)].pull).dot(c.normal);
  if (c.b >= 0 && pull == 0) return closing;
  return std::sqrt(std::max(closing * closing + 2 * pull * std::max(c.gap, 0.0), 0.0));
}

bool bounces(const std::vector<IslandBody>& bodies, const IslandContact& c,
             const IslandStep::Rule& rule) {
  if (c.restitution == 0) return false;
  const double closing = -opening_before(bodies, c);
  const double speed = arrival(bodies, c, rule);
  return speed > rule.rest_speed && c.gap - rule.step * std::max(closing, speed) < 0;
}

double closing_room(const IslandContact& c, const IslandStep::Rule& rule, double tolerated,
                    double apart) {
  const double way = rule.speed * rule.step;
  if (c.gap > -tolerated * way && c.gap < kClosed * way) return 0;
  return std::max(c.gap / rule.step, -apart);
}

double mean_speed(const std::vector<IslandBody>& bodies, bool held) {
  double mass = 0;
  Vec2 momentum{0, 0};
  for (const IslandBody& body : bodies) {
    mass += 1 / body.inverse_mass;
    momentum += body.before / body.inverse_mass;
  }
  const Vec2 frame = held ? Vec2{0, 0} : momentum / mass;
  double twice = 0;
  for (const IslandBody& body : bodies) {
    const double square = (body.before - frame).squaredNorm() + body.turning * body.turning / 2;
    twice += square / body.inverse_mass;
  }
  return std::sqrt(twice / mass);
}

double apart_speed(double moving, const IslandStep::Rule& rule) {
  const double part = std::min(moving / rule.speed, 1.0);
  return kApart * rule.speed * part * part;
}

}  // namespace carom::contact
