#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "support/event_contact.hpp"

namespace carom::test {

/// A run of the exact method, looked at now and then.
class Course {
 public:
  Course(const Scene& scene, const std::vector<Ball>& balls)
      : solver_(std::make_unique<EventSolver>(scene, balls)) {}

  std::vector<Ball> at(double time) {
    test::advance(*solver_, time);
    return solver_->state();
  }
  Measurements measured() const {
    Measurements result;
    solver_->count(result);
    return result;
  }
  std::uint64_t impacts() const { return measured().ball_ball + measured().ball_wall; }
  Solver& solver() { return *solver_; }

 private:
  std::unique_ptr<Solver> solver_;
};

inline double speed(const Ball& b) {
  return b.velocity.norm();
}

/// In smaller radii.
inline double deepest_overlap(const std::vector<Ball>& balls) {
  double deepest = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = balls[i].radius + balls[j].radius;
      const double gap = (balls[i].position - balls[j].position).norm() - reach;
      deepest = std::max(deepest, -gap / std::min(balls[i].radius, balls[j].radius));
    }
  }
  return deepest;
}

}  // namespace carom::test
