// What a step of method overlap costs: nanoseconds per ball and step of a gas of disks at packing
// 0.30 and temperature 1, for one worker, two, and one for each ball.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace {

using carom::Scene;
using Clock = std::chrono::steady_clock;

// The median of some runs of `seconds` simulated seconds each, in wall-clock seconds.
double median_seconds(carom::Simulation& simulation, double seconds) {
  simulation.advance_to(simulation.time() + seconds);  // warm-up
  std::vector<double> times;
  for (int run = 0; run < 7; ++run) {
    const auto start = Clock::now();
    simulation.advance_to(simulation.time() + seconds);
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + 3, times.end());
  return times[3];
}

double per_ball_step(std::size_t columns, std::size_t rows, double step, std::size_t workers) {
  Scene scene = carom::test::walled_gas(columns, rows, 0.30);
  scene.solver.step = step;
  scene.workers = workers;
  carom::Simulation simulation(scene);
  simulation.advance_to(4);
  const auto balls = static_cast<double>(columns * rows);
  const double seconds = std::max(4000.0, 400000 / balls) * step / 10;
  return median_seconds(simulation, seconds) / (seconds / step) / balls * 1e9;
}

}  // namespace

int main() {
  fmt::print("ns per ball and step, gas of disks at packing 0.30\n");
  fmt::print("{:>8} {:>8} {:>10} {:>10} {:>8}\n", "balls", "step", "1 worker", "2 workers",
             "ratio");
  for (const auto& [columns, rows] : {std::pair<std::size_t, std::size_t>{25, 40}, {100, 100}}) {
    for (const int rate : {60, 240}) {
      const double one = per_ball_step(columns, rows, 1.0 / rate, 1);
      const double two = per_ball_step(columns, rows, 1.0 / rate, 2);
      fmt::print("{:>8} {:>8} {:>10.1f} {:>10.1f} {:>8.2f}\n", columns * rows,
                 fmt::format("1/{}", rate), one, two, one / two);
    }
  }
  fmt::print(
      "\na worker for each of n balls: milliseconds per frame of 1/30 s, 8 steps of 1/240 s\n");
  for (const std::size_t rows : {1, 10, 40}) {
    Scene scene = carom::test::walled_gas(25, rows, 0.30);
    scene.workers.reset();
    scene.per_ball = true;
    carom::Simulation simulation(scene);
    fmt::print("{:>8} {:>10.2f}\n", 25 * rows, median_seconds(simulation, 10.0 / 30) / 10 * 1e3);
  }
}
