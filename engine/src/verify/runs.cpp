#include "verify/runs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "carom/scene.hpp"

namespace carom::hard {

namespace {

/// The scene at the end of its time with reversed velocities.  Setting gravity again starts all
/// flights at their present places, so that the velocities are reversed in all their digits.
Scene turned(const Scene& scene) {
  Simulation simulation(scene);
  simulation.advance_to(scene.duration);
  Effects same;
  same.gravity = scene.effects.gravity;
  simulation.apply(command::SetEffects{same});
  Scene back = simulation.save();
  const auto turn = [](std::string& number) {
    if (number.starts_with('-')) {
      number.erase(0, 1);
    } else {
      number.insert(0, 1, '-');
    }
  };
  for (SavedFlight& flight : back.continuation->flights) {
    for (std::string& component : flight.velocity) turn(component);
  }
  for (Ball& each : back.balls) each.velocity *= -1;
  return back;
}

}  // namespace

Ball ball(double x, double y, double vx, double vy, double radius, double mass) {
  Ball result;
  result.position = {x, y};
  result.velocity = {vx, vy};
  result.radius = radius;
  result.mass = mass;
  return result;
}

Scene with_balls(const Scene& scene, std::vector<Ball> balls) {
  Scene result = scene;
  result.fills.clear();
  result.balls = std::move(balls);
  return result;
}

Outcome run(const Scene& scene, double time) {
  Simulation simulation(scene);
  simulation.advance_to(time);
  return {simulation.state(), simulation.measure()};
}

double farthest(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result = std::max(result, (a[i].position - b[i].position).norm());
  }
  return result;
}

double different(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  const auto same = [](double x, double y) {
    // 0 and -0 are the same place.
    return x == y || std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  double count = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const bool all = same(a[i].position.x(), b[i].position.x()) &&
                     same(a[i].position.y(), b[i].position.y()) &&
                     same(a[i].velocity.x(), b[i].velocity.x()) &&
                     same(a[i].velocity.y(), b[i].velocity.y()) && same(a[i].spin, b[i].spin);
    if (!all) ++count;
  }
  return count;
}

double momentum_error(const Scene& scene, const Outcome& outcome) {
  double size = 0;
  for (const Ball& each : populate(scene)) size += each.mass * each.velocity.norm();
  const Vec2 change = outcome.measured.momentum_final - outcome.measured.momentum_initial;
  return size > 0 ? change.norm() / size : change.norm();
}

double energy_error(const Measurements& measured) {
  return std::abs(measured.relative_energy_error());
}

double way_back(const Scene& scene) {
  return farthest(run(turned(scene), 2 * scene.duration).balls, populate(scene));
}

}  // namespace carom::hard
