#include "contact/island_slips.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace carom::contact::island_slips_test {
namespace {

constexpr double kSticks = 0.25;

// A ball on a floor that rubs with a coefficient of 1/2; without impulses it goes by 8 to the
// right.
struct Sliding {
  std::vector<IslandBody> bodies{1};
  std::vector<IslandContact> contacts{{0, -1, {0, -1}, 0, 0.5, 0}};
  ContactProblem<3> problem;
  std::vector<double> slips{0};

  explicit Sliding(double slip) : slips{slip} {
    bodies[0].inverse_mass = 1;
    bodies[0].free = {8, 0};
    problem.rows.resize(2);
    for (Row<3>& row : problem.rows) row.q = 0.5 * slip;
  }
  SlipRevision revision() { return {bodies, contacts, kSticks, problem, slips}; }
  void expect_slip(double slip) const {
    EXPECT_EQ(slips[0], slip);
    for (const Row<3>& row : problem.rows) EXPECT_EQ(row.q, 0.5 * slip);
  }
};

// What the impulses do to the ball so that it slips by this.
std::vector<double> motion(double slip) {
  return {slip - 8, 0, 0};
}

TEST(IslandSlips, SlowerThanSticksIsNotSlidingAndFasterByWhatIsLeft) {
  const IslandContact contact{0, -1, {0, -1}, 0, 0.5, 0};
  EXPECT_EQ(sliding(contact, {{0.25, 3}, 0}, {}, 0.25), 0);
  EXPECT_EQ(sliding(contact, {{-1, 3}, 0}, {}, 0.25), 0.75);
  EXPECT_EQ(sliding(contact, {{1, 0}, -1}, {}, 0.25), 0);  // it rolls
}

TEST(IslandSlips, RowsOpenByTheCoefficientTimesTheSlip) {
  Sliding scene(0);
  auto revision = scene.revision();
  EXPECT_FALSE(revision.any());
  revision(motion(4), 1);
  scene.expect_slip(3.75);
  EXPECT_TRUE(revision.any());
  revision(motion(2), 1);
  scene.expect_slip(1.75);
}

TEST(IslandSlips, ASlipLessThanWhatIsMissedIsNotBelieved) {
  Sliding scene(0);
  auto revision = scene.revision();
  revision(motion(2), 8);
  scene.expect_slip(0);
}

// By no more than is missed: what is farther off is not on its way to the answer any more.
TEST(IslandSlips, NearTheEndASlipBecomesOnlyLess) {
  for (const auto& [slip, now, miss, wanted] :
       {std::array{2.0, 4.0, kSticks, 2.0}, std::array{2.0, 2.125, kSticks, 2.0},
        std::array{0.3, 0.375, kSticks, 0.125}, std::array{0.3, 0.375, kSticks / 2, 0.3}}) {
    Sliding scene(slip);
    scene.revision()(motion(now), miss);
    scene.expect_slip(wanted);
  }
}

// So many that no guess is made: thrown along the floor they slip, and do not lift by the
// coefficient times that.
TEST(IslandSlips, WhatIsThrownAlongAFloorStaysOnIt) {
  constexpr double kFriction = 0.5;
  const IslandStep::Rule rule{1.0 / 64, {0, -1}, 2.0 / 64, 1.0 / 64};
  std::vector<IslandBody> bodies(200);
  std::vector<IslandContact> contacts;
  for (int k = 0; k < 200; ++k) {
    IslandBody& body = bodies[static_cast<std::size_t>(k)];
    body.inverse_mass = 1;
    body.before = {k % 2 == 0 ? 1.0 : -2.0, 0};
    body.free = body.before + rule.step * rule.acceleration;
    body.free_mean = (body.before + body.free) / 2;
    contacts.push_back({k, -1, {0, -1}, 0, kFriction, 0.5});
  }
  IslandStep step;
  IslandOutcome outcome;
  step.take(bodies, contacts, true, rule, outcome);
  EXPECT_TRUE(outcome.solved);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const double slower = std::abs(bodies[k].before.x()) - std::abs(outcome.after[k].x());
    EXPECT_NEAR(slower, kFriction * rule.speed, 0.1 * kFriction * rule.speed);
    EXPECT_GE(outcome.after[k].y(), -1e-3 * rule.speed);
    EXPECT_LE(outcome.after[k].y(), 0.1 * rule.speed);
  }
}

}  // namespace
}  // namespace carom::contact::island_slips_test
