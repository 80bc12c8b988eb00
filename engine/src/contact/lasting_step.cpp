#include "contact/lasting_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/ball_gap.hpp"
#include "contact/island_account.hpp"
#include "contact/island_energy.hpp"
#include "contact/wall_contacts.hpp"

namespace carom::contact {
namespace {

// What is slow, as a part of the speed that the acceleration makes in a step.  Balls that roll on
// each other like gears lose nothing: islands fall asleep sooner than a ball alone, which may
// glide.
constexpr double kStill = 0x1p-6;
constexpr double kStillAlone = 0x1p-10;

void count_impacts(LastingIsland& island, const IslandOutcome& outcome) {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (outcome.bounced[k] == 0 || !(outcome.normal[k] > 0)) continue;
    ++(island.sources[k].wall ? island.ball_wall : island.ball_ball);
  }
}

// Nothing has bounced, and nothing is faster than what is still.
bool is_slow(const LastingIsland& island, const IslandOutcome& outcome, double speed) {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (outcome.bounced[k] != 0) return false;
  }
  const double still = (island.members.size() > 1 ? kStill : kStillAlone) * speed;
  const auto small = [still](double v) { return std::abs(v) < still; };
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Vec2& v = outcome.after[m];
    if (!small(v.x()) || !small(v.y()) || !small(outcome.turning[m])) return false;
  }
  return true;
}

}  // namespace

void LastingStep::take(LastingIsland& island, Balls& balls, bool may_sleep,
                       std::vector<char>& driven, IslandStep& step, const ImpactLog& log) const {
  thread_local IslandOutcome outcome;
  const IslandStep::Rule rule = rule_.in(island.frame);
  const bool spins = balls.spin.size() > 0;
  step.take(island.bodies, island.contacts, spins, rule, outcome);
  count_impacts(island, outcome);
  island.sleeps = may_sleep && is_slow(island, outcome, rule.speed) &&
                  step.holds(island.bodies, island.contacts, spins, rule);
  const bool walls = domain_.solid(0) || domain_.solid(1);
  if (walls && !island.sleeps) keep_inside(island, rule, driven, outcome);
  island.turn_back(outcome);
  if (island.sleeps) {
    for (auto& member : island.members) put(balls, member, member.start, {0, 0}, 0);
  } else {
    move(island, balls, outcome);
    island.deepest = deepest(island, balls);
  }
  island.lost = lost_by(island, balls, domain_, turns_, rule_.acceleration);
  if (rule.keeps_energy) {
    const bool keeps = std::abs(island.lost) <= rounding_of_gain(island.bodies, rule);
    if (keeps) island.lost = 0;
    island.jammed = keeps || island.sleeps ? 0 : island.contacts.size();
  }
  if (!log.wanted) return;
  ImpactLog noted{true, log.time, {}};
  note_contacts(island, balls, outcome, noted);
  island.impacts = std::move(noted.impacts);
}

// Rounding must not leave a ball beyond a wall, nor must a wall that was not near.
void LastingStep::keep_inside(LastingIsland& island, const IslandStep::Rule& rule,
                              std::vector<char>& driven, IslandOutcome& outcome) const {
  const WallEnds ends = ends_at_walls(island, outcome.mean, rule.step, domain_);
  for (const std::uint32_t ball : ends.beyond_far) {
    island.driven = island.driven || driven[ball] == 0;
    driven[ball] = 1;
  }
  if (ends.out > kExact * rule.speed) {
    confine(island.bodies, rule, ends.inside, outcome);
  } else if (ends.out > 0 && rule.keeps_energy) {
    pay_for_rounding(island.bodies, rule, ends.inside, outcome);
  }
}

void LastingStep::move(LastingIsland& island, Balls& balls, const IslandOutcome& outcome) const {
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    LastingIsland::Member& member = island.members[m];
    const Vec2 place = member.start + rule_.step * outcome.mean[m];
    // The pull of the second half of a step is given when it is known.
    const Vec2 velocity = outcome.after[m] - member.pulled;
    put(balls, member, place, velocity, outcome.turning[m] / member.radius);
    const Vec2 pushed = rule_.step * outcome.mean[m] - member.flight;
    island.push = std::max(island.push, pushed.norm());
  }
}

void LastingStep::put(Balls& balls, LastingIsland::Member& member, const Vec2& place,
                      const Vec2& velocity, double spin) const {
  const std::size_t k = member.ball;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double period = domain_.period[axis];
    double x = place[axis];
    if (domain_.solid(axis)) {
      x = std::clamp(x, domain_.lowest(axis, balls.radius[k]),
                     domain_.highest(axis, balls.radius[k]));
    } else if (period > 0) {
      x = domain_.wrapped(axis, x);
      if (!turns_[axis].empty()) {
        const double flown =
            member.start[axis] + nearest_image(member.flown[axis] - member.start[axis], period);
        const auto turns = std::llrint((place[axis] - x) / period) -
                           std::llrint((flown - member.flown[axis]) / period);
        turns_[axis][k] += turns - member.turned[axis];
        member.turned[axis] = turns;
      }
    }
    balls.position[axis][k] = x;
    balls.velocity[axis][k] = velocity[axis];
  }
  if (balls.spin.size() > 0) balls.spin[k] = spin;
}

double LastingStep::deepest(const LastingIsland& island, const Balls& balls) const {
  double deepest = 0;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const IslandContact& c = island.contacts[k];
    if (c.b < 0) continue;
    const std::uint32_t a = island.members[static_cast<std::size_t>(c.a)].ball;
    const std::uint32_t b = island.members[static_cast<std::size_t>(c.b)].ball;
    const double gap = way_between(balls, {a, b}, domain_).norm();
    const double reach = balls.radius[a] + balls.radius[b];
    deepest = std::max(deepest, (reach - gap) / island.sources[k].smaller);
  }
  return deepest;
}

void LastingStep::undo(const LastingIsland& island, Balls& balls) const {
  for (const auto& member : island.members) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      balls.position[axis][member.ball] = member.flown[axis];
      balls.velocity[axis][member.ball] = member.flown_velocity[axis];
      if (!turns_[axis].empty()) turns_[axis][member.ball] -= member.turned[axis];
    }
    if (balls.spin.size() > 0) balls.spin[member.ball] = member.spin;
  }
}

}  // namespace carom::contact
