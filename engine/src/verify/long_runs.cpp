#include <algorithm>
#include <cmath>
#include <numeric>

#include "verify/cases.hpp"
#include "verify/runs.hpp"
#include "verify/transform.hpp"

namespace carom::hard {

namespace {

/// Runs until so many pairs have collided.
Outcome run_collisions(const Scene& scene, double collisions) {
  Simulation simulation(scene);
  double time = 0;
  double step = 0.125;
  while (static_cast<double>(simulation.measure().ball_ball) < collisions) {
    simulation.advance_to(time += step);
    if (step < 64) step *= 1.5;
  }
  return {simulation.state(), simulation.measure()};
}

double dense_overlap(const Trial& trial) {
  return run_collisions(trial.scene, trial.thorough ? 1e7 : 1e6).measured.max_overlap;
}

double drift_energy(const Trial& trial) {
  return energy_error(run_collisions(trial.scene, 1e7).measured);
}

double ratio_energy(const Trial& trial) {
  return energy_error(run_collisions(trial.scene, 1e5).measured);
}

/// By the flow's condition there and back, 10^5 each way at most, in parts of 64 u of the box.
double reversal_error(const Trial& trial) {
  constexpr double kCondition = 100845;
  return way_back(trial.scene) / (64 * kCondition * 0x1p-53 * trial.scene.box.width);
}

double reversal_more_digits(const Trial& trial) {
  const double less = way_back(trial.scene);
  Scene scene = trial.scene;
  scene.solver.digits = 34;
  return way_back(scene) / less;
}

/// Balls in a line between walls are points that pass each other on a line that is shorter by their
/// diameters (D. Jepsen, J. Math. Phys. 6 (1965) 405): fold each free way, sort.
std::vector<double> rods_at(const Scene& scene, double time) {
  const auto n = static_cast<double>(scene.balls.size());
  const double length = scene.box.width - n;  // of unit diameters
  std::vector<double> free;
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const Ball& each = scene.balls[i];
    const double start = each.position.x() - 0.5 - static_cast<double>(i);
    double at = std::fmod(start + each.velocity.x() * time, 2 * length);
    if (at < 0) at += 2 * length;
    free.push_back(at > length ? 2 * length - at : at);
  }
  std::sort(free.begin(), free.end());
  for (std::size_t i = 0; i < free.size(); ++i) free[i] += 0.5 + static_cast<double>(i);
  return free;
}

double rods_error(const Trial& trial) {
  Simulation simulation(trial.scene);
  double worst = 0;
  for (double time = 0.75; time < 2000; time *= 1.5) {
    simulation.advance_to(time);
    const std::vector<Ball> balls = simulation.state();
    const std::vector<double> expected = rods_at(trial.scene, time);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      // A ball that has gone a way v t knows its place to u of that way.
      const double way = trial.scene.box.width + 10 * time;
      worst = std::max(worst, std::abs(balls[i].position.x() - expected[i]) / way);
    }
  }
  return worst;
}

}  // namespace

std::vector<Case> long_cases() {
  return {
      {"dense", {{Method::event, "overlap, in radii", 1e-13, dense_overlap}}},
      {"drift", {{Method::event, "energy, relative", 1e-12, drift_energy}}},
      {"ratio", {{Method::event, "energy, relative", 1e-10, ratio_energy}}},
      {"reversal",
       {{Method::event, "off the start, in 64 condition u", 1, reversal_error},
        {Method::event, "with 34 digits, to that with 16", 1e-3, reversal_more_digits}}},
      {"rods", {{Method::event, "off the exact places, of the way", 1e-14, rods_error}}},
  };
}

}  // namespace carom::hard
