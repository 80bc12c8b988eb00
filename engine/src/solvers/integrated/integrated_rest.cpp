#include "solvers/integrated/integrated_solver.hpp"

#include <algorithm>
#include <cmath>

#include "contact/dissipation.hpp"
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

// What has pressed on in the step is stopped and put side by side, in passes to and fro.
void IntegratedSolver::settle() {
  std::sort(resting_.begin(), resting_.end(),
            [](const Meeting& m, const Meeting& k) { return m.who() < k.who(); });
  const auto sweep = [](std::vector<Meeting>& meetings, int passes, auto act) {
    for (int pass = 0; pass < passes; ++pass) {
      bool any = false;
      for (const Meeting& meeting : meetings) any |= act(meeting);
      std::reverse(meetings.begin(), meetings.end());
      if (!any) return;
    }
  };
  sweep(resting_, 16, [this](const Meeting& meeting) { return stop(meeting); });
  for (std::uint32_t i = 0; i < balls(); ++i) {
    effects::Member ball = member(i);
    if (put_inside(ball)) put_back(ball);
  }
  if (resting_.empty() || !collides()) return;
  // Putting two apart may push others together that have not met in this step.
  constexpr double kNear = 1.25;  // of the sum of the radii
  std::vector<Meeting> near = near_pairs(kNear);
  sweep(near, 64, [this](const Meeting& meeting) { return put_apart(meeting); });
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

bool IntegratedSolver::stop(const Meeting& meeting) {
  effects::Member a = member(meeting.i);
  if (meeting.with_wall()) {
    const std::uint32_t side = meeting.j - Meeting::kWall;
    const std::size_t axis = side / 2;
    const double outwards = side % 2 == 1 ? 1 : -1;
    const std::size_t k = axis;
    const double wall =
        outwards > 0 ? domain_.highest(axis, a.radius) : domain_.lowest(axis, a.radius);
    const double pressing = outwards * a.velocity[k];
    if (outwards * (a.position[k] - wall) < 0 || !(pressing > 0)) return false;
    a.velocity[k] = 0;
    Rubbed rubbed;
    if (effects_.friction) {
      rubbed = effects::rub_wall(a, axis, outwards * pressing, effects_.friction->walls);
    }
    rubbed.lost += lost_to_restitution(pressing, 0, 1);
    state_.lost[meeting.i] += a.mass * rubbed.lost;
    Vec2 normal{0, 0};
    normal[k] = outwards;
    note(meeting, part_end_, false, normal, a.radius, a.mass * pressing,
         {a.mass * rubbed.impulse, a.mass * rubbed.lost});
    put_back(a);
    return true;
  }
  effects::Member b = member(meeting.j);
  const LineOfCentres line = line_between(a, b);
  const double closing = (b.velocity - a.velocity).dot(line.r);
  if (line.distance >= a.radius + b.radius) return false;
  if (!approaches(closing, line.length, a.velocity, b.velocity)) return false;
  const double j = impulse(closing, line.square, a.inverse_mass + b.inverse_mass, 0);
  a.velocity -= j * a.inverse_mass * line.r;
  b.velocity += j * b.inverse_mass * line.r;
  Rubbed rubbed;
  if (effects_.friction) {
    rubbed = effects::rub(a, b, line, j * line.length, effects_.friction->balls);
  }
  rubbed.lost += lost_to_restitution(-closing / line.length, 0, a.inverse_mass + b.inverse_mass);
  state_.lost[meeting.i] += rubbed.lost;
  note(meeting, part_end_, false, line.r / line.length, line.distance, j * line.length, rubbed);
  put_back(a);
  put_back(b);
  return true;
}

bool IntegratedSolver::put_inside(effects::Member& ball) const {
  if (ball.inverse_mass == 0) return false;
  const Vec2 from = ball.position;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain_.solid(axis)) continue;
    double& x = ball.position[axis];
    x = std::clamp(x, domain_.lowest(axis, ball.radius), domain_.highest(axis, ball.radius));
  }
  return ball.position != from;
}

// By their inverse masses; what a wall holds back the other has to give.
bool IntegratedSolver::put_apart(const Meeting& meeting) {
  constexpr double kClose = 1 - 0x1p-40;  // of the sum of the radii: as good as apart
  effects::Member a = member(meeting.i);
  effects::Member b = member(meeting.j);
  const double reach = a.radius + b.radius;
  const auto push = [&](double weight_a, double weight_b) {
    const LineOfCentres line = line_between(a, b);
    if (line.distance >= reach * kClose || !(weight_a + weight_b > 0)) return false;
    const double depth = reach - line.distance;
    const Vec2 move = depth / (line.length * (weight_a + weight_b)) * line.r;
    a.position -= weight_a * move;
    b.position += weight_b * move;
    put_inside(a);
    put_inside(b);
    state_.deepest = std::max(state_.deepest, depth / std::min(a.radius, b.radius));
    return true;
  };
  if (!push(a.inverse_mass, b.inverse_mass)) return false;
  push(0, b.inverse_mass);
  push(a.inverse_mass, 0);
  put_back(a);
  put_back(b);
  return true;
}

}  // namespace carom
