#include "solvers/integrated/solver.hpp"

#include <algorithm>
#include <cmath>

#include "effects/attraction.hpp"
#include "effects/drag.hpp"
#include "effects/energy.hpp"
#include "effects/gravity.hpp"
#include "solvers/sampling.hpp"
#include "state/stopwatch.hpp"

namespace carom {

IntegratedSolver::IntegratedSolver(const Scene& scene, const std::vector<Ball>& balls)
    : box_(scene.box),
      domain_(scene.box, has_walls(scene.effects)),
      effects_(scene.effects),
      step_(scene.solver.step),
      finds_(1) {
  state_.balls = Balls(balls, scene.effects);
  if (scene.continuation) {
    step_origin_ = scene.continuation->step_origin;
    steps_ = scene.continuation->steps;
    time_ = scene.continuation->time;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] == 0) continue;
    for (double& x : state_.balls.position[axis]) x = domain_.wrapped(axis, x);
  }
  renew_rules();
  if (scene.continuation) look_ahead();
}

// A saved run goes on from its last whole step, and shows what it showed.
void IntegratedSolver::look_ahead() {
  std::size_t phase = aim(time_);
  while (phase != Phase::kFrameDone) {
    if (phase == kFly) {
      fly({});
      phase = after_stage();
    } else {
      search({});
      phase = after_search();
    }
  }
}

std::vector<Phase> IntegratedSolver::phases() {
  std::vector<Phase> phases;
  phases.push_back(
      {"attraction", [this](Share share) { fly(share); }, [this] { return after_stage(); }});
  if (effects_.collisions || effects_.walls) {
    phases.push_back({effects_.collisions ? "pair_computation" : "wall_computation",
                      [this](Share share) { search(share); }, [this] { return after_search(); }});
  }
  return phases;
}

std::size_t IntegratedSolver::aim(double time) {
  // Rounding of times and of their quotient must not lose a step, nor make one of next to nothing.
  constexpr double kRounding = 0x1p-44;
  time_ = time;
  if (whole_) {
    state_ = std::move(*whole_);
    whole_.reset();
    shown_.clear();
  }
  const double rounding = std::abs(time) * kRounding;
  const double due = (time - step_origin_ + rounding) / step_;
  target_ = std::max(steps_, due > 0 ? static_cast<std::uint64_t>(due) : 0);
  extra_ = time - (step_origin_ + static_cast<double>(target_) * step_);
  if (extra_ <= rounding) extra_ = 0;
  if (steps_ < target_) return begin_step(step_);
  if (extra_ == 0) return Phase::kFrameDone;
  whole_ = state_;
  return begin_step(extra_);
}

bool IntegratedSolver::timed() const {
  return is_sampled(taken_);
}

bool IntegratedSolver::meets_anything() const {
  return collides() || domain_.solid(0) || domain_.solid(1);
}

// --- steps and pieces -------------------------------------------------------------------------

std::size_t IntegratedSolver::begin_step(double length) {
  const double part = step_ / Splitting::kInAStep;
  part_end_ = 0;
  parts_ = Splitting::kInAStep;
  tail_ = 0;
  if (length < step_) {
    parts_ = static_cast<std::size_t>(length / part);
    tail_ = length - static_cast<double>(parts_) * part;
  }
  resting_.clear();
  struck_.clear();
  if (state_.pull_known) {
    find_resting();
    return next_part();
  }
  stage_ = kPullOnly;
  return kFly;
}

std::size_t IntegratedSolver::next_part() {
  if (parts_ > 0) {
    --parts_;
    remaining_ = step_ / Splitting::kInAStep;
  } else if (tail_ > 0) {
    remaining_ = std::exchange(tail_, 0);
  } else {
    return end_step();
  }
  part_end_ += remaining_;
  return begin_piece(remaining_);
}

std::size_t IntegratedSolver::begin_piece(double length) {
  piece_ = length;
  stage_ = 0;
  start_position_ = state_.balls.position;
  start_velocity_ = state_.balls.velocity;
  start_lost_ = state_.losses.by_ball;
  for (std::size_t s = 0; s <= Splitting::kStages; ++s) {
    Stage& stage = stages_[s];
    stage.kick = Splitting::kPull[s] * length;
    if (s == Splitting::kStages) break;
    stage.step = Splitting::kFlight[s] * length;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double along = gravity_[axis];
      stage.glide[axis] = Glide{stage.step};
      if (drag_rate_ > 0) {
        stage.glide[axis] = effects::slowed(drag_rate_, stage.step, along);
      } else if (along != 0) {
        stage.glide[axis] = effects::fall(along, stage.step);
      }
    }
  }
  return kFly;
}

std::size_t IntegratedSolver::after_stage() {
  if (stage_ == kPullOnly) {
    state_.pull_known = true;
    find_resting();
    return next_part();
  }
  if (stage_ < Splitting::kStages) {
    std::swap(state_.balls.position, next_);
    ++stage_;
    return kFly;
  }
  state_.pull_known = true;
  if (planned_) {
    remaining_ -= piece_;
    strike(*std::exchange(planned_, std::nullopt));
    return go_on_after_impact();
  }
  return meets_anything() ? std::size_t{kSearch} : next_part();
}

std::size_t IntegratedSolver::after_search() {
  Meeting first;
  for (const Find& find : finds_) {
    if (find.first.before(first)) first = find.first;
  }
  for (const Find& find : finds_) {
    for (const Meeting& slow : find.slow) {
      if (slow.at <= first.at) resting_.push_back(slow);
    }
  }
  if (first.at > 1) return next_part();
  const double length = first.at * piece_;
  back_to_start();
  if (length > 0) {
    planned_ = first;
    return begin_piece(length);
  }
  strike(first);
  return go_on_after_impact();
}

std::size_t IntegratedSolver::go_on_after_impact() {
  return remaining_ > 0 ? begin_piece(remaining_) : next_part();
}

std::size_t IntegratedSolver::end_step() {
  settle();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] == 0) continue;
    for (std::size_t i = 0; i < balls(); ++i) {
      double& x = state_.balls.position[axis][i];
      const double image = domain_.wrapped(axis, x);
      if (image == x) continue;
      if (!state_.turns[axis].empty()) {
        state_.turns[axis][i] +=
            static_cast<std::int64_t>(std::rint((x - image) / domain_.period[axis]));
      }
      x = image;
      state_.pull_known = false;
    }
  }
  if (whole_) return Phase::kFrameDone;
  ++taken_;
  ++steps_;
  if (steps_ < target_) return begin_step(step_);
  if (extra_ == 0) return Phase::kFrameDone;
  whole_ = state_;
  return begin_step(extra_);
}

void IntegratedSolver::back_to_start() {
  state_.balls.position = start_position_;
  state_.balls.velocity = start_velocity_;
  state_.balls.pull = start_pull_;
  state_.losses.by_ball = start_lost_;
}

// What is shown becomes the run, and steps are numbered from here.
void IntegratedSolver::restart_steps() {
  whole_.reset();
  log_.impacts.insert(log_.impacts.end(), shown_.begin(), shown_.end());
  shown_.clear();
  step_origin_ = time_;
  steps_ = 0;
  state_.pull_known = false;
  renew_rules();
}

void IntegratedSolver::add(const Ball& ball) {
  std::vector<Ball> balls = state_.balls.to_vector();
  balls.push_back(ball);
  state_.balls = Balls(balls, effects_);
  for (auto& turns : state_.turns) {
    if (!turns.empty()) turns.push_back(0);
  }
  restart_steps();
}

void IntegratedSolver::remove(std::size_t ball) {
  std::vector<Ball> balls = state_.balls.to_vector();
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(ball));
  state_.losses.restart(0);
  state_.balls = Balls(balls, effects_);
  for (auto& turns : state_.turns) {
    if (!turns.empty()) turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(ball));
  }
  restart_steps();
}

void IntegratedSolver::set(const Effects& effects) {
  assign(effects_, effects);
  restart_steps();
}

void IntegratedSolver::set_step(double step) {
  step_ = step;
  restart_steps();
}

void IntegratedSolver::renew_rules() {
  gravity_ = effects_.gravity ? effects_.gravity->acceleration : Vec2{0, 0};
  drag_rate_ = effects_.drag ? effects_.drag->rate : 0;
  domain_ = Domain(box_, has_walls(effects_));
  const std::size_t n = balls();
  if (state_.losses.by_ball.size() != n) state_.losses.restart(n);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (auto* columns : {&next_, &start_pull_, &low_, &high_}) {
      (*columns)[axis] = Balls::Column(n, 0.0);
    }
    if (gravity_[axis] != 0 && domain_.period[axis] > 0) {
      state_.turns[axis].resize(balls(), 0);
    }
  }
}

// --- looking ----------------------------------------------------------------------------------

double IntegratedSolver::energy() const {
  return effects::energy(state_.balls, effects_, domain_, state_.turns);
}

void IntegratedSolver::count(Measurements& measurements) const {
  measurements.ball_ball += state_.ball_ball;
  measurements.ball_wall += state_.ball_wall;
  measurements.max_overlap = std::max(measurements.max_overlap, state_.deepest);
  EffectSeconds seconds;
  for (const Find& find : finds_) seconds += find.seconds;
  seconds *= scale_of_samples(taken_);
  seconds += impacts_;
  add_seconds(effects_, seconds, measurements);
}

void IntegratedSolver::take_impacts(std::vector<Impact>& impacts, bool of_all) {
  log_.move_to(impacts);
  if (!of_all) return;
  impacts.insert(impacts.end(), shown_.begin(), shown_.end());
  shown_.clear();
}

void IntegratedSolver::save(Scene& scene) const {
  scene.effects = effects_;
  scene.solver.step = step_;
  scene.continuation->step_origin = step_origin_;
  scene.continuation->steps = steps_;
}

}  // namespace carom
