#include "solvers/event/islands/stepped_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/contact_graph.hpp"
#include "solvers/event/support.hpp"

namespace carom::event::stepped_energy_test {
namespace {

constexpr Vec<double> kPull{0, -2};

IslandMotion of_two(unsigned first, unsigned second) {
  IslandMotion island;
  island.support = {first, second};
  island.bodies = {{{3, 1}, 2, 0.5}, {{0, 2}, 0, 1}};  // masses 2 and 1
  return island;
}

SteppedEnergy energy(bool keeps) {
  return SteppedEnergy({kPull, keeps, 0x1p-31, 0x1p-20});
}

// m v^2 + m (r w)^2 / 2 of disks, and h m g v of what is stepped: twice what it gets in half of h.
TEST(SteppedEnergy, IsWhatMovesLessWhatGravityHasGivenAhead) {
  const auto parts = energy(false).of(of_two(kStepped, 0), {0.5});
  EXPECT_EQ(parts.stepped, 2 * 10 + 2 * 4 / 2);
  EXPECT_EQ(parts.others, 4);
  EXPECT_EQ(parts.ahead, 2 * 0.25 * 2 * (-2 * 1));
  EXPECT_EQ(parts.all(), 24 + 2 + 4);
}

TEST(SteppedEnergy, IsLostButForWhatWasLifted) {
  IslandMotion island = of_two(kStepped, 0);
  EXPECT_EQ(energy(false).loss(island, 40, {0.5}), 5);
  island.lifted = 2;
  EXPECT_EQ(energy(false).loss(island, 40, {0.5}), 3);
}

// Random islands that have too much or too little: afterwards what is stepped has no more than
// there was; where energy is kept, all have just that, by one factor.
TEST(SteppedEnergy, IsKept) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  int slower = 0;
  int faster = 0;
  for (int round = 0; round < 300; ++round) {
    IslandMotion island;
    for (int k = 0; k < 4; ++k) {
      island.bodies.push_back({{normal(random), normal(random)}, normal(random), 1});
      island.support.push_back(k < 3 ? kStepped : 0);
    }
    // Walls far away: nothing has a drift of its own.
    island.contacts = {{0, kWall, {1, 0}, 1e9, 0}, {0, kWall, {0, 1}, 1e9, 0}};
    for (const bool keeps : {false, true}) {
      const SteppedEnergy rule = energy(keeps);
      IslandMotion kept = island;
      const double now = rule.of(island, {0.01}).all();
      // Not less than what the others have, which are not slowed down.
      const double had = rule.of(island, {0.01}).others + now * (0.1 + std::abs(normal(random)));
      const bool changed = rule.keep(kept, had, {0.01}, false);
      const double after = rule.of(kept, {0.01}).all();
      if (!keeps) {
        EXPECT_EQ(changed, now > had);
        EXPECT_LE(after, had * (1 + 1e-14));
        EXPECT_EQ(kept.bodies[3].velocity.x, island.bodies[3].velocity.x);
      } else {
        EXPECT_NEAR(after, had, 1e-13 * had);
      }
      if (!changed) continue;
      EXPECT_NEAR(after, had, 1e-13 * had);
      const double factor = kept.bodies[0].velocity.x / island.bodies[0].velocity.x;
      EXPECT_NEAR(kept.bodies[1].turning, factor * island.bodies[1].turning, 1e-13);
      ++(factor < 1 ? slower : faster);
    }
  }
  EXPECT_GT(slower, 50);
  EXPECT_GT(faster, 50);
}

// On a floor of ice: what balls have in common along it stays, and what each has beside that gets
// less; where there is less energy than that takes, all do.
TEST(SteppedEnergy, IsKeptBesideADriftAlongIce) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto drift = [](const IslandMotion& island) {
    return (island.bodies[0].velocity.x + 2 * island.bodies[1].velocity.x) / 3;
  };
  for (int round = 0; round < 100; ++round) {
    IslandMotion island = of_two(kStepped, kStepped);
    island.bodies = {{{normal(random), normal(random)}, 0, 1},
                     {{normal(random), normal(random)}, 0, 0.5}};
    island.contacts = {{0, kWall, {0, -1}, 0, 0}, {0, 1, {0.6, 0.8}, 0, 0}};
    const SteppedEnergy rule({kPull, false, 0x1p-31, 0x1p-20, true});
    const double u = drift(island);
    IslandMotion kept = island;
    EXPECT_TRUE(rule.keep(kept, 3 * u * u + 0.01, {0.01}, false) ||
                rule.of(island, {0.01}).all() < 3 * u * u + 0.01);
    EXPECT_NEAR(drift(kept), u, 1e-14);
    EXPECT_LE(rule.of(kept, {0.01}).all(), 3 * u * u + 0.01 + 1e-13);
    kept = island;
    EXPECT_TRUE(rule.keep(kept, 2 * u * u, {0.01}, false));
    EXPECT_LT(std::abs(drift(kept)), std::abs(u));
    EXPECT_NEAR(rule.of(kept, {0.01}).all(), 2 * u * u, 1e-13);
  }
}

// On a slope of 30 degrees, under a pull of 2, a ball gets a h / 2 = h / 2 in the first half of its
// flight, and in the middle of that is a h^2 / 8 above where it would be on its straight way:
// m a a h^2 / 8, of a mass of 2.
TEST(SteppedEnergy, LeavesOutWhatABentPathHasInItsMiddle) {
  const double h = 0.5;
  const Vec<double> slope{std::sqrt(0.75), -0.5};
  for (const double owed : {0.0, h / 2}) {
    IslandMotion island = of_two(kStepped, 0);
    island.left_out = {7, 7};
    island.gravity = {{owed, 0}, {0, 0}};
    const std::vector<ConeBody> before = island.bodies;
    for (ConeBody& body : island.bodies) body.velocity = body.velocity + (owed + h / 2) * slope;
    energy(true).leave_out(island, before, {h});
    EXPECT_NEAR(island.left_out[0], 2 * h * h / 8, 1e-15) << owed;
    EXPECT_EQ(island.left_out[1], 0);
  }
}

// From rest down that slope, h later: nothing has to change so that the energy is kept.
TEST(SteppedEnergy, IsKeptByWhatBeginsToSlide) {
  const double h = 0.5;
  IslandMotion island;
  island.support = {kStepped};
  island.bodies = {{{0, 0}, 0, 0.5}};
  island.left_out = {0};
  island.gravity = {{0, 0}};
  const std::vector<ConeBody> before = island.bodies;
  const Vec<double> half = (h / 2) * Vec<double>{std::sqrt(0.75), -0.5};
  island.bodies[0].velocity = half;
  energy(true).leave_out(island, before, {h});
  energy(true).keep(island, 0, {h}, false);
  EXPECT_NEAR(energy(true).loss(island, 0, {h}), 0, 1e-16);
  EXPECT_NEAR(island.bodies[0].velocity.x, half.x, 1e-7);
  EXPECT_NEAR(island.bodies[0].velocity.y, half.y, 1e-7);
}

// Masses 2 and 1; what leaves the island takes nothing along.
TEST(SteppedEnergy, StaysWithBallsThatHaveNoWayToGo) {
  IslandMotion island = of_two(kStepped, kStepped);
  island.left_out = {0.5, 0};
  EXPECT_NEAR(energy(true).hold(island, 3), 0, 1e-15);
  EXPECT_NEAR(island.left_out[0], 2.5, 1e-15);
  EXPECT_NEAR(island.left_out[1], 1, 1e-15);
  island.support = {0, kResting};
  island.left_out = {0, 0};
  EXPECT_NEAR(energy(true).hold(island, 3), 0, 1e-15);
  EXPECT_EQ(island.support[1], kStepped);
  EXPECT_EQ(island.left_out[1], 3);
  island.support = {0, 0};
  EXPECT_EQ(energy(true).hold(island, 3), 3);
}

TEST(SteppedEnergy, MayBeLessWhereTheIslandGivesUp) {
  IslandMotion island = of_two(kStepped, kStepped);
  const double now = energy(true).of(island, {}).all();
  EXPECT_FALSE(energy(true).keep(island, 2 * now, {}, true));
  EXPECT_TRUE(energy(true).keep(island, now / 2, {}, true));
  EXPECT_NEAR(energy(true).of(island, {}).all(), now / 2, 1e-14);
}

// Two that come to rest may lose what they had at that speed: v^2 (m1 + m2).
TEST(SteppedEnergy, IsHeldWhereMoreIsLostThanRestingBallsHave) {
  const IslandMotion island = of_two(kStepped, kStepped);
  const double most = 0x1p-40 * 3;
  EXPECT_FALSE(energy(true).is_held(island, most));
  EXPECT_TRUE(energy(true).is_held(island, most * 1.01));
  EXPECT_TRUE(energy(true).is_held(island, -most * 1.01));
  EXPECT_FALSE(energy(false).is_held(island, 1));
}

}  // namespace
}  // namespace carom::event::stepped_energy_test
