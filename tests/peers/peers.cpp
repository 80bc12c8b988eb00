// The same gas by carom and by two simulators of games: what each costs, what it loses.
//
//     carom_peers [SIMULATED SECONDS]
//
// 1,000 elastic disks at packing 0.30 between walls, speeds of temperature 1.  All are held against
// method event with more digits; the horizon is when a ball is first seen more than 1 % of a radius
// from where that has it, looked at 60 times a second.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "carom/simulation.hpp"
#include "peer.hpp"
#include "support/scenes.hpp"

namespace carom::peers {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLooks = 60;  // a second
constexpr int kRepeats = 3;
constexpr double kPacking = 0.30;
constexpr double kRadius = 0.5;
constexpr double kLost = 0.01;

double energy_of(const std::vector<Ball>& balls) {
  double energy = 0;
  for (const Ball& ball : balls) energy += ball.mass * ball.velocity.squaredNorm() / 2;
  return energy;
}

double deepest_of(const std::vector<Ball>& balls) {
  double nearest = 4 * kRadius * kRadius;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      nearest = std::min(nearest, (balls[i].position - balls[j].position).squaredNorm());
    }
  }
  return (2 * kRadius - std::sqrt(nearest)) / kRadius;
}

double distance_of(const std::vector<Ball>& one, const std::vector<Ball>& other) {
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    largest = std::max(largest, (one[i].position - other[i].position).norm());
  }
  return largest;
}

/// A run under way: what moves it on to a look, and what there is to see.
struct Run {
  std::function<void(int look)> to_look;
  std::function<std::vector<Ball>()> state;
  /// The deepest overlap it has itself seen, in parts of a radius: steps may have parted the balls
  /// again before anybody looks.
  std::function<double()> seen = [] { return 0.0; };
};

struct Contender {
  std::string name;
  std::function<Run()> start;
};

Contender contender(const Scene& scene, const Entrant& entrant) {
  const auto start = [scene, entrant] {
    const std::shared_ptr<Peer> peer = entrant.make(scene, entrant.step);
    const int steps = static_cast<int>(std::lround(1 / (kLooks * entrant.step)));
    return Run{[peer, steps](int) {
                 for (int i = 0; i < steps; ++i) peer->step();
               },
               [peer] { return peer->state(); }};
  };
  return {fmt::format("{}, 1/{:.0f} s", entrant.name, 1 / entrant.step), start};
}

Contender contender(Scene scene, Method method, double step, int digits) {
  scene.solver.method = method;
  scene.solver.step = step;
  scene.solver.digits = digits;
  const auto start = [scene] {
    const auto simulation = std::make_shared<Simulation>(scene);
    return Run{[simulation](int look) { simulation->advance_to(look / kLooks); },
               [simulation] { return simulation->state(); },
               [simulation] { return simulation->measure().max_overlap; }};
  };
  return {method == Method::event ? fmt::format("carom event, {} digits", digits)
                                  : fmt::format("carom overlap, 1/{:.0f} s", 1 / step),
          start};
}

void compare(const Contender& contender, const std::vector<std::vector<Ball>>& truth) {
  const int looks = static_cast<int>(truth.size()) - 1;
  std::vector<double> seconds;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const Run run = contender.start();
    const auto started = Clock::now();
    for (int look = 1; look <= looks; ++look) run.to_look(look);
    seconds.push_back(std::chrono::duration<double>(Clock::now() - started).count());
  }
  std::sort(seconds.begin(), seconds.end());

  const Run run = contender.start();
  double deepest = 0;
  double horizon = 0;
  for (int look = 1; look <= looks; ++look) {
    run.to_look(look);
    const std::vector<Ball> balls = run.state();
    deepest = std::max(deepest, deepest_of(balls));
    const double apart = distance_of(balls, truth[static_cast<std::size_t>(look)]);
    if (horizon == 0 && apart > kLost * kRadius) horizon = look / kLooks;
  }
  deepest = std::max(deepest, run.seen());
  const double first = energy_of(truth.front());
  const double time = looks / kLooks;
  fmt::print("{:<34} {:>9.2f} ms {:>10.1e} {:>9.1e}  {}\n", contender.name,
             seconds[kRepeats / 2] / time * 1e3, (energy_of(run.state()) - first) / first, deepest,
             horizon == 0 ? "to the end" : fmt::format("{:.2f} s", horizon));
}

int main_of(double time) {
  Scene scene = test::walled_gas(40, 25, kPacking);
  const int looks = std::max(1, static_cast<int>(time * kLooks));
  fmt::print("{} disks, packing {}, {:.2f} s simulated\n\n", scene.balls.size(), kPacking,
             looks / kLooks);
  fmt::print("{:<34} {:>12} {:>10} {:>9}  {}\n", "", "time per s", "energy", "overlap", "horizon");

  std::vector<std::vector<Ball>> truth{scene.balls};
  const Run exact = contender(scene, Method::event, 1.0 / 240, 34).start();
  for (int look = 1; look <= looks; ++look) {
    exact.to_look(look);
    truth.push_back(exact.state());
  }
  std::vector<Contender> all;
  for (const auto& entrants : {box2d_entrants(), chipmunk_entrants()}) {
    for (const Entrant& entrant : entrants) all.push_back(contender(scene, entrant));
  }
  for (const double parts : {60.0, 240.0, 960.0, 7680.0}) {
    all.push_back(contender(scene, Method::overlap, 1 / parts, 16));
  }
  all.push_back(contender(scene, Method::event, 1.0 / 240, 16));
  for (const Contender& each : all) compare(each, truth);
  return 0;
}

}  // namespace
}  // namespace carom::peers

int main(int argc, char** argv) {
  return carom::peers::main_of(argc > 1 ? std::atof(argv[1]) : 10);
}
