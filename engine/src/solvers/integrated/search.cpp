#include "solvers/integrated/solver.hpp"

#include <algorithm>

#include "state/stopwatch.hpp"

namespace carom {

void IntegratedSolver::search(Share share) {
  Find& find = finds_[share.index];
  find.first = {};
  find.slow.clear();
  const auto n = static_cast<std::uint32_t>(balls());
  const auto look = [&](std::uint32_t i, std::uint32_t j, const std::optional<double>& at) {
    if (!at || *at > find.first.at) return;
    Meeting meeting{*at, i, j};
    if (rests(meeting)) return;
    if (is_slow(meeting)) {
      find.slow.push_back(meeting);
      return;
    }
    meeting.closing = closing_speed(meeting, start_position_, start_velocity_);
    if (meeting.before(find.first)) find.first = meeting;
  };
  if (domain_.solid(0) || domain_.solid(1)) {
    const Stopwatch stopwatch(timed(), find.seconds.of<Walls>());
    for (auto i = static_cast<std::uint32_t>(share.begin(n)); i < share.end(n); ++i) {
      for (std::uint32_t side = 0; side < 4; ++side)
        look(i, Meeting::kWall + side, meet_wall(i, side));
    }
  }
  if (!collides()) return;
  const Stopwatch stopwatch(timed(), find.seconds.of<Collisions>());
  for (auto i = static_cast<std::uint32_t>(share.index); i < n;
       i += static_cast<std::uint32_t>(share.count)) {
    for (std::uint32_t j = i + 1; j < n; ++j) look(i, j, meet(i, j));
  }
}

double IntegratedSolver::closing_speed(const Meeting& meeting,
                                       const std::array<Balls::Column, 2>& position,
                                       const std::array<Balls::Column, 2>& velocity) const {
  const std::size_t a = meeting.i;
  if (meeting.with_wall()) {
    const std::uint32_t side = meeting.j - Meeting::kWall;
    return (side % 2 == 1 ? 1 : -1) * velocity[side / 2][a];
  }
  const std::size_t b = meeting.j;
  const Vec2 r =
      nearest_image({position[0][b] - position[0][a], position[1][b] - position[1][a]}, domain_);
  const Vec2 v{velocity[0][b] - velocity[0][a], velocity[1][b] - velocity[1][a]};
  const LineOfCentres line = line_of_centres(r, v);
  return -v.dot(line.r) / line.length;
}

std::optional<double> IntegratedSolver::meet_wall(std::uint32_t i, std::uint32_t side) const {
  const std::size_t axis = side / 2;
  if (!domain_.solid(axis) || state_.balls.fixed(i)) return std::nullopt;
  const std::size_t k = i;
  const double radius = state_.balls.radius[k];
  const bool upper = side % 2 == 1;
  const double wall = upper ? domain_.highest(axis, radius) : domain_.lowest(axis, radius);
  if (upper ? high_[axis][k] < wall : low_[axis][k] > wall) return std::nullopt;
  const double sign = upper ? -1 : 1;
  const double v0 = start_velocity_[axis][k];
  const double v1 = state_.balls.velocity[axis][k];
  const Bernstein<5> height = quintic(piece_, sign * (start_position_[axis][k] - wall), sign * v0,
                                      sign * acceleration(axis, i, v0, start_pull_[axis][k]),
                                      sign * (state_.balls.position[axis][k] - wall), sign * v1,
                                      sign * acceleration(axis, i, v1, state_.balls.pull[axis][k]));
  return first_landing(height, sign * v0);
}

std::optional<double> IntegratedSolver::meet(std::uint32_t i, std::uint32_t j) const {
  const Balls& balls = state_.balls;
  const std::size_t a = i;
  const std::size_t b = j;
  const double reach = balls.radius[a] + balls.radius[b];
  std::array<double, 2> shift{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] > 0) {
      const double apart = start_position_[axis][b] - start_position_[axis][a];
      shift[axis] = nearest_image(apart, domain_.period[axis]) - apart;
    }
    if (low_[axis][b] - high_[axis][a] + shift[axis] > reach) return std::nullopt;
    if (high_[axis][b] - low_[axis][a] + shift[axis] < -reach) return std::nullopt;
  }
  if (balls.fixed(i) && balls.fixed(j)) return std::nullopt;
  std::array<Bernstein<5>, 2> path;
  Vec2 velocity;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& v0 = start_velocity_[axis];
    const auto& v1 = balls.velocity[axis];
    const auto& p0 = start_pull_[axis];
    const auto& p1 = balls.pull[axis];
    path[axis] = quintic(
        piece_, start_position_[axis][b] - start_position_[axis][a] + shift[axis], v0[b] - v0[a],
        acceleration(axis, j, v0[b], p0[b]) - acceleration(axis, i, v0[a], p0[a]),
        balls.position[axis][b] - balls.position[axis][a] + shift[axis], v1[b] - v1[a],
        acceleration(axis, j, v1[b], p1[b]) - acceleration(axis, i, v1[a], p1[a]));
    velocity[axis] = v0[b] - v0[a];
  }
  return first_contact(path[0], path[1], velocity, reach);
}

}  // namespace carom
