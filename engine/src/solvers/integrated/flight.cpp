#include "solvers/integrated/solver.hpp"

#include <algorithm>

#include "effects/attraction.hpp"
#include "effects/drag.hpp"
#include "effects/gravity.hpp"
#include "state/stopwatch.hpp"

namespace carom {

void IntegratedSolver::fly(Share share) {
  Find& find = finds_[share.index];
  Balls& balls = state_.balls;
  const std::size_t begin = share.begin(balls.size());
  const std::size_t end = share.end(balls.size());
  if (stage_ == kPullOnly) {
    const Stopwatch stopwatch(timed(), find.seconds.of<Attraction>());
    effects::attract(balls, domain_, *effects_.attraction, begin, end);
    return;
  }
  const Stage& stage = stages_[stage_];
  {
    const Stopwatch stopwatch(timed(), find.seconds.of<Attraction>());
    if (stage_ > 0 || !state_.pull_known) {
      effects::attract(balls, domain_, *effects_.attraction, begin, end);
    }
    if (stage_ == 0) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        std::copy(balls.pull[axis].data() + begin, balls.pull[axis].data() + end,
                  start_pull_[axis].data() + begin);
      }
    }
    effects::kick(balls, stage.kick, begin, end);
  }
  if (stage_ == Splitting::kStages) {
    if (meets_anything() && !planned_) draw_paths(begin, end);
    return;
  }
  for (std::size_t i = begin; i < end; i += Flight::kBlock) {
    fly_block(stage, i, std::min(i + Flight::kBlock, end), find);
  }
}

void IntegratedSolver::fly_block(const Stage& stage, std::size_t begin, std::size_t end,
                                 Find& find) {
  Balls& balls = state_.balls;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Flight flight;
    prepare(flight, balls, axis, begin, end, stage.step, stage.glide[axis]);
    flight.lost = state_.losses.by_ball.data() + begin;
    if (drag_rate_ > 0) {
      const Stopwatch stopwatch(timed(), find.seconds.of<Drag>());
      effects::drag(flight);
    } else {
      straight(flight);
    }
    if (stage.glide[axis].gain != 0) {
      const Stopwatch stopwatch(timed(), find.seconds.of<Gravity>());
      effects::gravity(flight);
    }
    land(flight);
    std::copy_n(flight.moved.data(), flight.count, next_[axis].data() + begin);
    std::copy_n(flight.after.data(), flight.count, balls.velocity[axis].data() + begin);
  }
}

double IntegratedSolver::acceleration(std::size_t axis, std::uint32_t i, double velocity,
                                      double pull) const {
  if (state_.balls.fixed(i)) return 0;
  return pull + gravity_[axis] - drag_rate_ * velocity;
}

Vec2 IntegratedSolver::acceleration(std::uint32_t i) const {
  const std::size_t k = i;
  const Balls& balls = state_.balls;
  return {acceleration(0, i, balls.velocity[0][k], balls.pull[0][k]),
          acceleration(1, i, balls.velocity[1][k], balls.pull[1][k])};
}

void IntegratedSolver::draw_paths(std::size_t begin, std::size_t end) {
  const Balls& balls = state_.balls;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t k = i;
      const auto ball = static_cast<std::uint32_t>(i);
      const double v0 = start_velocity_[axis][k];
      const double v1 = balls.velocity[axis][k];
      const Bernstein<5> path = quintic(
          piece_, start_position_[axis][k], v0, acceleration(axis, ball, v0, start_pull_[axis][k]),
          balls.position[axis][k], v1, acceleration(axis, ball, v1, balls.pull[axis][k]));
      const auto [low, high] = std::minmax_element(path.begin(), path.end());
      low_[axis][k] = *low;
      high_[axis][k] = *high;
    }
  }
}

}  // namespace carom
