#include "accuracy/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "accuracy/nonnegative_least_squares.hpp"
#include "carom/shorter_way.hpp"

namespace carom::accuracy {
namespace {

constexpr double kContact = 1e-3;  // widest gap, in radii

/// The columns of G: what a unit of force along each edge of each friction cone does to the balls.
///
/// Rows: x, y, and with friction the torque over the radius, of each ball that can move.
class Contacts {
 public:
  Contacts(const std::vector<Ball>& balls, const Box& box, const Effects& effects)
      : balls_(balls), box_(box), effects_(effects), rows_each_(effects.friction ? 3 : 2) {
    for (const Ball& ball : balls_) row_.push_back(ball.fixed ? -1 : rows_each_ * moving_++);
    if (has_walls(effects_)) find_at_walls();
    if (has_collisions(effects_)) find_between_balls();
  }

  [[nodiscard]] LeastSquares problem() const {
    LeastSquares problem;
    problem.rows = rows_each_ * moving_;
    problem.columns = columns_;
    problem.matrix = entries_;
    problem.target.assign(static_cast<std::size_t>(problem.rows), 0);
    const Vec2& g = effects_.gravity->acceleration;
    double sum = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (row_[i] < 0) continue;
      const auto row = static_cast<std::size_t>(row_[i]);
      problem.target[row] = -balls_[i].mass * g.x();
      problem.target[row + 1] = -balls_[i].mass * g.y();
      sum += balls_[i].mass * balls_[i].mass * g.squaredNorm();
    }
    for (double& each : problem.target) each /= std::sqrt(sum);
    return problem;
  }
  [[nodiscard]] int moving() const { return moving_; }

 private:
  void find_at_walls() {
    const Vec2 lower = box_.lower();
    const Vec2 upper = box_.upper();
    const double mu = effects_.friction ? effects_.friction->walls : 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const Ball& ball = balls_[i];
      if (ball.fixed) continue;
      const double widest = kContact * ball.radius;
      if (!box_.periodic[0]) {
        if (ball.position.x() - ball.radius - lower.x() < widest) add_cone(-1, i, {1, 0}, mu);
        if (upper.x() - ball.position.x() - ball.radius < widest) add_cone(-1, i, {-1, 0}, mu);
      }
      if (!box_.periodic[1]) {
        if (ball.position.y() - ball.radius - lower.y() < widest) add_cone(-1, i, {0, 1}, mu);
        if (upper.y() - ball.position.y() - ball.radius < widest) add_cone(-1, i, {0, -1}, mu);
      }
    }
  }

  void find_between_balls() {
    const double mu = effects_.friction ? effects_.friction->balls : 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t j = i + 1; j < balls_.size(); ++j) {
        if (balls_[i].fixed && balls_[j].fixed) continue;
        const Vec2 r = shorter_way(balls_[j].position - balls_[i].position, box_);
        const double touch = balls_[i].radius + balls_[j].radius;
        const double far = touch + kContact * std::min(balls_[i].radius, balls_[j].radius);
        if (std::abs(r.x()) >= far || std::abs(r.y()) >= far) continue;
        const double distance = r.norm();
        if (distance >= far || distance == 0) continue;
        add_cone(static_cast<int>(i), j, r / distance, mu);
      }
    }
  }

  /// `from`: the ball that pushes, or a wall; `normal` from it to the ball `to`.
  void add_cone(int from, std::size_t to, const Vec2& normal, double mu) {
    const Vec2 tangent{-normal.y(), normal.x()};
    for (const double side : {1.0, -1.0}) {
      const Vec2 force = normal + side * mu * tangent;
      add(to, force, -side * mu);
      if (from >= 0) add(static_cast<std::size_t>(from), -force, -side * mu);
      ++columns_;
      if (mu == 0) return;
    }
  }

  void add(std::size_t ball, const Vec2& force, double torque) {
    const int row = row_[ball];
    if (row < 0) return;
    entries_.push_back({row, columns_, force.x()});
    entries_.push_back({row + 1, columns_, force.y()});
    if (rows_each_ == 3 && torque != 0) entries_.push_back({row + 2, columns_, torque});
  }

  const std::vector<Ball>& balls_;
  const Box& box_;
  const Effects& effects_;
  int rows_each_;
  int moving_ = 0;
  int columns_ = 0;
  std::vector<int> row_;  // the first of each ball; -1: it is fixed
  std::vector<MatrixEntry> entries_;
};

}  // namespace

double equilibrium_residual(const std::vector<Ball>& balls, const Box& box,
                            const Effects& effects) {
  if (!effects.gravity || effects.gravity->acceleration.squaredNorm() == 0) return 0;
  const Contacts contacts(balls, box, effects);
  if (contacts.moving() == 0) return 0;
  return least_residual(contacts.problem());
}

}  // namespace carom::accuracy
