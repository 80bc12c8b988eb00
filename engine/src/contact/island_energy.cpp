#include "contact/island_energy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/island_contact.hpp"

namespace carom::contact {
namespace {

constexpr double kRoundingOfGain = 0x1p-44;
// Of the kinetic energy, for what solutions are inexact to: what hardly moves must not stop.
constexpr double kPaidAtMost = 0x1p-20;

/// The kinetic energy relative to the velocity `frame`.
double moving_energy(const std::vector<IslandBody>& bodies, const IslandOutcome& outcome,
                     const Vec2& frame) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double turning = outcome.turning[i];
    const double twice = (outcome.after[i] - frame).squaredNorm() + turning * turning / 2;
    sum += twice / 2 / bodies[i].inverse_mass;
  }
  return sum;
}

void scale_velocities(double part, const Vec2& frame, IslandOutcome& outcome) {
  for (Vec2& v : outcome.after) v = frame + part * (v - frame);
  for (double& turning : outcome.turning) turning *= part;
}

Vec2 mean_by_mass(const std::vector<IslandBody>& bodies, const std::vector<Vec2>& motion) {
  Vec2 sum{0, 0};
  double mass = 0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    sum += motion[i] / bodies[i].inverse_mass;
    mass += 1 / bodies[i].inverse_mass;
  }
  return sum / mass;
}

// The velocity that all have in common along the axes that are open.
Vec2 drift_of(const std::vector<IslandBody>& bodies, const std::vector<Vec2>& motion,
              const Vec2& open) {
  if (open == Vec2{0, 0}) return {0, 0};
  const Vec2 mean = mean_by_mass(bodies, motion);
  return {open.x() * mean.x(), open.y() * mean.y()};
}

// The root, not below 0, of square x^2 + linear x = value: the value is not below 0, and one of the
// other two is above it.  Nothing in it can become too small or too large for a number.
double larger_root(double square, double linear, double value) {
  const double unit = std::max({square, std::abs(linear), value});
  const double a = square / unit;
  const double b = linear / unit;
  const double c = value / unit;
  const double root = std::sqrt(b * b + 4 * a * c);
  return b > 0 ? 2 * c / (b + root) : (root - b) / (2 * a);
}

// A part of the ways and velocities of an island takes the energy part^2 moving + part lifting; all
// of them, part 1, takes more than `most`.  The largest part up to 1 that takes no more; where none
// takes as little, that which takes least.
double part_with(double moving, double lifting, double most) {
  if (most >= 0) return larger_root(moving, lifting, most);
  if (lifting >= 0) return 0;
  const double half = -lifting / 2;
  return std::min((half + std::sqrt(std::max(half * half + moving * most, 0.0))) / moving, 1.0);
}

}  // namespace

double gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
            const IslandOutcome& outcome) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const IslandBody& body = bodies[i];
    const double turning = outcome.turning[i];
    double twice = outcome.after[i].squaredNorm() - body.before.squaredNorm();
    twice += (turning * turning - body.turning * body.turning) / 2;
    sum += (twice / 2 - rule.step * acceleration_of(body, rule).dot(outcome.mean[i])) /
           body.inverse_mass;
  }
  return sum;
}

double rounding_of_gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule) {
  double sum = 0;
  for (const IslandBody& body : bodies) {
    const double speed = rule.speed * rule.speed;
    sum += (body.before.squaredNorm() + body.turning * body.turning + speed) / body.inverse_mass;
  }
  return kRoundingOfGain * sum;
}

// after = plastic + part (after - plastic): a convex parabola of energy that is not above 0 at part
// 0. The part is the largest without a gain.
void hold_energy(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
                 const IslandOutcome& plastic, IslandOutcome& outcome) {
  const double grown = gain(bodies, rule, outcome);
  const double rounding = rounding_of_gain(bodies, rule);
  if (!(grown > rounding) && !(rule.keeps_energy && grown < -rounding)) return;
  double square = 0;
  double linear = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double inverse = bodies[i].inverse_mass;
    const Vec2 change = outcome.after[i] - plastic.after[i];
    const double turn = outcome.turning[i] - plastic.turning[i];
    square += (change.squaredNorm() + turn * turn / 2) / 2 / inverse;
    linear += (plastic.after[i].dot(change) + plastic.turning[i] * turn / 2) / inverse;
  }
  IslandOutcome still = outcome;
  still.after = plastic.after;
  still.turning = plastic.turning;
  const double rest = std::max(-gain(bodies, rule, still), 0.0);
  if (!(square > 0)) return;
  const double part = larger_root(square, linear, rest);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    outcome.after[i] = plastic.after[i] + part * (outcome.after[i] - plastic.after[i]);
    outcome.turning[i] = plastic.turning[i] + part * (outcome.turning[i] - plastic.turning[i]);
  }
}

void lose_gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
               const std::vector<Vec2>& plastic, const Vec2& open, IslandOutcome& outcome) {
  const double grown = gain(bodies, rule, outcome);
  if (!(grown > rounding_of_gain(bodies, rule))) return;
  const Vec2 drift = drift_of(bodies, plastic, open) - drift_of(bodies, outcome.mean, open);
  double work = 0;  // of the way from the one to the other
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec2 change = plastic[i] - outcome.mean[i] - drift;
    work += acceleration_of(bodies[i], rule).dot(change) / bodies[i].inverse_mass;
  }
  const double needed = grown / rule.step;
  const double part = work > needed ? needed / work : 1;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    outcome.mean[i] += part * (plastic[i] - outcome.mean[i] - drift);
  }
}

void end_gain(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule, const Vec2& open,
              IslandOutcome& outcome) {
  const double rounding = rounding_of_gain(bodies, rule);
  const double grown = gain(bodies, rule, outcome);
  if (!(grown > rounding)) return;
  const Vec2 way = drift_of(bodies, outcome.mean, open);
  const Vec2 speed = drift_of(bodies, outcome.after, open);
  double lifting = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double mass = 1 / bodies[i].inverse_mass;
    lifting -= mass * rule.step * acceleration_of(bodies[i], rule).dot(outcome.mean[i] - way);
  }
  const double moving = moving_energy(bodies, outcome, speed);
  if (!(moving > 0 || lifting > 0)) return;
  const double part = part_with(moving, lifting, moving + lifting - grown);
  for (Vec2& v : outcome.mean) v = way + part * (v - way);
  scale_velocities(part, speed, outcome);
}

void confine(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
             const std::vector<Vec2>& inside, IslandOutcome& outcome) {
  outcome.mean = inside;
  const double rounding = rounding_of_gain(bodies, rule);
  const double grown = gain(bodies, rule, outcome);
  if (grown > rounding) {
    end_gain(bodies, rule, {0, 0}, outcome);
  } else if (rule.keeps_energy && grown < -rounding) {
    const double moving = moving_energy(bodies, outcome, {0, 0});
    if (moving > 0) scale_velocities(std::sqrt(1 - grown / moving), {0, 0}, outcome);
  }
}

void pay_for_rounding(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule,
                      const std::vector<Vec2>& inside, IslandOutcome& outcome) {
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (inside[i] == outcome.mean[i]) continue;
    const Vec2 acceleration = acceleration_of(bodies[i], rule);
    const double gained = rule.step * acceleration.dot(outcome.mean[i] - inside[i]);
    const double moving = outcome.after[i].squaredNorm() / 2;
    if (std::abs(gained) < kPaidAtMost * moving) outcome.after[i] *= std::sqrt(1 - gained / moving);
  }
}

}  // namespace carom::contact
