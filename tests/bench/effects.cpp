// What each effect costs: a gas of disks at packing 0.30 between walls, bare, with each effect
// added alone, and with all; nanoseconds of processor time per ball and step (overlap) and per
// impact (event), all in one run and in turns, and as ratios to the bare scene of the same turn.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <deque>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace {

using carom::Scene;

constexpr int kRepeats = 21;
constexpr double kLeast = 0.015;  // seconds of processor time that are measured at once

// A worker's time is booked when it falls asleep, some 40 microseconds after its frame is done:
// without the pause up to 4 ms would be booked on what is measured next.
double processor_seconds() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Addition {
  std::string name;
  std::function<void(carom::Effects&)> add;
};

// Weak enough that the gas stays the gas that it is without them.
const std::vector<Addition> kAdditions{
    {"bare", [](carom::Effects&) {}},
    {"gravity",
     [](carom::Effects& e) {
       e.gravity = carom::Gravity{{0, -0.01}};
     }},
    {"drag", [](carom::Effects& e) { e.drag = carom::Drag{1e-4}; }},
    {"friction",
     [](carom::Effects& e) {
       e.friction = carom::Friction{0.01, 0.01};
     }},
    {"these three",
     [](carom::Effects& e) {
       for (std::size_t i = 1; i <= 3; ++i) kAdditions[i].add(e);
     }},
    {"attraction",
     [](carom::Effects& e) {
       e.attraction = carom::Attraction{1e-4, 1};
     }},
    {"all",
     [](carom::Effects& e) {
       for (std::size_t i = 1; i <= 3; ++i) kAdditions[i].add(e);
       e.attraction = carom::Attraction{1e-4, 1};
     }},
};

class Line {
 public:
  Line(std::string name, const Scene& scene)
      : name_(std::move(name)),
        simulation_(scene),
        event_(scene.solver.method == carom::Method::event),
        ball_steps_(static_cast<double>(simulation_.balls()) / scene.solver.step) {
    simulation_.advance_to(1);  // the lattice melts
    while (advance() < kLeast) seconds_ *= 2;
  }

  void measure() {
    const auto before = simulation_.measure();
    const double spent = advance();
    const auto after = simulation_.measure();
    const auto impacts = static_cast<double>(after.ball_ball + after.ball_wall - before.ball_ball -
                                             before.ball_wall);
    spent_.push_back(spent / (event_ ? impacts : ball_steps_ * seconds_) * 1e9);
  }

  [[nodiscard]] double nanoseconds() const { return median(spent_); }
  /// The median of the turns' ratios: what slows the machine down slows both.
  [[nodiscard]] double ratio(const Line& bare) const {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < spent_.size(); ++k) ratios.push_back(spent_[k] / bare.spent_[k]);
    return median(ratios);
  }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  double advance() {
    const double start = processor_seconds();
    simulation_.advance_to(simulation_.time() + seconds_);
    return processor_seconds() - start;
  }

  std::string name_;
  carom::Simulation simulation_;
  bool event_;
  double seconds_ = 0.25;
  double ball_steps_;  ///< a second
  std::vector<double> spent_;
};

void table(const char* title, carom::Method method, bool attraction) {
  std::deque<Line> lines;
  for (const Addition& addition : kAdditions) {
    Scene scene = carom::test::walled_gas(attraction ? 10 : 25, attraction ? 10 : 40, 0.30);
    scene.solver.method = method;
    addition.add(scene.effects);
    if (scene.effects.attraction.has_value() && !attraction) continue;
    if (!carom::find_problems(scene).empty()) continue;  // the method does not take it
    lines.emplace_back(addition.name, scene);
  }
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    for (Line& line : lines) line.measure();
  }
  double parts = 1;
  fmt::print("{}\n", title);
  for (const Line& line : lines) {
    const bool whole = line.name() == "these three" || line.name() == "all";
    const double ratio = line.ratio(lines.front());
    fmt::print("  {:<14}{:>10.2f}{:>9.3f}", line.name(), line.nanoseconds(), ratio);
    if (whole) {
      fmt::print("   sum of the parts / the whole {:.3f}", parts / ratio);
    } else {
      parts += ratio - 1;
    }
    fmt::print("\n");
  }
  std::fflush(stdout);
}

}  // namespace

int main() {
  fmt::print("Medians of {} repeats, one worker.\n", kRepeats);
  table("overlap, 1,000 balls: ns per ball and step, ratio", carom::Method::overlap, false);
  table("event, 1,000 balls: ns per impact, ratio", carom::Method::event, false);
  table("overlap, 100 balls, with attraction: ns per ball and step, ratio", carom::Method::overlap,
        true);
}
