#include <algorithm>
#include <cmath>

#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

/// `strikers` balls that touch run at speed 1 into a row of touching balls at rest, n in all.
Scene cradle(const Scene& scene, int n, int strikers) {
  std::vector<Ball> balls;
  for (int i = 0; i < n; ++i) {
    balls.push_back(i < strikers ? ball(3 + i, 2, 1, 0) : ball(6 + i, 2, 0, 0));
  }
  return with_balls(scene, balls);
}

constexpr double kCradleEnd = 8;  // the strikers have arrived, those that leave are on their way

template <class Measure>
double worst_cradle(const Trial& trial, Measure measure) {
  double worst = 0;
  for (int n = 2; n <= 7; ++n) {
    for (int strikers = 1; strikers < n; ++strikers) {
      const Scene scene = cradle(trial.scene, n, strikers);
      worst = std::max(worst, measure(scene, n, strikers));
    }
  }
  return worst;
}

double cradle_speeds(const Trial& trial) {
  return worst_cradle(trial, [](const Scene& scene, int n, int strikers) {
    const Outcome outcome = run(scene, kCradleEnd);
    double worst = 0;
    for (int i = 0; i < n; ++i) {
      const Vec2 expected{i < n - strikers ? 0.0 : 1.0, 0};
      const Vec2& found = outcome.balls[static_cast<std::size_t>(i)].velocity;
      worst = std::max(worst, (found - expected).norm());
    }
    return worst;
  });
}

double cradle_growth(const Trial& trial) {
  return worst_cradle(trial, [](const Scene& scene, int, int) {
    Simulation simulation(scene);
    const double first = simulation.measure().energy_final;
    double least = first;
    double growth = 0;
    for (double time = 0; time < kCradleEnd; time += scene.solver.step) {
      simulation.advance_to(time);
      const double energy = simulation.measure().energy_final;
      growth = std::max(growth, (energy - least) / first);
      least = std::min(least, energy);
    }
    return growth;
  });
}

double cradle_momentum(const Trial& trial) {
  return worst_cradle(trial, [](const Scene& scene, int, int) {
    return momentum_error(scene, run(scene, kCradleEnd));
  });
}

/// How many balls are not where the mirror image (y to -y) of the rack has them.
double rack_mirror(const Trial& trial) {
  Simulation simulation(trial.scene);
  const std::vector<Ball> start = simulation.state();
  double worst = 0;
  for (double time = 0; time <= trial.scene.duration; time += 0.25) {
    simulation.advance_to(time);
    const std::vector<Ball> balls = simulation.state();
    std::vector<Ball> mirrored = balls;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t j = 0; j < balls.size(); ++j) {
        if (start[i].position.x() != start[j].position.x()) continue;
        if (start[i].position.y() != -start[j].position.y()) continue;
        mirrored[i] = balls[j];
        mirrored[i].position.y() *= -1;
        mirrored[i].velocity.y() *= -1;
      }
    }
    worst = std::max(worst, different(balls, mirrored));
  }
  return worst;
}

double rack_energy(const Trial& trial) {
  return energy_error(run(trial.scene, trial.scene.duration).measured);
}

/// Runs for two seconds: how far the balls are from where they were, and from these velocities.
double off_the_way_back(const Scene& scene, const std::vector<Vec2>& velocities) {
  const Outcome back = run(scene, 2);
  double worst = farthest(back.balls, scene.balls);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    worst = std::max(worst, (back.balls[i].velocity - velocities[i]).norm());
  }
  return worst;
}

template <class Measure>
double worst_corner(Measure measure) {
  double worst = 0;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) worst = std::max(worst, measure(x, y));
  }
  return worst;
}

/// A ball runs into each corner of the box along every direction of a fan, hits both walls at once
/// and has to come back the way it went.
double corner_way_back(const Trial& trial) {
  const double inner = trial.scene.box.width / 2 - 0.5;
  return worst_corner([&](double x, double y) {
    double worst = 0;
    for (const double slope : {0.25, 0.5, 1.0, 2.0, 3.0}) {
      // From a place whose way to the corner takes exactly one second on both axes.
      const Vec2 v{x, y * slope};
      const Ball start = ball(x * inner - v.x(), y * inner - v.y(), v.x(), v.y());
      worst = std::max(worst, off_the_way_back(with_balls(trial.scene, {start}), {-v}));
    }
    return worst;
  });
}

/// The same into a ball in the corner: at one instant it is hit head-on, bounces off both walls and
/// is stopped by the ball that hit it.  A line of centres along (3, 4) is exact.
double corner_ball_way_back(const Trial& trial) {
  constexpr double kRadius = 5.0 / 16;
  const double inner = trial.scene.box.width / 2 - kRadius;
  return worst_corner([&](double x, double y) {
    const Vec2 touching{x * 0.375, y * 0.5};
    const Vec2 v = 2 * touching;
    const Vec2 start = Vec2{x * inner, y * inner} - touching - v;
    return off_the_way_back(
        with_balls(trial.scene, {ball(start.x(), start.y(), v.x(), v.y(), kRadius),
                                 ball(x * inner, y * inner, 0, 0, kRadius)}),
        {-v, {0, 0}});
  });
}

/// A ball as tall as its box.
double tight_glide(const Trial& trial) {
  const Ball start = trial.scene.balls.front();
  double worst = 0;
  Simulation simulation(trial.scene);
  for (double time = 0; time <= trial.scene.duration; time += 0.5) {
    simulation.advance_to(time);
    const Ball now = simulation.state()[0];
    worst = std::max(worst, std::abs(now.position.y() - start.position.y()));
    worst = std::max(worst, std::abs(now.velocity.y()));
    worst = std::max(worst, std::abs(std::abs(now.velocity.x()) - std::abs(start.velocity.x())));
  }
  return worst;
}

/// Two balls hit a third at once: how far they are from each other's mirror image.
double three_way_mirror(const Trial& trial) {
  double worst = 0;
  for (const double height : {0.0, 0.25, 0.5, 0.75, 0.9}) {
    const double x = 4;
    const Scene scene =
        with_balls(trial.scene, {ball(-x, height, 1, 0), ball(x, height, -1, 0), ball(0, 0, 0, 0)});
    const Outcome outcome = run(scene, 6);
    const Ball& left = outcome.balls[0];
    const Ball& right = outcome.balls[1];
    worst = std::max({worst, std::abs(left.position.x() + right.position.x()),
                      std::abs(left.position.y() - right.position.y()),
                      std::abs(left.velocity.x() + right.velocity.x()),
                      std::abs(left.velocity.y() - right.velocity.y()),
                      std::abs(outcome.balls[2].position.x()),
                      std::abs(outcome.balls[2].velocity.x())});
  }
  return worst;
}

}  // namespace

std::vector<Case> simultaneous_cases() {
  return {
      {"cradle",
       {{Method::event, "speeds after the impact, off by", 1e-12, cradle_speeds},
        {Method::event, "momentum, relative", 1e-12, cradle_momentum},
        {Method::overlap, "energy gained, relative", 1e-13, cradle_growth},
        {Method::overlap, "momentum, relative", 1e-12, cradle_momentum}}},
      {"rack",
       {{Method::event, "balls not mirrored to the last bit", 0, rack_mirror},
        {Method::event, "energy, relative", 1e-13, rack_energy}}},
      {"corner",
       {{Method::event, "off the way back by", 0, corner_way_back},
        {Method::event, "off it, a ball in the corner, by", 0, corner_ball_way_back}}},
      {"tight", {{Method::event, "off the glide by", 0, tight_glide}}},
      {"three-way", {{Method::event, "off the mirror image by", 0, three_way_mirror}}},
  };
}

}  // namespace carom::hard
