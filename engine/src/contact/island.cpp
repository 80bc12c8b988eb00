#include "contact/island.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "contact/island_contact.hpp"
#include "contact/island_energy.hpp"
#include "contact/island_friction.hpp"
#include "contact/island_single.hpp"
#include "contact/island_slips.hpp"

namespace carom::contact {
namespace {

constexpr double kSolved = 0x1p-20;    // of few contacts without friction
constexpr double kSlowest = 0x1p-10;   // speeds, for which it is solved so much better
constexpr double kStatic = 0x1p-24;    // the same for what is held at rest
constexpr double kTolerated = 0x1p-4;  // an overlap that stays where there is friction
constexpr double kSlip = 0x1p-5;
constexpr double kSlipChange = 0x1p-4;  // how exactly a slip is known
constexpr int kSlipRounds = 2;
// Contacts: of more slips are revised, which must not jump, and a step is solved less exactly.
constexpr std::size_t kMany = 128;
constexpr int kBounceRounds = 4;

/// What slides slower counts as sticking.
double sticking(const IslandStep::Rule& rule) {
  return kSlip * rule.speed;
}

template <int D>
constexpr double tolerated() {
  return D == 3 ? kTolerated : kClosed;
}

/// What a step is exact to.  With friction slips are not exact, either; of many contacts half of
/// the work would be for the last bits.
template <int D>
double exactness(std::size_t contacts) {
  return D == 3 || contacts > kMany ? kExact : kSolved;
}

/// 1 along axes along which nothing that never moves can push an island.
Vec2 open_axes(const std::vector<IslandContact>& contacts) {
  bool x = true;
  bool y = true;
  for (const IslandContact& c : contacts) {
    if (c.b >= 0) continue;
    x = x && c.normal.x() == 0 && c.friction == 0;
    y = y && c.normal.y() == 0 && c.friction == 0;
  }
  return {x ? 1.0 : 0.0, y ? 1.0 : 0.0};
}

/// Whether all bodies are pulled to the same side along an axis that is open: no force holds that,
/// however little it is beyond rounding.
bool slides(const std::vector<IslandBody>& bodies, const IslandStep::Rule& rule, const Vec2& open) {
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  const auto to_side = [&](int axis, double side) {
    return open[axis] != 0 && std::all_of(bodies.begin(), bodies.end(), [&](const IslandBody& b) {
             const Vec2 pull = acceleration_of(b, rule);
             return side * pull[axis] > kRounding * (std::abs(pull.x()) + std::abs(pull.y()));
           });
  };
  return to_side(0, 1) || to_side(0, -1) || to_side(1, 1) || to_side(1, -1);
}

}  // namespace

template <int D>
void IslandStep::pose(Work<D>& work, const Island& island, const std::vector<char>& bounced,
                      const std::vector<double>& slip) const {
  ContactProblem<D>& problem = work.problem;
  problem.inverse_mass.clear();
  for (const IslandBody& body : island.bodies) {
    const double inverse = body.inverse_mass * island.mass_unit;
    problem.inverse_mass.push_back(island.rule.fading * inverse);
    problem.inverse_mass.push_back(island.rule.fading * inverse);
    if (D == 3) problem.inverse_mass.push_back(2 * inverse);
  }
  problem.rows.clear();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const IslandContact& c = island.contacts[k];
    const IslandBody& a = island.bodies[index(c.a)];
    const Vec2 t = across(c.normal);
    const double offset =
        bounced[k] != 0 ? -c.restitution * arrival(island.bodies, c, island.rule) : work.rooms[k];
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
        const IslandBody& b = island.bodies[index(c.b)];
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
bool IslandStep::solve(Work<D>& work, const Island& island, const std::vector<char>& bounced,
                       bool revises, std::vector<double>& slip, IslandOutcome& outcome) {
  pose(work, island, bounced, slip);
  const std::vector<double> last = work.impulses;
  const bool again = last.size() == work.problem.rows.size();
  typename InteriorPoint<D>::Revision revise;
  std::optional<SlipRevision> revision;
  if constexpr (D == 3) {
    if (revises) {
      revision.emplace(island.bodies, island.contacts, sticking(island.rule), work.problem, slip);
      revise = std::ref(*revision);
    }
  }
  const auto* like = again ? &last : nullptr;
  const bool solved =
      work.solver.solve(work.problem, work.goal, work.impulses, like, revise).solved;
  work.revised = revision && revision->any();
  work.problem.spread(work.impulses, work.motion, true);
  const std::size_t n = island.bodies.size();
  outcome.after.resize(n);
  outcome.turning.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double* change = work.motion.data() + i * D;
    outcome.after[i] = island.bodies[i].free + Vec2{change[0], change[1]};
    outcome.turning[i] = island.bodies[i].turning + (D == 3 ? change[D - 1] : 0);
  }
  outcome.normal.assign(island.contacts.size(), 0.0);
  outcome.along.assign(island.contacts.size(), 0.0);
  std::size_t row = 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const double one = work.impulses[row++] * island.mass_unit;
    outcome.normal[k] = one;
    if (D == 2 || island.contacts[k].friction == 0) continue;
    const double other = work.impulses[row++] * island.mass_unit;
    outcome.normal[k] += other;
    outcome.along[k] = island.contacts[k].friction * (one - other);
  }
  return solved;
}

template <int D>
bool IslandStep::solve(Work<D>& work, const Island& island, const std::vector<char>& bounced,
                       IslandOutcome& outcome) {
  std::vector<double>& slip = work.slips;
  const bool first = std::none_of(bounced.begin(), bounced.end(), [](char b) { return b != 0; });
  if (D == 2) {
    if (first) slip.assign(island.contacts.size(), 0.0);
    return solve(work, island, bounced, false, slip, outcome);
  }
  const double sticks = sticking(island.rule);
  const bool many = island.contacts.size() > kMany;
  const auto slips = [&](std::size_t k, const auto& motion) {
    const IslandContact& c = island.contacts[k];
    const SurfaceMotion b = c.b < 0 ? SurfaceMotion{} : motion(c.b);
    const double beyond = sliding(c, motion(c.a), b, sticks);
    return many || beyond == 0 ? beyond : std::abs(slip_of(c, motion(c.a), b));
  };
  const auto before = [&](int i) -> SurfaceMotion {
    return {island.bodies[index(i)].before, island.bodies[index(i)].turning};
  };
  const auto after = [&](int i) -> SurfaceMotion {
    return {outcome.after[index(i)], outcome.turning[index(i)]};
  };
  if (first) slip.assign(island.contacts.size(), 0.0);
  const bool returns = !first && !std::exchange(work.returns, true);
  if (first) work.returns = false;
  for (std::size_t k = 0; k < slip.size(); ++k) {
    if (first) slip[k] = slips(k, before);
    if (!returns || bounced[k] == 0) continue;
    // What returns has friction, as what came had.
    const double stopped = std::max(slips(k, before) - slip[k], 0.0);
    slip[k] = std::max(slip[k] - island.contacts[k].restitution * stopped, 0.0);
  }
  const bool slides =
      first && std::any_of(slip.begin(), slip.end(), [](double v) { return v > 0; });
  bool solved = false;
  for (int round = 0; round < (first ? kSlipRounds : 1); ++round) {
    solved = solve(work, island, bounced, slides, slip, outcome);
    bool changes = false;
    for (std::size_t k = 0; k < slip.size(); ++k) {
      if (island.contacts[k].friction == 0) continue;
      const double now = slips(k, after);
      changes = changes || std::abs(now - slip[k]) > std::max(sticks, kSlipChange * now);
      slip[k] = round < 2 ? now : (now + slip[k]) / 2;  // it may go round in circles
    }
    if (!changes || work.revised) break;
  }
  // Where a slip was taken for more than it is the contact closes: without it, it cannot.  By the
  // velocities after bounces no ball has moved yet.
  for (int round = 0; first && round < 2; ++round) {
    bool closes = false;
    for (std::size_t k = 0; k < slip.size(); ++k) {
      const IslandContact& c = island.contacts[k];
      const double room = bounced[k] != 0 ? 0 : work.rooms[k];
      if (!(opening_of(outcome.after, c) + room < -sticks)) continue;
      closes = true;
      slip[k] = 0;
    }
    if (!closes) break;
    if (round == 1) std::fill(slip.begin(), slip.end(), 0.0);
    solved = solve(work, island, bounced, false, slip, outcome);
  }
  return solved;
}

template <int D>
void IslandStep::take(Work<D>& work, const Island& island, IslandOutcome& outcome) {
  const Rule& rule = island.rule;
  const auto& bodies = island.bodies;
  const auto& contacts = island.contacts;
  const std::size_t n = bodies.size();
  outcome.bounced.assign(contacts.size(), 0);
  work.rooms.clear();
  work.impulses.clear();
  const bool held =
      std::any_of(contacts.begin(), contacts.end(), [](const IslandContact& c) { return c.b < 0; });
  const double moving = mean_speed(bodies, held);
  // With friction contacts may close as fast as what counts as sticking slides.
  const double apart =
      std::max(apart_speed(moving, rule), D == 3 ? kSlip * std::min(moving, rule.speed) : 0);
  // What hardly moves must be known as much better.
  const double slow = std::max(std::min(moving / rule.speed, 1.0), kSlowest);
  const double exact = exactness<D>(contacts.size());
  work.goal = exact * slow * rule.speed;
  for (const IslandContact& c : contacts)
    work.rooms.push_back(closing_room(c, rule, tolerated<D>(), apart));
  outcome.solved = solve(work, island, outcome.bounced, outcome);

  const IslandOutcome plastic = outcome;
  std::vector<char> bounced(contacts.size(), 0);
  bool any = false;
  // A bounce can make another contact carry an impulse, which then bounces, too.
  for (int round = 0; round < kBounceRounds; ++round) {
    bool more = false;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const IslandContact& c = contacts[k];
      if (bounced[k] != 0 || !(outcome.normal[k] > 0) || !bounces(bodies, c, rule)) continue;
      bounced[k] = 1;
      more = true;
    }
    if (!more) break;
    // The balls are then where the step without bounces takes them; what is open there may close.
    for (std::size_t k = 0; k < contacts.size() && !any; ++k) {
      const double gap = contacts[k].gap + rule.step * opening_of(plastic.after, contacts[k]);
      work.rooms[k] = std::max(work.rooms[k], gap / rule.step);
    }
    any = true;
    if (solve(work, island, bounced, outcome)) continue;
    // Wedged: no velocities do all the bounces.
    outcome = plastic;
    any = false;
    break;
  }
  if (any) outcome.bounced = bounced;
  // What nothing touches flies free; the others go with the mean of their velocities before and
  // after, which is right to second order, or, where there are impacts, as far as they touch.
  outcome.mean.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (outcome.after[i] == bodies[i].free && plastic.after[i] == bodies[i].free) {
      outcome.mean[i] = bodies[i].free_mean;
    } else if (any) {
      outcome.mean[i] = plastic.after[i];
    } else {
      outcome.mean[i] = (bodies[i].before + outcome.after[i]) / 2;
    }
  }
  keep_apart(island, plastic.after, exact, outcome.mean);
  if (!any && rule.keeps_energy) {
    // No impact that could return it: what was stopped goes back as it came.
    for (std::size_t i = 0; i < n; ++i) {
      outcome.after[i] = 2 * plastic.after[i] - bodies[i].free;
      outcome.turning[i] = 2 * plastic.turning[i] - bodies[i].turning;
    }
    any = true;
  }
  const Vec2 open = open_axes(contacts);
  if (any) {
    hold_energy(bodies, rule, plastic, outcome);
  } else {
    lose_gain(bodies, rule, plastic.after, open, outcome);
  }
  end_gain(bodies, rule, open, outcome);
}

// By the plastic step no contact closes: whose contacts do close go with it.
void IslandStep::keep_apart(const Island& island, const std::vector<Vec2>& plastic, double solved,
                            std::vector<Vec2>& mean) {
  const double most = 4 * solved * island.rule.speed * island.rule.step;
  for (bool more = true; std::exchange(more, false);) {
    for (const IslandContact& c : island.contacts) {
      const double end = c.gap + island.rule.step * opening_of(mean, c);
      if (!(end < std::min(c.gap, 0.0) - most)) continue;
      for (const int body : {c.a, c.b}) {
        if (body < 0 || mean[index(body)] == plastic[index(body)]) continue;
        mean[index(body)] = plastic[index(body)];
        more = true;
      }
    }
  }
}

template <int D>
bool IslandStep::holds(Work<D>& work, const Island& island) {
  const double still = kStatic * island.rule.speed;
  const std::vector<double> slip(island.contacts.size(), 0.0);
  const std::vector<char> bounces(island.contacts.size(), 0);
  work.rooms.clear();
  for (const IslandContact& c : island.contacts) {
    work.rooms.push_back(closing_room(c, island.rule, tolerated<D>(), 0));
  }
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
  if (contacts.size() == 1) {
    take_single(bodies, contacts.front(), rule, outcome);
  } else if (spins) {
    take(turning_, island, outcome);
  } else {
    take(plain_, island, outcome);
  }
}

bool IslandStep::holds(const std::vector<IslandBody>& bodies,
                       const std::vector<IslandContact>& contacts, bool spins, const Rule& rule) {
  if (slides(bodies, rule, open_axes(contacts))) return false;
  std::vector<IslandBody> still = bodies;
  for (IslandBody& body : still) {
    body.before = {0, 0};
    body.free = rule.step * acceleration_of(body, rule);
    body.free_mean = body.free / 2;
    body.turning = 0;
  }
  std::vector<IslandContact> closed = contacts;
  for (IslandContact& c : closed) {
    // A contact that slides slower than kSlip, which counts as sticking, is lifted by mu times
    // that.
    const double lifted = std::max(kClosed, spins ? 2 * c.friction * kSlip : 0);
    if (c.gap < lifted * rule.speed * rule.step) c.gap = 0;
  }
  const Island island{still, closed, rule, unit_of(bodies)};
  return spins ? holds(turning_, island) : holds(plain_, island);
}

}  // namespace carom::contact
