#include "solvers/event/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "carom/scene_file.hpp"
#include "solvers/event/make_core.hpp"
#include "solvers/sampling.hpp"
#include "state/balls.hpp"
#include "state/totals.hpp"

namespace carom {

namespace {

constexpr double kSamePlace = 0x1p-30;  // of the box: more than rounding can move a ball

std::vector<Ball> with_fixed_at_rest(std::vector<Ball> balls) {
  for (Ball& ball : balls) {
    if (ball.fixed) ball.velocity = {0, 0};
  }
  return balls;
}

/// The balls are the core's: they are in memory once.
event::CoreInPrecision core_of(const Scene& scene, std::vector<Ball> balls,
                               const event::Sharing& sharing) {
  event::CoreStart start{Domain(scene.box, has_walls(scene.effects)),
                         scene.effects,
                         {},
                         scene.continuation.value_or(Continuation{}),
                         event::may_rest(scene, balls),
                         worker_count(scene, balls.size()),
                         sharing,
                         scene.source};
  start.balls = std::move(balls);
  return event::make_core(std::move(start), scene.solver.digits);
}

}  // namespace

EventSolver::EventSolver(const Scene& scene, std::vector<Ball> balls, const event::Sharing& sharing)
    : domain_(scene.box, has_walls(scene.effects)),
      effects_(scene.effects),
      core_(core_of(scene, with_fixed_at_rest(std::move(balls)), sharing)) {
  if (scene.continuation && !scene.continuation->flights.empty()) refuse_other_places(scene);
}

// A ball may have been moved by hand: its flight would win without a word.
void EventSolver::refuse_other_places(const Scene& scene) const {
  const std::vector<Ball> balls = state();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec2& is = balls[i].position;
    const Vec2 off = nearest_image(is - scene.balls[i].position, domain_);
    if (std::abs(off.x()) <= kSamePlace * (domain_.upper[0] - domain_.lower[0]) &&
        std::abs(off.y()) <= kSamePlace * (domain_.upper[1] - domain_.lower[1])) {
      continue;
    }
    throw SceneError(
        scene.source,
        {{fmt::format("/balls/{}/position", i),
          fmt::format("is not where /continuation/flights/{} has the ball, ({}, {}): leave "
                      "\"flights\" out to go on from the positions",
                      i, is.x(), is.y())}});
  }
}

void EventSolver::add(const Ball& ball) {
  core_->add(ball);
}

void EventSolver::remove(std::size_t ball) {
  core_->remove(ball);
}

void EventSolver::set(const Effects& effects) {
  if (effects.walls) {
    effects_.walls = effects.walls;
    for (Domain::Sides& sides : domain_.sides) {
      if (sides == Domain::Sides::periodic) continue;
      sides = has_walls(effects_) ? Domain::Sides::walls : Domain::Sides::open;
    }
  }
  if (effects.collisions) effects_.collisions = effects.collisions;
  if (effects.friction) effects_.friction = effects.friction;
  if (effects.gravity) effects_.gravity = effects.gravity;
  if (effects.drag) effects_.drag = effects.drag;
  core_->set(domain_, effects_, effects.gravity || effects.drag);
}

// A few balls at a time: the state is in memory once, as flights.
void EventSolver::visit_state(const BallVisitor& visit) const {
  std::array<Ball, 256> buffer;
  const std::vector<Ball>& balls = core_->balls();
  for (std::size_t first = 0; first < balls.size(); first += buffer.size()) {
    const std::size_t count = std::min(buffer.size(), balls.size() - first);
    std::copy_n(balls.begin() + static_cast<std::ptrdiff_t>(first), count, buffer.begin());
    core_->read_balls(first, std::span(buffer.data(), count));
    for (std::size_t k = 0; k < count; ++k) {
      Ball& ball = buffer[k];
      for (std::size_t axis = 0; axis < 2 && !ball.fixed; ++axis) {
        if (!domain_.solid(axis)) continue;
        double& x = ball.position[axis];
        x = std::clamp(x, domain_.lowest(axis, ball.radius), domain_.highest(axis, ball.radius));
      }
      visit(ball);
    }
  }
}

std::string EventSolver::state_hash() const {
  StateHash hash(balls(), effects_.friction.has_value());
  visit_state([&hash](const Ball& ball) { hash.add(ball); });
  return hash.text();
}

// In one pass over the state.
Solver::Sums EventSolver::sums() const {
  const Vec2 gravity = effects_.gravity ? effects_.gravity->acceleration : Vec2{0, 0};
  const Turns turns = core_->turns();
  Totals totals(effects_.friction.has_value(), gravity, {domain_.period[0], domain_.period[1]},
                turns);
  visit_state([&totals](const Ball& ball) { totals.add(ball); });
  return {totals.energy() - core_->energy_ahead(), totals.momentum()};
}

void EventSolver::count(Measurements& measurements) const {
  const event::Tally tally = core_->tally();
  measurements.ball_ball += tally.ball_ball;
  measurements.ball_wall += tally.ball_wall;
  measurements.joint_impacts += tally.joint_impacts;
  measurements.jammed += tally.jammed;
  measurements.resting_contacts += tally.resting_contacts;
  measurements.islands_again += tally.islands_again;
  measurements.max_overlap = std::max(measurements.max_overlap, tally.max_overlap);
  EffectSeconds seconds;
  seconds.of<Collisions>() = tally.collisions;
  seconds.of<Walls>() = tally.walls;
  seconds.of<Friction>() = tally.friction;
  // Where both bend the flights it is by one formula.
  const double parts = effects_.gravity && effects_.drag ? 2 : 1;
  seconds.of<Gravity>() = tally.bending / parts;
  seconds.of<Drag>() = tally.bending / parts;
  add_seconds(effects_, seconds, measurements);
}

void EventSolver::save(Scene& scene) const {
  scene.solver.method = Method::event;
  scene.continuation->step_origin = scene.continuation->time;
  core_->save(*scene.continuation);
}

}  // namespace carom
