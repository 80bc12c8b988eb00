#include "contact/island.hpp"

#include <algorithm>
#include <cmath>

namespace carom::contact {
namespace {

constexpr double kSolved = 0x1p-20;  // of the speed that the acceleration makes in a step
constexpr double kStatic = 0x1p-24;  // the same for what is held at rest
constexpr double kRounding = 0x1p-40;
constexpr int kSlipRounds = 24;
constexpr int kBounceRounds = 4;
constexpr int kHalvings = 40;

Vec2 across(const Vec2& normal) {
  return {-normal.y(), normal.x()};
}

double opening(const IslandContact& c, const Vec2& a, const Vec2& b) {
  return c.b < 0 ? -c.normal.dot(a) : c.normal.dot(b - a);
}

std::size_t at(int k) {
  return static_cast<std::size_t>(k);
}

const Vec2 kStill{0, 0};

double opening_before(const std::vector<IslandBody>& bodies, const IslandContact& c) {
  return opening(c, bodies[at(c.a)].before, c.b < 0 ? kStill : bodies[at(c.b)].before);
}

double opening_of(const std::vector<Vec2>& motion, const IslandContact& c) {
  return opening(c, motion[at(c.a)], c.b < 0 ? kStill : motion[at(c.b)]);
}

/// What the energy of an island grows by in a step.
double gain(const std::vector<IslandBody>& bodies, const std::vector<Vec2>& after,
            const std::vector<double>& turning, const std::vector<Vec2>& mean,
            const IslandStep::Rule& rule) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const IslandBody& body = bodies[i];
    double twice = after[i].squaredNorm() - body.before.squaredNorm();
    twice += (turning[i] * turning[i] - body.turning * body.turning) / 2;
    sum += (twice / 2 - rule.step * rule.acceleration.dot(mean[i])) / body.inverse_mass;
  }
  return sum;
}

double energy_scale(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule) {
  double sum = 0;
  for (const IslandBody& body : bodies) {
    const double speed = rule.speed * rule.speed;
    sum += (body.before.squaredNorm() + body.turning * body.turning + speed) / body.inverse_mass;
  }
  return sum;
}

}  // namespace

template <int D>
void IslandStep::pose(Work<D>& work, const Island& island, const std::vector<char>& bounces,
                      const std::vector<double>& slip) const {
  ContactProblem<D>& problem = work.problem;
  problem.inverse_mass.clear();
  for (const IslandBody& body : island.bodies) {
    const double inverse = body.inverse_mass * island.mass_unit;
    problem.inverse_mass.push_back(inverse);
    problem.inverse_mass.push_back(inverse);
    if (D == 3) problem.inverse_mass.push_back(2 * inverse);
  }
  problem.rows.clear();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const IslandContact& c = island.contacts[k];
    const IslandBody& a = island.bodies[at(c.a)];
    const Vec2 t = across(c.normal);
    const double offset = bounces[k] != 0 ? c.restitution * opening_before(island.bodies, c)
                                          : std::max(c.gap, 0.0) / island.rule.step;
    for (int side = 1; side >= (D == 2 ? 1 : -1); side -= 2) {
      const double mu = D == 3 ? side * c.friction : 0;
      Row<D> row;
      row.a = c.a;
      row.b = c.b;
      row.j[0] = c.normal.x() + mu * t.x();
      row.j[1] = c.normal.y() + mu * t.y();
      if (D == 3) row.j[D - 1] = -mu;
      row.q = -row.j[0] * a.free.x() - row.j[1] * a.free.y();
      if (D == 3) row.q += row.j[D - 1] * a.turning;
      if (c.b >= 0) {
        const IslandBody& b = island.bodies[at(c.b)];
        row.q += row.j[0] * b.free.x() + row.j[1] * b.free.y();
        if (D == 3) row.q += row.j[D - 1] * b.turning;
      }
      row.q += offset + c.friction * slip[k];
      problem.rows.push_back(row);
      if (c.friction == 0) break;
    }
  }
  problem.weigh();
}

template <int D>
bool IslandStep::solve(Work<D>& work, const Island& island, const std::vector<char>& bounces,
                       double goal, IslandOutcome& outcome) {
  const std::size_t n = island.bodies.size();
  std::vector<double> slip(island.contacts.size(), 0.0);
  bool solved = false;
  for (int round = 0; round < (D == 2 ? 1 : kSlipRounds); ++round) {
    pose(work, island, bounces, slip);
    solved = work.solver.solve(work.problem, goal, work.impulses).solved;
    work.problem.spread(work.impulses, work.motion, true);
    outcome.after.resize(n);
    outcome.turning.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double* change = work.motion.data() + i * D;
      outcome.after[i] = island.bodies[i].free + Vec2{change[0], change[1]};
      outcome.turning[i] = island.bodies[i].turning + (D == 3 ? change[D - 1] : 0);
    }
    if (D == 2) break;
    double most = 0;
    for (std::size_t k = 0; k < slip.size(); ++k) {
      const IslandContact& c = island.contacts[k];
      if (c.friction == 0) continue;
      const Vec2 other = c.b < 0 ? kStill : outcome.after[at(c.b)];
      double along = across(c.normal).dot(other - outcome.after[at(c.a)]);
      along -= outcome.turning[at(c.a)] + (c.b < 0 ? 0 : outcome.turning[at(c.b)]);
      // What only rounding and the goal leave is sticking.
      const double now = std::abs(along) > 2 * goal / c.friction ? std::abs(along) : 0;
      most = std::max(most, c.friction * std::abs(now - slip[k]));
      slip[k] = now;
    }
    if (most < 4 * goal) break;
  }
  outcome.normal.assign(island.contacts.size(), 0.0);
  std::size_t row = 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    outcome.normal[k] = work.impulses[row++];
    if (D == 3 && island.contacts[k].friction != 0) outcome.normal[k] += work.impulses[row++];
  }
  return solved;
}

template <int D>
void IslandStep::take(Work<D>& work, const Island& island, IslandOutcome& outcome) {
  const Rule& rule = island.rule;
  const auto& bodies = island.bodies;
  const auto& contacts = island.contacts;
  const std::size_t n = bodies.size();
  const double goal = kSolved * rule.speed;
  outcome.bounced.assign(contacts.size(), 0);
  outcome.solved = solve(work, island, outcome.bounced, goal, outcome);

  const double scale = energy_scale(bodies, rule);
  const auto gain_of = [&](const IslandOutcome& o, const std::vector<Vec2>& mean) {
    return gain(bodies, o.after, o.turning, mean, rule);
  };
  const IslandOutcome plastic = outcome;
  std::vector<char> bounced(contacts.size(), 0);
  // A bounce can make another contact carry an impulse, which then bounces, too.
  for (int round = 0; round < kBounceRounds; ++round) {
    bool more = false;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const IslandContact& c = contacts[k];
      if (bounced[k] != 0 || c.restitution == 0 || !(outcome.normal[k] > 0)) continue;
      const double closing = -opening_before(bodies, c);
      if (!(closing > rule.rest_speed) || !(c.gap - rule.step * closing < 0)) continue;
      bounced[k] = 1;
      more = true;
    }
    if (!more) break;
    const bool solved = solve(work, island, bounced, goal, outcome);
    outcome.solved = outcome.solved && solved;
  }
  outcome.bounced = bounced;
  if (gain_of(outcome, outcome.after) > kRounding * scale) {
    // after = plastic + part (after - plastic), for the largest part without a gain: a convex
    // parabola that is not above 0 at part 0.
    const IslandOutcome whole = outcome;
    const auto go = [&](double part) {
      for (std::size_t i = 0; i < n; ++i) {
        outcome.after[i] = plastic.after[i] + part * (whole.after[i] - plastic.after[i]);
        outcome.turning[i] = plastic.turning[i] + part * (whole.turning[i] - plastic.turning[i]);
      }
    };
    double low = 0;
    double high = 1;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double part = (low + high) / 2;
      go(part);
      (gain_of(outcome, outcome.after) > 0 ? high : low) = part;
    }
    go(low);
  }

  // The mean of the velocities before and after is right to second order; it is taken where no
  // contact closes by it and it makes no energy.
  outcome.mean.resize(n);
  for (std::size_t i = 0; i < n; ++i) outcome.mean[i] = (bodies[i].before + outcome.after[i]) / 2;
  bool closes = false;
  for (const IslandContact& c : contacts) {
    const double end = c.gap + rule.step * opening_of(outcome.mean, c);
    closes = closes || end < std::min(c.gap, 0.0) - 4 * goal * rule.step;
  }
  if (closes || gain_of(outcome, outcome.mean) > kRounding * scale) outcome.mean = outcome.after;
}

template <int D>
bool IslandStep::holds(Work<D>& work, const Island& island) {
  const double still = kStatic * island.rule.speed;
  const std::vector<double> slip(island.contacts.size(), 0.0);
  const std::vector<char> bounces(island.contacts.size(), 0);
  pose(work, island, bounces, slip);
  work.solver.solve(work.problem, still / 64, work.impulses);
  work.problem.spread(work.impulses, work.motion, true);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const double* change = work.motion.data() + i * D;
    const Vec2 after = island.bodies[i].free + Vec2{change[0], change[1]};
    if (!(std::abs(after.x()) < still && std::abs(after.y()) < still)) return false;
    if (D == 3 && !(std::abs(change[D - 1]) < still)) return false;
  }
  return true;
}

namespace {

// The power of two next to the largest mass: roots of masses are the same in any such unit.
double unit_of(const std::vector<IslandBody>& bodies) {
  double least = bodies.front().inverse_mass;
  for (const IslandBody& body : bodies) least = std::min(least, body.inverse_mass);
  return std::ldexp(1.0, -std::ilogb(least));
}

}  // namespace

void IslandStep::take(const std::vector<IslandBody>& bodies,
                      const std::vector<IslandContact>& contacts, bool spins, const Rule& rule,
                      IslandOutcome& outcome) {
  const Island island{bodies, contacts, rule, unit_of(bodies)};
  if (spins) {
    take(turning_, island, outcome);
  } else {
    take(plain_, island, outcome);
  }
}

bool IslandStep::holds(const std::vector<IslandBody>& bodies,
                       const std::vector<IslandContact>& contacts, bool spins, const Rule& rule) {
  std::vector<IslandBody> still = bodies;
  for (IslandBody& body : still) {
    body.before = {0, 0};
    body.free = rule.step * rule.acceleration;
    body.turning = 0;
  }
  const Island island{still, contacts, rule, unit_of(bodies)};
  return spins ? holds(turning_, island) : holds(plain_, island);
}

}  // namespace carom::contact
