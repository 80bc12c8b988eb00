#include "contact/island_energy.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::contact::island_energy_test {
namespace {

// A light ball under a heavy one.  Both fall together; beside that they move and fall relative to
// each other by what rounding leaves.
struct Falling {
  IslandStep::Rule rule{1.0 / 256, {0, -10}, 10.0 / 256, 1.0 / 256};
  std::vector<IslandBody> bodies{2};
  IslandOutcome outcome;

  explicit Falling(double rounding) {
    bodies[0].inverse_mass = 16;
    bodies[1].inverse_mass = 0.125;
    outcome.turning = {0, 0};
    for (IslandBody& body : bodies) {
      body.before = {0, -0.125};
      body.free = body.before + rule.step * rule.acceleration;
      body.free_mean = 0.5 * (body.before + body.free);
      outcome.after.push_back(body.free);
      outcome.mean.push_back(body.free_mean);
    }
    outcome.mean[0].y() -= rounding;  // so that the two come nearer to each other
    outcome.after[1].y() -= rounding;
  }
};

// The relative motion has less energy than the gain that rounding leaves: no part of it ends the
// gain.  The balls were moved by whole radii to look for one.
TEST(IslandEnergy, WhatFallsTogetherIsNotMovedToEndARounding) {
  for (const double rounding : {0x1p-38, 0x1p-40, 0x1p-42}) {
    Falling falling(rounding);
    ASSERT_GT(gain(falling.bodies, falling.rule, falling.outcome),
              rounding_of_gain(falling.bodies, falling.rule));
    end_gain(falling.bodies, falling.rule, {1, 1}, falling.outcome);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(falling.outcome.mean[i].y(), falling.bodies[i].free_mean.y(), 2 * rounding);
      EXPECT_NEAR(falling.outcome.after[i].y(), falling.bodies[i].free.y(), 2 * rounding);
    }
  }
}

}  // namespace
}  // namespace carom::contact::island_energy_test
