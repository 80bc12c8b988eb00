#include <algorithm>
#include <cmath>

#include "carom/scene_file.hpp"
#include "fill/random.hpp"
#include "verify/cases.hpp"
#include "verify/runs.hpp"
#include "verify/transform.hpp"

namespace carom::hard {

namespace {

double scaled_bits(const Trial& trial) {
  const Scene base = listed(trial.scene);
  const std::vector<Ball> expected = run(base, base.duration).balls;
  scene::Random random(trial.seed, 2);
  const auto power = [&random] {
    return std::ldexp(1.0, static_cast<int>(random.uniform() * 61) - 30);
  };
  double worst = 0;
  for (int k = 0; k < 8; ++k) {
    const double length = power();
    const double time = power();
    const double mass = power();
    const Scene scene = scaled(base, length, time, mass);
    const std::vector<Ball> found = run(scene, scene.duration).balls;
    worst = std::max(worst, different(found, scaled(expected, length, time, mass)));
  }
  return worst;
}

double mirrored_bits(const Trial& trial) {
  const Scene base = listed(trial.scene);
  const std::vector<Ball> expected = run(base, base.duration).balls;
  double worst = 0;
  for (const Mirror mirror : {Mirror::x, Mirror::y, Mirror::diagonal}) {
    const std::vector<Ball> found = run(mirrored(base, mirror), base.duration).balls;
    worst = std::max(worst, different(found, mirrored(expected, mirror)));
  }
  return worst;
}

double relabelled_bits(const Trial& trial) {
  Scene scene = listed(trial.scene);
  const std::vector<Ball> expected = run(scene, scene.duration).balls;
  const std::vector<Ball> start = scene.balls;
  double worst = 0;
  for (std::uint64_t k = 0; k < 4; ++k) {
    const Shuffle shuffle(start.size(), 4 * trial.seed + k);
    scene.balls = shuffle.there(start);
    worst = std::max(worst, different(shuffle.back(run(scene, scene.duration).balls), expected));
  }
  return worst;
}

double crew_bits(const Trial& trial) {
  Scene scene = listed(trial.scene);
  scene.workers = 1;
  // Where other programs have the cores each barrier waits for them.
  const double time = scene.duration / 4;
  const std::vector<Ball> expected = run(scene, time).balls;
  double worst = 0;
  for (const std::size_t workers : {2, 3, 7, 0}) {
    scene.per_ball = workers == 0;
    if (workers == 0) {
      scene.workers.reset();
    } else {
      scene.workers = workers;
    }
    worst = std::max(worst, different(run(scene, time).balls, expected));
  }
  return worst;
}

/// The scene four times again, each time otherwise: `rerun` gives the balls at the end.
template <class Rerun>
double worst_rerun(const Trial& trial, Scene scene, std::uint64_t stream, Rerun rerun) {
  scene.workers = 1;
  const std::vector<Ball> expected = run(scene, scene.duration).balls;
  scene::Random random(trial.seed, stream);
  double worst = 0;
  for (int k = 0; k < 4; ++k) worst = std::max(worst, different(rerun(scene, random), expected));
  return worst;
}

/// A ball that bounces on a fixed one until it falls off: its way does not tell by itself that it
/// began at a contact, and each bounce makes more of what is lost of it.
Scene hopping(const Scene& scene) {
  Ball fixed_disk = ball(4, 2, 0, 0, 1);
  fixed_disk.fixed = true;
  return with_balls(scene, {fixed_disk, ball(4.001, 3.3125, 0, 0, 0.25)});
}

double stopped_bits(const Trial& trial) {
  const auto stop_and_go_on = [](const Scene& scene, scene::Random& random) {
    Simulation first(scene);
    first.advance_to(random.uniform() * scene.duration);
    return run(parse_scene(write_scene(first.save()), "saved"), scene.duration).balls;
  };
  return std::max(worst_rerun(trial, listed(trial.scene), 3, stop_and_go_on),
                  worst_rerun(trial, hopping(trial.scene), 7, stop_and_go_on));
}

/// Looked at in frames of random lengths on the way, or only at the end.
double watched_bits(const Trial& trial) {
  return worst_rerun(trial, listed(trial.scene), 4, [](const Scene& scene, scene::Random& random) {
    Simulation simulation(scene);
    const double frame = scene.duration / (2 + 400 * random.uniform());
    for (double time = frame; time < scene.duration; time += frame) simulation.advance_to(time);
    simulation.advance_to(scene.duration);
    return simulation.state();
  });
}

constexpr auto kBits = "balls that differ in a bit";

}  // namespace

std::vector<Case> symmetry_cases() {
  return {
      {"scaled",
       {{Method::event, kBits, 0, scaled_bits}, {Method::overlap, kBits, 0, scaled_bits}}},
      {"mirrored",
       {{Method::event, "balls that differ in a bit, mirrored", 0, mirrored_bits},
        {Method::event, "balls that differ in a bit, shuffled", 0, relabelled_bits}}},
      {"order",
       {{Method::event, "differ in a bit by workers", 0, crew_bits},
        {Method::overlap, "differ in a bit by workers", 0, crew_bits},
        {Method::event, "differ in a bit by frames", 0, watched_bits},
        {Method::overlap, "differ in a bit by frames", 0, watched_bits},
        {Method::event, "differ in a bit, stopped", 0, stopped_bits},
        {Method::overlap, "differ in a bit, stopped", 0, stopped_bits}}},
  };
}

}  // namespace carom::hard
