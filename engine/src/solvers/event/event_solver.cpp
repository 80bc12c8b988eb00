#include "solvers/event/event_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

}  // namespace

EventSolver::EventSolver(const Scene& scene, std::vector<Ball> balls, const event::Sharing& sharing)
    : domain_(scene.box, has_walls(scene.effects)),
      effects_(scene.effects),
      balls_(with_fixed_at_rest(std::move(balls))),
      core_(
          event::make_core({domain_, effects_, balls_, scene.continuation.value_or(Continuation{}),
                            event::may_rest(scene, balls_), worker_count(scene, balls_.size()),
                            sharing, scene.source},
                           scene.solver.digits)) {
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
  balls_.push_back(ball);
  core_->add(ball);
}

void EventSolver::remove(std::size_t ball) {
  balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(ball));
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

std::vector<Ball> EventSolver::state() const {
  std::vector<Ball> result = balls_;
  core_->look(result);
  for (Ball& ball : result) {
    if (ball.fixed) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain_.solid(axis)) continue;
      double& x = ball.position[axis];
      x = std::clamp(x, domain_.lowest(axis, ball.radius), domain_.highest(axis, ball.radius));
    }
  }
  return result;
}

std::string EventSolver::state_hash() const {
  return carom::state_hash(Balls(state(), effects_));
}

double EventSolver::energy() const {
  const Balls balls(state(), effects_);
  const Vec2 gravity = effects_.gravity ? effects_.gravity->acceleration : Vec2{0, 0};
  const double spins = effects_.friction ? spin_energy(balls) : 0;
  return kinetic_energy(balls) + spins - core_->energy_ahead() +
         potential_energy(balls, gravity, {domain_.period[0], domain_.period[1]}, core_->turns());
}

Vec2 EventSolver::momentum() const {
  return carom::momentum(Balls(state()));
}

void EventSolver::count(Measurements& measurements) const {
  const event::Tally tally = core_->tally();
  measurements.ball_ball += tally.ball_ball;
  measurements.ball_wall += tally.ball_wall;
  measurements.joint_impacts += tally.joint_impacts;
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
