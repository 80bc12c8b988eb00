// What each effect costs: a gas of disks at packing 0.30 between walls, bare, with each effect
// added alone, and with all; nanoseconds of processor time per ball and step (overlap) and per
// impact (event), all in one run and in turns, and as ratios to the bare scene.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace {

using carom::Scene;

constexpr int kRepeats = 15;

double processor_seconds() {
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
  Line(const std::string& name, const Scene& scene, double seconds)
      : name_(name),
        simulation_(scene),
        event_(scene.solver.method == carom::Method::event),
        seconds_(seconds),
        ball_steps_(seconds / scene.solver.step * static_cast<double>(simulation_.balls())) {
    simulation_.advance_to(1);  // the lattice melts
  }

  void measure() {
    const auto before = simulation_.measure();
    const double start = processor_seconds();
    simulation_.advance_to(simulation_.time() + seconds_);
    const double spent = processor_seconds() - start;
    const auto after = simulation_.measure();
    const auto impacts = static_cast<double>(after.ball_ball + after.ball_wall - before.ball_ball -
                                             before.ball_wall);
    spent_.push_back(spent / (event_ ? impacts : ball_steps_) * 1e9);
  }

  [[nodiscard]] double nanoseconds() const { return median(spent_); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  carom::Simulation simulation_;
  bool event_;
  double seconds_;
  double ball_steps_;
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
    lines.emplace_back(addition.name, scene, method == carom::Method::event ? 2 : 0.5);
  }
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    for (Line& line : lines) line.measure();
  }
  const double bare = lines.front().nanoseconds();
  double parts = bare;
  fmt::print("{}\n", title);
  for (const Line& line : lines) {
    const bool whole = line.name() == "these three" || line.name() == "all";
    fmt::print("  {:<14}{:>10.2f}{:>9.3f}", line.name(), line.nanoseconds(),
               line.nanoseconds() / bare);
    if (whole) {
      fmt::print("   sum of the parts / the whole {:.3f}", parts / line.nanoseconds());
    } else {
      parts += line.nanoseconds() - bare;
    }
    fmt::print("\n");
  }
}

}  // namespace

int main() {
  fmt::print("Medians of {} repeats, one worker.\n", kRepeats);
  table("overlap, 1,000 balls: ns per ball and step, ratio", carom::Method::overlap, false);
  table("event, 1,000 balls: ns per impact, ratio", carom::Method::event, false);
  table("overlap, 100 balls, with attraction: ns per ball and step, ratio", carom::Method::overlap,
        true);
}
