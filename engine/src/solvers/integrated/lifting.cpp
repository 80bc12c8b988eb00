// What it takes to put balls side by side at the end of a step.
//
// A ball at rest falls through its support during the step, is stopped there and lifted back.  The
// lift takes the energy that the fall gave and that the stop took: it is paid from there, and what
// is left of it was lost.  On a curved obstacle a ball is lifted by more than it fell: its motion
// pays for the rest, where nothing that moves too has a part in it.  Where balls are lifted out of
// each other, or out of a cleft by a little too much, they will fall by it again: what was lost
// before pays, as far as there is any.
#include <algorithm>
#include <cmath>

#include "numbers/exact_sum.hpp"
#include "solvers/integrated/solver.hpp"

namespace carom {

/// What the potential energy of gravity and attraction gained as the ball moved from where it was;
/// two that have both moved share what theirs gained.
double IntegratedSolver::lift(std::uint32_t i, const std::array<Balls::Column, 2>& from) const {
  const Balls& balls = state_.balls;
  const auto moved = [&](std::uint32_t k) {
    return balls.position[0][k] != from[0][k] || balls.position[1][k] != from[1][k];
  };
  if (balls.fixed(i) || !moved(i)) return 0;
  event::ExactSum<double> sum;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    sum.add(-balls.mass[i] * gravity_[axis] * (balls.position[axis][i] - from[axis][i]));
  }
  const Attraction& attraction = *effects_.attraction;
  if (attraction.strength == 0) return sum.rounded();
  const double softening = attraction.softening * attraction.softening;
  for (std::uint32_t j = 0; j < balls.size(); ++j) {
    if (j == i) continue;
    const Vec2 before = nearest_image({from[0][j] - from[0][i], from[1][j] - from[1][i]}, domain_);
    const Vec2 after = nearest_image(balls.at(j) - balls.at(i), domain_);
    const double near = std::sqrt(before.squaredNorm() + softening);
    const double far = std::sqrt(after.squaredNorm() + softening);
    if (!(near > 0) || !(far > 0)) continue;
    const double share = moved(j) ? 0.5 : 1;
    sum.add(share * attraction.strength * balls.mass[i] * balls.mass[j] *
            ((after - before).dot(after + before) / (near * far * (near + far))));
  }
  return sum.rounded();
}

/// `from`: where the balls were before they were stopped.
void IntegratedSolver::pay_for_lifts(const std::array<Balls::Column, 2>& from) {
  // Sums in an order that the numbers of the balls have no part in.
  std::stable_sort(stopped_.begin(), stopped_.end(), [](const Stopped& s, const Stopped& t) {
    return s.ball != t.ball ? s.ball < t.ball : s.lost < t.lost;
  });
  std::vector<double> lost(balls(), 0.0);
  std::vector<const Stopped*> stop(balls(), nullptr);  // one of each ball
  const Stopped* linked_stop = nullptr;
  for (const Stopped& stopped : stopped_) {
    lost[stopped.ball] += stopped.lost;
    stop[stopped.ball] = &stopped;
    state_.losses.by_ball[stopped.ball] += stopped.lost;
    if (linked_[stopped.ball] != 0) linked_stop = &stopped;
  }
  event::ExactSum<double> in_linked;
  event::ExactSum<double> for_linked;
  for (std::uint32_t i = 0; i < balls(); ++i) {
    const double needed = lift(i, from);
    if (linked_[i] != 0) {
      in_linked.add(state_.losses.by_ball[i]);
      for_linked.add(needed);
    } else if (needed != 0) {
      const double left = lost[i] - needed;
      const bool paid = std::abs(left) <= rounding_of_fall(i) || (left < 0 && slow_down(i, -left));
      if (stop[i] == nullptr) continue;
      const double before = state_.losses.by_ball[i] - lost[i];
      book(*stop[i], (paid ? 0 : std::max(left, -before)) - lost[i]);
    }
  }
  if (linked_stop == nullptr) return;
  book(*linked_stop, -std::min(for_linked.rounded(), std::max(in_linked.rounded(), 0.0)));
}

/// With the stop as more that was lost, or less.
void IntegratedSolver::book(const Stopped& stopped, double energy) {
  state_.losses.by_ball[stopped.ball] += energy;
  if (stopped.line < lines().size()) lines()[stopped.line].energy_lost += energy;
}

/// The energy by which the rounding of a ball's place changes a fall in the parts of a step.
double IntegratedSolver::rounding_of_fall(std::uint32_t i) const {
  constexpr double kRounding = 0x1p-50;
  const Vec2 pull = acceleration(i);
  const Vec2 at = state_.balls.at(i);
  return kRounding * state_.balls.mass[i] *
         (std::abs(pull.x() * at.x()) + std::abs(pull.y() * at.y()));
}

/// Whether the ball's motion had that much energy.
bool IntegratedSolver::slow_down(std::uint32_t i, double energy) {
  effects::Member ball = member(i);
  const double turn = ball.radius * ball.spin;
  const double kinetic = ball.mass * (ball.velocity.squaredNorm() / 2 + turn * turn / 4);
  if (!(energy < kinetic)) return false;
  const double slower = std::sqrt(1 - energy / kinetic);
  ball.velocity *= slower;
  ball.spin *= slower;
  put_back(ball);
  return true;
}

}  // namespace carom
