#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

constexpr double kUnit = 0x1p-53;

/// By how many the collisions with masses 1 and 100^k miss the digits of pi.
/// Source: G. Galperin, Playing pool with pi, Regul. Chaotic Dyn. 8 (2003) 375.
double pi_miscount(const Trial& trial) {
  double missed = 0;
  double mass = 1;
  const int most = trial.thorough ? 8 : 6;
  for (int k = 0; k <= most; ++k, mass *= 100) {
    const double count = std::ceil(std::numbers::pi / std::atan(std::sqrt(1 / mass))) - 1;
    const Outcome outcome =
        run(with_balls(trial.scene, {ball(4, 1, 0, 0), ball(8, 1, -1, 0, 0.5, mass)}), 50);
    const auto found = static_cast<double>(outcome.measured.ball_ball + outcome.measured.ball_wall);
    missed += std::abs(found - count);
  }
  return missed;
}

/// How far the numbers of hits of the bullet are from one at the ball and one at the wall.
double bullet_hits(const Trial& trial) {
  const double speed = trial.scene.balls[0].velocity.x();
  const Measurements at_ball = run(trial.scene, (58.0 + 50.0) / speed).measured;
  const Measurements at_wall = run(trial.scene, (58.0 + 59.0) / speed).measured;
  const auto off = [](std::uint64_t found, double wanted) {
    return std::abs(static_cast<double>(found) - wanted);
  };
  return off(at_ball.ball_ball, 1) + off(at_ball.ball_wall, 0) + off(at_wall.ball_ball, 1) +
         off(at_wall.ball_wall, 1);
}

/// How far a ball gets out of the box, in parts of its radius.
double bullet_outside(const Trial& trial) {
  Simulation simulation(trial.scene);
  double worst = 0;
  for (int frame = 0; frame <= 60; ++frame) {
    simulation.advance_to(frame / 30.0);
    for (const Ball& each : simulation.state()) {
      const Vec2 inner = trial.scene.box.size() - Vec2{each.radius, each.radius};
      const double out = std::max({each.radius - each.position.x(), each.radius - each.position.y(),
                                   each.position.x() - inner.x(), each.position.y() - inner.y()});
      worst = std::max(worst, out / each.radius);
    }
  }
  return worst;
}

/// A bullet crosses the place of a ball at rest once within one step.
double bullet_unreported(const Trial& trial) {
  Scene scene = trial.scene;
  scene.solver.step = 1.0 / 1024;
  scene.balls[0].velocity.x() = 90 / scene.solver.step;
  const Measurements measured = run(scene, scene.solver.step).measured;
  return std::abs(1 - static_cast<double>(measured.ball_ball + measured.missed_hits));
}

/// A ball flies past one at rest with an impact parameter of 1 -+ 10^-k contact distances.
template <class Measure>
double worst_graze(const Trial& trial, double side, Measure measure) {
  double worst = 0;
  for (int k = 1; k <= 15; ++k) {
    const double height = 1 - side * std::pow(10.0, -k);
    const Scene scene = with_balls(trial.scene, {ball(-8, height, 1, 0), ball(0, 0, 0, 0)});
    worst = std::max(worst, measure(run(scene, 16), 1 - height));
  }
  return worst;
}

double graze_hits(const Trial& trial) {
  const double hit = worst_graze(trial, 1, [](const Outcome& outcome, double) {
    return std::abs(static_cast<double>(outcome.measured.ball_ball) - 1);
  });
  const double miss = worst_graze(trial, -1, [](const Outcome& outcome, double) {
    return static_cast<double>(outcome.measured.ball_ball);
  });
  return hit + miss;
}

/// The one at rest leaves along the normal with the cosine of its angle, sqrt(d (2 - d)), d the
/// part of the contact distance by which it is hit.  In units of 16 u / d.
double graze_deflection(const Trial& trial) {
  return worst_graze(trial, 1, [](const Outcome& outcome, double d) {
    const double expected = std::sqrt(d * (2 - d));
    const double found = outcome.balls[1].velocity.norm();
    return std::abs(found - expected) / expected / (16 * kUnit / d);
  });
}

/// A ball flies a million diameters to one at rest, head-on or aside by `height` contact distances:
/// the time at which they touch, from how far the other one has gone since, in parts of the flight
/// and units of 4 u.
double far_contact(const Trial& trial) {
  constexpr double kAside = 0x99999p-20;  // 0.6; like the way it is a multiple of 2^-20
  double worst = 0;
  for (const double origin : {0.0, 0x1p30}) {
    for (const double way : {1e3, 1e6}) {
      for (const double height : {0.0, kAside}) {
        const double cosine = std::sqrt((1 - height) * (1 + height));  // of the line of centres
        const double time = way + 1;  // soon after, while the line of centres hardly matters
        const Ball hit = ball(origin + way + 1, origin, 0, 0);
        const Scene scene = with_balls(trial.scene, {ball(origin, origin + height, 1, 0), hit});
        const Outcome outcome = run(scene, time);
        const double gone = outcome.balls[1].position.x() - hit.position.x();
        const double contact = time - gone / (cosine * cosine);
        // What the places themselves are rounded to is no error of the time.
        const double rounded = height > 0 ? origin + way : origin;
        const double rounding = 4 * kUnit * rounded / (cosine * cosine);
        const double error = std::abs(contact - (way + 1 - cosine)) - rounding;
        worst = std::max(worst, error / way / (4 * kUnit));
      }
    }
  }
  return worst;
}

}  // namespace

std::vector<Case> timing_cases() {
  return {
      {"pi", {{Method::event, "collisions miscounted", 0, pi_miscount}}},
      {"bullet",
       {{Method::event, "hits too many or too few", 0, bullet_hits},
        {Method::overlap, "out of the box, in radii", 0, bullet_outside},
        {Method::overlap, "missed hits that are not reported", 0, bullet_unreported},
        {Method::overlap, "hits too many or too few", 0, bullet_hits, "it tunnels"}}},
      {"graze",
       {{Method::event, "hits too many or too few", 0, graze_hits},
        {Method::event, "deflection, in 16 u / distance", 1, graze_deflection}}},
      {"far", {{Method::event, "contact time, in 4 u", 1, far_contact}}},
  };
}

}  // namespace carom::hard
