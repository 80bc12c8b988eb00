#include <algorithm>
#include <cmath>

#include "fill/random.hpp"
#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

double normal_pull(const Scene& scene) {
  return -scene.effects.gravity->acceleration.y();
}

/// Thrown flat, a disk slides until v = 2/3 v0 and rolls then; with drag, v0 exp(-2 k t / 3).
double rolling_speed(const Trial& trial) {
  Scene scene = trial.scene;
  const double v0 = scene.balls[0].velocity.x();
  const Ball free = run(scene, scene.duration).balls[0];
  double worst = std::abs(free.velocity.x() - 2 * v0 / 3);
  worst = std::max(worst, std::abs(free.velocity.x() + free.radius * free.spin));
  scene.effects.drag = Drag{0.25};
  scene.balls[0].spin = -v0 / scene.balls[0].radius;
  const Ball slowed = run(scene, scene.duration).balls[0];
  const double left = v0 * std::exp(-2 * 0.25 * scene.duration / 3);
  return std::max(worst, std::abs(slowed.velocity.x() - left)) / v0;
}

/// What is pulled moves: a stack of two on ice, tilted by 1e-4 and 1e-6, slides by g t^2 / 2.
double tilt_way(const Trial& trial) {
  double worst = 0;
  for (const double tilt : {1e-4, 1e-6}) {
    Scene scene = trial.scene;
    const double pull = tilt * normal_pull(scene);
    scene.effects.gravity->acceleration.x() = pull;
    const double time = scene.duration;
    const Outcome end = run(scene, time);
    for (std::size_t k = 0; k < end.balls.size(); ++k) {
      const double way = end.balls[k].position.x() - scene.balls[k].position.x();
      worst = std::max(worst, std::abs(way / (pull * time * time / 2) - 1));
    }
  }
  return worst;
}

/// Balls of diameter 1 on a square lattice, elastic, under any gravity: some touch, some are fixed.
Scene drawn_lattice(const Trial& trial, int number) {
  scene::Random random(trial.seed, 100U + static_cast<unsigned>(number));
  const auto below = [&random](int n) { return static_cast<int>(random.uniform() * n); };
  Scene scene = trial.scene;
  scene.balls.clear();
  const Vec2 pulls[] = {{0, -10}, {0, -1}, {2, -0.5}, {1, 0}, {0.5, -4}};
  scene.effects.gravity = Gravity{pulls[below(5)]};
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 5; ++y) {
      if (below(2) == 0) continue;
      Ball each = ball(x + 0.5, y + 0.5, below(5) - 2, below(5) - 2);
      each.fixed = below(8) == 0;
      if (each.fixed) each.velocity = {0, 0};
      scene.balls.push_back(each);
    }
  }
  return scene;
}

template <class Measure>
double worst_lattice(const Trial& trial, Measure measure) {
  double worst = 0;
  for (int k = 0; k < 40; ++k) worst = std::max(worst, measure(drawn_lattice(trial, k)));
  return worst;
}

double lattice_energy(const Trial& trial) {
  return worst_lattice(trial, [](const Scene& scene) {
    const Measurements end = run(scene, scene.duration).measured;
    double moving = 0;
    for (const Ball& each : scene.balls) moving += each.mass * each.velocity.squaredNorm() / 2;
    const double scale = std::max({std::abs(end.energy_initial), moving, 1.0});
    if (end.jammed > 0) return 0.0;
    return std::abs(end.energy_final - end.energy_initial) / scale;
  });
}

double lattice_order(const Trial& trial) {
  return worst_lattice(trial, [](const Scene& scene) {
    Scene turned = scene;
    std::reverse(turned.balls.begin(), turned.balls.end());
    std::vector<Ball> end = run(turned, scene.duration).balls;
    std::reverse(end.begin(), end.end());
    return different(run(scene, scene.duration).balls, end);
  });
}

/// A box that is shaken 100 times a second.
double shaken_overlap(const Trial& trial) {
  Simulation simulation(trial.scene);
  double worst = 0;
  for (int k = 0; k < 200; ++k) {
    Effects effects;
    effects.gravity = Gravity{{std::sin(0.1 * k), trial.scene.effects.gravity->acceleration.y()}};
    simulation.apply(command::SetEffects{effects});
    simulation.advance_to(0.01 * (k + 1));
    worst = std::max(worst, simulation.measure().max_overlap);
  }
  return worst;
}

}  // namespace

std::vector<Case> event_contact_cases() {
  return {
      {"rolling", {{Method::event, "speed and spin, relative", 1e-12, rolling_speed}}},
      {"tilt", {{Method::event, "way of a stack, relative", 1e-7, tilt_way}}},
      {"lattice",
       {{Method::event, "energy, relative", 1e-12, lattice_energy},
        {Method::event, "balls that see their order", 0, lattice_order}}},
      {"shaken", {{Method::event, "overlap, in radii", 1e-5, shaken_overlap}}},
  };
}

}  // namespace carom::hard
