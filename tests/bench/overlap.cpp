// What a step of method overlap costs, of a gas of disks at packing 0.30 and temperature 1: by the
// clock on the wall and by that of the processor, which other programs on the machine disturb less.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <deque>
#include <string>
#include <vector>

#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace {

using carom::Scene;

struct Cost {
  double wall = 0;
  double processor = 0;  // of all threads together
};

Cost now() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(wall).count(),
          static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// One line of the table: a gas that is run on for a while, again and again.
class Line {
 public:
  Line(std::size_t columns, std::size_t rows, int rate, std::size_t workers, std::uint64_t steps)
      : simulation_(scene(columns, rows, rate, workers)),
        balls_(columns * rows),
        rate_(rate),
        seconds_(static_cast<double>(steps) / rate),
        steps_(static_cast<double>(steps)) {
    simulation_.advance_to(3);  // the lattice melts
  }

  void measure() {
    const Cost start = now();
    simulation_.advance_to(simulation_.time() + seconds_);
    const Cost end = now();
    wall_.push_back(end.wall - start.wall);
    processor_.push_back(end.processor - start.processor);
  }

  void print() const {
    const double ball_steps = steps_ * static_cast<double>(balls_);
    const double frame = steps_ / rate_ * 30;
    const bool per_ball = simulation_.workers() == balls_;
    fmt::print("{:>7} {:>7} {:>9} {:>10.1f} {:>10.1f} {:>12.3f} {:>10.3f}\n", balls_,
               fmt::format("1/{}", rate_),
               per_ball ? "per ball" : fmt::format("{}", simulation_.workers()),
               median(wall_) / ball_steps * 1e9, median(processor_) / ball_steps * 1e9,
               median(wall_) / frame * 1e3, median(processor_) / frame * 1e3);
  }

 private:
  static Scene scene(std::size_t columns, std::size_t rows, int rate, std::size_t workers) {
    Scene scene = carom::test::walled_gas(columns, rows, 0.30);
    scene.solver.step = 1.0 / rate;
    scene.workers = workers;
    return scene;
  }

  carom::Simulation simulation_;
  std::size_t balls_;
  int rate_;
  double seconds_;
  double steps_;
  std::vector<double> wall_;
  std::vector<double> processor_;
};

}  // namespace

int main() {
  constexpr int kRepeats = 9;
  std::deque<Line> lines;
  for (const int rate : {60, 240}) {
    for (const std::size_t workers : {1, 2}) {
      lines.emplace_back(25, 40, rate, workers, 2000);
      lines.emplace_back(100, 100, rate, workers, 200);
    }
    lines.emplace_back(25, 40, rate, 1000, 16);
  }
  // In turns: what disturbs the machine disturbs every line.
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    for (Line& line : lines) line.measure();
  }
  fmt::print("Medians of {} repeats; a frame is 1/30 s.\n", kRepeats);
  fmt::print("{:>7} {:>7} {:>9} {:>21} {:>23}\n", "", "", "", "ns per ball and step",
             "ms per frame");
  fmt::print("{:>7} {:>7} {:>9} {:>10} {:>10} {:>12} {:>10}\n", "balls", "step", "workers", "wall",
             "processor", "wall", "processor");
  for (const Line& line : lines) line.print();
}
