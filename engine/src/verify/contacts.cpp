#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

Scene on_a_slope(const Trial& trial, double slope, double friction, const Ball& start) {
  Scene scene = with_balls(trial.scene, {start});
  const double g = -trial.scene.effects.gravity->acceleration.y();
  scene.effects.gravity->acceleration.x() = slope * g;
  scene.effects.friction = Friction{friction, friction};
  return scene;
}

/// A uniform disk rolls down with 2/3 of the pull where mu >= tan / 3, and slips with g (tan - mu)
/// where it is less.
double slope_ways(const Trial& trial) {
  const double g = -trial.scene.effects.gravity->acceleration.y();
  const double time = trial.scene.duration;
  double worst = 0;
  for (const double slope : {0.1, 0.5, 1.0}) {
    for (const double part : {1.05, 0.95, 0.5}) {
      const double mu = part * slope / 3;
      const double pull = part > 1 ? 2 * slope * g / 3 : g * (slope - mu);
      const double turn = part > 1 ? pull : 2 * mu * g;  // of the spin times the radius, by time
      const Outcome outcome = run(on_a_slope(trial, slope, mu, ball(5, 0.5, 0, 0)), time);
      const Ball& now = outcome.balls[0];
      const double way = pull * time * time / 2;
      worst = std::max({worst, std::abs(now.position.x() - 5 - way) / way,
                        std::abs(now.velocity.x() - pull * time) / (pull * time),
                        std::abs(-now.spin * now.radius - turn * time) / (turn * time),
                        std::abs(now.position.y() - now.radius)});
    }
  }
  return worst;
}

/// It starts rolling uphill with 3, turns round and rolls down again.
double slope_turns(const Trial& trial) {
  const double g = -trial.scene.effects.gravity->acceleration.y();
  const double time = 4 * trial.scene.duration;
  Ball start = ball(500, 0.5, 3, 0);
  start.spin = -6;
  const Ball now = run(on_a_slope(trial, -0.1, 0.4, start), time).balls[0];
  const double pull = -0.2 * g / 3;
  return std::max(std::abs(now.position.x() - 500 - 3 * time - pull * time * time / 2),
                  std::abs(now.velocity.x() - 3 - pull * time));
}

/// With drag k a rolling disk slows as exp(-2 k t / 3).
double slope_drag(const Trial& trial) {
  const double rate = 0.5;
  const double time = 2 * trial.scene.duration;
  Ball start = ball(5, 0.5, 3, 0);
  start.spin = -6;
  Scene scene = on_a_slope(trial, 0, 0.4, start);
  scene.effects.drag = Drag{rate};
  const Ball now = run(scene, time).balls[0];
  const double kept = std::exp(-2 * rate * time / 3);
  return std::max(std::abs(now.velocity.x() - 3 * kept),
                  std::abs(now.position.x() - 5 - 9 / (2 * rate) * (1 - kept)));
}

/// Two balls side by side and one on them, or falling on them: needs mu >= tan(15 degrees) at the
/// floor and between balls.
Outcome triangle(const Trial& trial, double friction, double fall, double time) {
  const double height = 0.5 + std::sqrt(0.75) + fall;
  Scene scene =
      with_balls(trial.scene, {ball(5, 0.5, 0, 0), ball(6, 0.5, 0, 0), ball(5.5, height, 0, 0)});
  scene.effects.friction = Friction{friction, friction};
  return run(scene, time);
}

double triangle_moves(const Trial& trial) {
  const Outcome start = triangle(trial, 0.8, 0, 0);
  return farthest(start.balls, triangle(trial, 0.8, 0, trial.scene.duration).balls) / 0.5;
}

/// Once the fallen one has come to rest.
double triangle_creeps(const Trial& trial) {
  const Outcome early = triangle(trial, 0.8, 0.02, trial.scene.duration / 2);
  return farthest(early.balls, triangle(trial, 0.8, 0.02, trial.scene.duration).balls) / 0.5;
}

double triangle_sinks(const Trial& trial) {
  const double top = 0.5 + std::sqrt(0.75);
  const Outcome end = triangle(trial, 0.8, 0.02, trial.scene.duration);
  return std::abs(end.balls[2].position.y() - top) / 0.5;
}

/// How often it falls just above its coefficient or stands just below it.
double triangle_mistaken(const Trial& trial) {
  const double theory = std::tan(std::acos(-1.0) / 12);
  const double top = 0.5 + std::sqrt(0.75);
  double mistaken = 0;
  for (const double part : {1.01, 0.99}) {
    const Outcome end = triangle(trial, part * theory, 0, 20);
    const bool stands = end.balls[2].position.y() > top - 0.01;
    if (stands != (part > 1)) ++mistaken;
  }
  return mistaken;
}

/// Light balls and ones 10,000 times as heavy in turn, that fall a little onto each other.
double heavy_sinks(const Trial& trial) {
  std::vector<Ball> balls;
  for (int k = 0; k < 4; ++k)
    balls.push_back(ball(5, 0.5 + 1.01 * k, 0, 0, 0.5, k % 2 == 0 ? 1 : 1e4));
  const Outcome end = run(with_balls(trial.scene, balls), trial.scene.duration);
  double worst = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec2 at = end.balls[static_cast<std::size_t>(k)].position;
    worst = std::max(worst, std::abs(at.y() - 0.5 - k) / 0.5);
  }
  return worst;
}

/// A ball 10,000 times as heavy falls on a light one: it comes to rest on it, and the energy of the
/// fall is lost and booked.
Outcome heavy_falls(const Trial& trial) {
  const std::vector<Ball> balls{ball(5, 0.5, 0, 0), ball(5, 3, 0, 0, 0.5, 1e4)};
  return run(with_balls(trial.scene, balls), trial.scene.duration);
}

double heavy_rests(const Trial& trial) {
  const Ball now = heavy_falls(trial).balls[1];
  return std::abs(now.position.y() - 1.5) / 0.5 + now.velocity.norm();
}

double heavy_books(const Trial& trial) {
  const double g = -trial.scene.effects.gravity->acceleration.y();
  return std::abs(heavy_falls(trial).measured.energy_dissipated / (1.5e4 * g) - 1);
}

/// A heap that has come to rest stands still, to the bit, and moves no more.
double sleeping_motion(const Trial& trial) {
  double motion = 0;
  for (const Ball& each : run(trial.scene, trial.scene.duration).balls) {
    motion += each.velocity.norm() + std::abs(each.spin);
  }
  return motion;
}

double sleeping_creep(const Trial& trial) {
  const Outcome early = run(trial.scene, trial.scene.duration / 2);
  const Outcome late = run(trial.scene, trial.scene.duration);
  return farthest(early.balls, late.balls) / early.balls.front().radius;
}

double sleeping_overlap(const Trial& trial) {
  return run(trial.scene, trial.scene.duration).measured.max_overlap;
}

/// Balls that slide down fixed ones into a heap: how far apart the mean heights by the two methods
/// are, in standard errors.
double avalanche_bias(const Trial& trial) {
  const int runs = trial.thorough ? 20 : 6;
  const auto heights = [&](Method method) {
    double sum = 0;
    double squares = 0;
    for (int k = 0; k < runs; ++k) {
      Scene scene = trial.scene;
      scene.solver.method = method;
      scene.seed = trial.seed * 1000 + static_cast<std::uint64_t>(k);
      double height = 0;
      double mass = 0;
      for (const Ball& each : run(scene, scene.duration).balls) {
        if (each.fixed) continue;
        height += each.mass * each.position.y();
        mass += each.mass;
      }
      sum += height / mass;
      squares += height / mass * (height / mass);
    }
    const double mean = sum / runs;
    return std::pair{mean, std::max(squares / runs - mean * mean, 0.0) / (runs - 1)};
  };
  const auto [exact, of_exact] = heights(Method::event);
  const auto [stepped, of_stepped] = heights(Method::overlap);
  return std::abs(stepped - exact) / std::sqrt(of_exact + of_stepped);
}

}  // namespace

std::vector<Case> contact_cases() {
  return {
      {"slope",
       {{Method::event, "rolls or slips by theory, relative", 1e-9, slope_ways},
        {Method::event, "uphill and down again", 1e-9, slope_turns},
        {Method::event, "rolls with drag", 1e-9, slope_drag},
        {Method::overlap, "rolls or slips by theory, relative", 1e-3, slope_ways},
        {Method::overlap, "uphill and down again", 1e-3, slope_turns},
        {Method::overlap, "rolls with drag", 1e-3, slope_drag}}},
      {"triangle",
       {{Method::event, "moves, in radii", 1e-6, triangle_moves},
        {Method::event, "falls or stands against theory", 0, triangle_mistaken},
        {Method::overlap, "moves, in radii", 1e-6, triangle_moves},
        {Method::overlap, "creeps after a fall, in radii", 1e-6, triangle_creeps},
        {Method::overlap, "sinks after a fall, in radii", 0.02, triangle_sinks},
        {Method::overlap, "falls or stands against theory", 0, triangle_mistaken}}},
      {"heavy",
       {{Method::event, "sinks, in radii", 1e-5, heavy_sinks},
        {Method::event, "off its place after a fall", 1e-6, heavy_rests},
        {Method::overlap, "sinks, in radii", 0.02, heavy_sinks},
        {Method::overlap, "off its place after a fall", 1e-3, heavy_rests},
        {Method::overlap, "energy lost by the fall, relative", 1e-6, heavy_books}}},
      {"sleeping",
       {{Method::overlap, "motion once asleep", 0, sleeping_motion},
        {Method::overlap, "creep in half of the time, in radii", 1e-6, sleeping_creep},
        {Method::overlap, "overlap, in radii", 1e-3, sleeping_overlap}}},
      {"avalanche",
       {{Method::overlap, "mean height off event's, in standard errors", 3, avalanche_bias}}},
  };
}

}  // namespace carom::hard
