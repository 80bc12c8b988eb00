#include "contact/island_single.hpp"

#include <algorithm>

#include "contact/island_contact.hpp"
#include "contact/island_energy.hpp"
#include "contact/island_friction.hpp"

namespace carom::contact {

void take_single(const std::vector<IslandBody>& bodies, const IslandContact& c,
                 const IslandStep::Rule& rule, IslandOutcome& outcome) {
  const std::size_t n = bodies.size();
  outcome.after.resize(n);
  outcome.turning.resize(n);
  outcome.mean.resize(n);
  std::vector<Vec2>& motion = outcome.after;
  for (std::size_t i = 0; i < n; ++i) {
    motion[i] = bodies[i].free;
    outcome.turning[i] = bodies[i].turning;
    outcome.mean[i] = bodies[i].free_mean;
  }
  const bool bounce = bounces(bodies, c, rule);
  const double free = opening_of(motion, c);
  const double room =
      closing_room(c, rule, kClosed, apart_speed(mean_speed(bodies, c.b < 0), rule));
  const bool meets = free + room < 0;
  outcome.bounced.assign(1, bounce && meets ? 1 : 0);
  outcome.normal.assign(1, 0.0);
  outcome.along.assign(1, 0.0);
  outcome.solved = true;
  if (!meets) return;
  const auto a = index(c.a);
  const double of_a = bodies[a].inverse_mass;
  const double of_b = c.b < 0 ? 0 : bodies[index(c.b)].inverse_mass;
  const double wanted = bounce ? c.restitution * arrival(bodies, c, rule) : -room;
  const double gained = std::max(wanted - free, 0.0);
  outcome.normal[0] = gained / rule.fading / (of_a + of_b);
  const Vec2 t = across(c.normal);
  double along = 0;
  if (c.friction > 0) {
    const SurfaceMotion other =
        c.b < 0 ? SurfaceMotion{} : SurfaceMotion{motion[index(c.b)], outcome.turning[index(c.b)]};
    const double slip = slip_of(c, {motion[a], outcome.turning[a]}, other);
    // The impact comes within the step: what it does not have to hold of the pull makes no
    // friction.
    const double pressed = bounce ? (1 + c.restitution) * arrival(bodies, c, rule) : gained;
    along = friction_against(slip, c.friction * pressed / rule.fading, rule.fading);
  }
  outcome.along[0] = along / (of_a + of_b);
  const auto push = [&](std::size_t body, int side, double share) {
    const Vec2 before = bodies[body].before;
    outcome.after[body] += side * share * (gained * c.normal + rule.fading * along * t);
    outcome.turning[body] -= 2 * share * along;
    // Along the normal as far as it touches, across it by the mean.
    const Vec2 met = bodies[body].free + side * share * (-room - free) * c.normal;
    const double across_mean = t.dot(before + outcome.after[body]) / 2;
    outcome.mean[body] = c.normal.dot(met) * c.normal + across_mean * t;
  };
  push(a, -1, of_a / (of_a + of_b));
  if (c.b >= 0) push(index(c.b), 1, of_b / (of_a + of_b));
  if (rule.keeps_energy || bounce) {
    IslandOutcome plastic = outcome;
    const auto stop = [&](std::size_t body, int side, double share) {
      plastic.after[body] =
          bodies[body].free + side * share * ((-room - free) * c.normal + rule.fading * along * t);
    };
    stop(a, -1, of_a / (of_a + of_b));
    if (c.b >= 0) stop(index(c.b), 1, of_b / (of_a + of_b));
    hold_energy(bodies, rule, plastic, outcome);
  }
  end_gain(bodies, rule, c.b < 0 ? Vec2{0, 0} : Vec2{1, 1}, outcome);
}

}  // namespace carom::contact
