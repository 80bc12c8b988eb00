#include "accuracy/rest_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "accuracy/equilibrium.hpp"
#include "carom/shorter_way.hpp"

namespace carom::accuracy {
namespace {

constexpr std::size_t kRestSamples = 240;  // at the balls, until the end
constexpr std::size_t kLastThird = kRestSamples * 2 / 3;
constexpr std::size_t kJudgeCostAtSample = kRestSamples / 16;

double kinetic_energy(const std::vector<Ball>& balls) {
  double sum = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    const double rim = ball.spin * ball.radius;  // I w^2 / 2 with I = m r^2 / 2
    sum += ball.mass / 2 * (ball.velocity.squaredNorm() + rim * rim / 2);
  }
  return sum;
}

/// m g r over the balls that can move: the energy that lifts each by its radius.
double lift(const std::vector<Ball>& balls, const Vec2& gravity) {
  double sum = 0;
  for (const Ball& ball : balls) {
    if (!ball.fixed) sum += ball.mass * ball.radius;
  }
  return sum * gravity.norm();
}

/// Of the centre of mass of the balls that can move, against gravity.
double height(const std::vector<Ball>& balls, const Vec2& gravity) {
  double moment = 0;
  double mass = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    moment -= ball.mass * ball.position.dot(gravity);
    mass += ball.mass;
  }
  const double pull = gravity.norm();
  return mass > 0 && pull > 0 ? moment / (mass * pull) : 0;
}

/// The farthest that a ball has moved, in its radii; commands may have added and removed some.
double farthest_move(const std::vector<Ball>& from, const std::vector<Ball>& to, const Box& box) {
  double farthest = 0;
  if (from.size() != to.size()) return farthest;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec2 moved = shorter_way(to[i].position - from[i].position, box);
    farthest = std::max(farthest, std::hypot(moved.x(), moved.y()) / to[i].radius);
  }
  return farthest;
}

}  // namespace

RestRun run_to_rest(const Scenario& scenario, const Way& way, const AccuracyCrew& crew,
                    double limit, const std::function<void(double part)>& told) {
  Runner runner(scenario, way, crew);
  const Simulation& simulation = runner.simulation();
  RestRun run;
  run.workers = simulation.workers();
  std::vector<Ball> third;  // where the balls were when the last third began
  for (std::size_t sample = 1; sample <= kRestSamples; ++sample) {
    const double part = static_cast<double>(sample) / static_cast<double>(kRestSamples);
    const double time = sample == kRestSamples ? scenario.end : scenario.end * part;
    const Spent spent = advance(runner, time);
    run.seconds += spent.wall;
    run.cpu_seconds += spent.cpu;
    if (sample == kJudgeCostAtSample && run.seconds / part > kFarTooLong * limit) {
      throw TooLong(fmt::format("would take about {:.3g} s, its time limit is {:.3g} s",
                                run.seconds / part, limit));
    }
    told(part);
    const std::vector<Ball> balls = simulation.state();
    const std::optional<Gravity> pull = simulation.effects().gravity;
    const Vec2 gravity = pull ? pull->acceleration : Vec2{0, 0};
    if (sample == kLastThird) third = balls;
    if (sample > kLastThird) {
      run.creep = std::max(run.creep, farthest_move(third, balls, scenario.start.box));
    }
    const double scale = lift(balls, gravity);
    run.kinetic_energy = scale > 0 ? kinetic_energy(balls) / scale : 0;
    if (run.kinetic_energy > kAtRest) {
      run.rest_time.reset();
    } else if (!run.rest_time) {
      run.rest_time = time;
    }
    if (sample < kRestSamples) continue;
    run.equilibrium_residual =
        equilibrium_residual(balls, scenario.start.box, simulation.effects());
    run.height = height(balls, gravity);
  }
  const Measurements measured = simulation.measure();
  run.dissipation_error = std::abs(measured.relative_energy_error());
  run.max_overlap = measured.max_overlap;
  run.ball_ball = measured.ball_ball;
  run.ball_wall = measured.ball_wall;
  return run;
}

}  // namespace carom::accuracy
