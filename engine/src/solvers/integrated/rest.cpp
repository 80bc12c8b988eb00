#include "solvers/integrated/solver.hpp"

#include <algorithm>
#include <cmath>

#include "contact/impulse.hpp"
#include "effects/rest.hpp"

namespace carom {

bool IntegratedSolver::rests(const Meeting& meeting) const {
  return std::any_of(resting_.begin(), resting_.end(),
                     [&](const Meeting& other) { return other.who() == meeting.who(); });
}

double IntegratedSolver::rest_speed(std::uint32_t i, std::uint32_t j) const {
  const double size = acceleration(i).norm() + (i == j ? 0 : acceleration(j).norm());
  return effects::rest_speed(size, step_, 0);
}

// As fast as they were when the piece began, or are when it ends: whichever is more.
bool IntegratedSolver::is_slow(const Meeting& meeting) const {
  const Balls& balls = state_.balls;
  if (meeting.with_wall()) {
    if (effects_.walls->restitution == 1) return false;
    const std::size_t axis = (meeting.j - Meeting::kWall) / 2;
    const std::size_t k = meeting.i;
    const double speed =
        std::max(std::abs(start_velocity_[axis][k]), std::abs(balls.velocity[axis][k]));
    return speed <= rest_speed(meeting.i, meeting.i);
  }
  if (effects_.collisions->restitution == 1) return false;
  const std::size_t a = meeting.i;
  const std::size_t b = meeting.j;
  double before = 0;
  double after = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double v0 = start_velocity_[axis][b] - start_velocity_[axis][a];
    const double v1 = balls.velocity[axis][b] - balls.velocity[axis][a];
    before += v0 * v0;
    after += v1 * v1;
  }
  return std::sqrt(std::max(before, after)) <= rest_speed(meeting.i, meeting.j);
}

// The balls that rest on each other as the step begins.
void IntegratedSolver::find_resting() {
  constexpr double kClose = 1 + 0x1p-33;  // of the sum of the radii: put side by side, and rounding
  const auto n = static_cast<std::uint32_t>(balls());
  const Balls& balls = state_.balls;
  if (collides() && effects_.collisions->restitution < 1) {
    for (const Meeting& near : near_pairs(kClose)) {
      const effects::Member first = member(near.i);
      const effects::Member second = member(near.j);
      const LineOfCentres line = line_between(first, second);
      const double closing = (second.velocity - first.velocity).dot(line.r);
      if (std::abs(closing) <= line.length * rest_speed(near.i, near.j)) resting_.push_back(near);
    }
  }
  if (!effects_.walls || effects_.walls->restitution == 1) return;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t side = 0; side < 4; ++side) {
      const std::size_t axis = side / 2;
      if (!domain_.solid(axis) || balls.fixed(i)) continue;
      const std::size_t k = i;
      const double radius = balls.radius[k];
      const double x = balls.position[axis][k];
      if (side % 2 == 1 ? x < domain_.highest(axis, radius) : x > domain_.lowest(axis, radius)) {
        continue;
      }
      const double outwards = side % 2 == 1 ? 1 : -1;
      const double pull = outwards * acceleration(i)[axis];
      if (pull > 0 && std::abs(balls.velocity[axis][k]) <= rest_speed(i, i)) {
        resting_.push_back({0, i, Meeting::kWall + side});
      }
    }
  }
}

std::vector<IntegratedSolver::Meeting> IntegratedSolver::near_pairs(double within) const {
  std::vector<Meeting> near;
  const Balls& balls = state_.balls;
  const auto n = static_cast<std::uint32_t>(balls.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) {
      const std::size_t a = i;
      const std::size_t b = j;
      const double far = (balls.radius[a] + balls.radius[b]) * within;
      double x = balls.position[0][b] - balls.position[0][a];
      if (domain_.period[0] > 0) x = nearest_image(x, domain_.period[0]);
      if (!(std::abs(x) < far) || (balls.fixed(i) && balls.fixed(j))) continue;
      if (line_between(member(i), member(j)).distance < far) near.push_back({0, i, j});
    }
  }
  return near;
}

}  // namespace carom
