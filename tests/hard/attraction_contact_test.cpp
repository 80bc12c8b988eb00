// Balls that attraction presses together and that lose energy, by method overlap.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "carom/simulation.hpp"
#include "support/known_scene.hpp"
#include "support/scenes.hpp"
#include "support/transformed_scene.hpp"

namespace carom::attraction_contact_test {
namespace {

// Balls of two sizes, loose in a box with the origin at its centre, which gather to a clump.
Scene clump(double restitution, double step) {
  Scene scene;
  scene.box.width = 10;
  scene.box.height = 6;
  scene.box.origin = Box::Origin::center;
  scene.effects.walls = Walls{restitution};
  scene.effects.collisions = Collisions{restitution};
  scene.effects.attraction = Attraction{1, 0.25};
  scene.solver.method = Method::overlap;
  scene.solver.step = step;
  scene.workers = 1;
  std::mt19937_64 engine(11);
  const auto drawn = [&](double most) { return most * (2 * test::uniform(engine) - 1); };
  for (int column = 0; column < 8; ++column) {
    for (int row = 0; row < 4; ++row) {
      Ball ball;
      ball.position = {-4 + 1.125 * column + drawn(0.125), -2 + 1.25 * row + drawn(0.125)};
      ball.velocity = {drawn(1), drawn(1)};
      ball.radius = row % 2 == 0 ? 0.25 : 0.375;
      ball.mass = row % 2 == 0 ? 1 : 4;
      scene.balls.push_back(ball);
    }
  }
  return scene;
}

Measurements run(const Scene& scene, double time) {
  Simulation simulation(scene);
  simulation.advance_to(time);
  return simulation.measure();
}

TEST(AttractionContact, BallsOfAClumpDoNotOverlap) {
  for (const double restitution : {0.0, 0.5, 0.9}) {
    for (const bool rubs : {false, true}) {
      Scene scene = clump(restitution, 1.0 / 120);
      if (rubs) scene.effects.friction = Friction{0.3, 0.3};
      EXPECT_LT(run(scene, 6).max_overlap, 1e-3) << restitution << " " << rubs;
    }
  }
}

// The energy that is neither there nor lost is the error of velocity Verlet: second order.
TEST(AttractionContact, TheEnergyBookClosesToSecondOrderInTheStep) {
  const auto error = [](double step) {
    return std::abs(run(clump(0.5, step), 4).relative_energy_error());
  };
  const double rough = error(1.0 / 64);
  const double fine = error(1.0 / 256);
  EXPECT_LT(rough, 0.01);
  EXPECT_LT(fine, rough / 8);
}

// From rest at a distance d to the sum of radii s: what is lost is the difference of potential
// energies, strength m M (1 / sqrt(s^2 + a^2) - 1 / sqrt(d^2 + a^2)).
TEST(AttractionContact, TwoBallsThatStickLoseTheirPotentialEnergy) {
  for (const double restitution : {0.0, 0.3}) {
    Scene scene = clump(restitution, 1.0 / 512);
    scene.effects.walls.reset();
    scene.effects.attraction->softening = 0.5;
    scene.balls = {Ball{{-1.5, 0}, {0, 0}, 0.25, 2}, Ball{{1.5, 0}, {0, 0}, 0.5, 3}};
    Simulation simulation(scene);
    simulation.advance_to(20);
    const Measurements measured = simulation.measure();
    const double lost = 2 * 3 * (1 / std::hypot(0.75, 0.5) - 1 / std::hypot(3.0, 0.5));
    EXPECT_NEAR(measured.energy_dissipated, lost, 1e-4 * lost) << restitution;
    const std::vector<Ball> balls = simulation.state();
    EXPECT_NEAR((balls[1].position - balls[0].position).norm(), 0.75, 1e-6);
    for (const Ball& ball : balls) EXPECT_NEAR(ball.velocity.norm(), 0, 1e-4);
    EXPECT_LE(test::total_momentum(balls).norm(), 1e-13);
  }
}

TEST(AttractionContact, NoOrderUnitOrMirrorChangesABit) {
  for (const bool rubs : {false, true}) {
    Scene scene = clump(0.5, 1.0 / 128);
    if (rubs) scene.effects.friction = Friction{0.25, 0.25};
    const std::vector<Ball> balls = test::after(scene, 3);
    const test::Units units{0.25, 8, 2};
    const std::vector<Ball> scaled = test::after(test::in_units(scene, units), 3 * units.time);
    const test::Reordered other = test::reordered(scene, 7);
    const std::vector<Ball> mixed = test::after(other.scene, 3);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      EXPECT_EQ(scaled[i].position, units.length * balls[i].position);
      EXPECT_EQ(mixed[i].position, balls[other.number[i]].position);
    }
    for (const auto mirror : {hard::Mirror::x, hard::Mirror::y, hard::Mirror::diagonal}) {
      const auto there = test::after(test::in_mirror(scene, mirror), 3);
      const std::vector<Ball> back = hard::mirrored(there, mirror);
      for (std::size_t i = 0; i < balls.size(); ++i) {
        EXPECT_EQ(back[i].position, balls[i].position);
      }
    }
  }
}

}  // namespace
}  // namespace carom::attraction_contact_test
