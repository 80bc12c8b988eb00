// A ball that lies, rolls or slides while attraction has the paths integrated: what it falls by in
// a step and is lifted by at its end is no loss.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hard/energy_setting.hpp"

namespace carom::energy_rest_test {
namespace {

constexpr double kG = 9.81;

Scene pulled_box(double restitution, double friction) {
  Scene scene = box_of(Method::event, 40, 12);
  scene.effects.walls = Walls{restitution};
  scene.effects.collisions = Collisions{restitution};
  scene.effects.gravity = Gravity{{0, -kG}};
  scene.effects.attraction = Attraction{1e-9};
  if (friction > 0) scene.effects.friction = Friction{friction, friction};
  return scene;
}

Ball peg(double x, double y) {
  Ball peg = hard::ball(x, y, 0, 0);
  peg.fixed = true;
  return peg;
}

template <typename Check>
void for_all_contacts(const Check& check) {
  for (const double restitution : {0.0, 0.5}) {
    for (const double friction : {0.0, 0.3}) {
      SCOPED_TRACE("restitution " + std::to_string(restitution) + " friction " +
                   std::to_string(friction));
      for (const double time : {3.0, 30.0}) check(pulled_box(restitution, friction), time);
    }
  }
}

// Seen to fail: where the fall of each step is booked as lost, by a tenth in three seconds.
TEST(EnergyOfRest, ABallThatLiesOrRollsOnTheFloorLosesNothing) {
  for_all_contacts([](Scene scene, double time) {
    for (const double speed : {0.0, 1.0}) {
      Ball ball = hard::ball(2, 0.5, speed, 0, 0.5, 2);
      ball.spin = -2 * speed;
      scene.balls = {ball};
      const Measurements measured = after(scene, time);
      EXPECT_NEAR(measured.energy_dissipated, 0, 1e-12);
      expect_balanced(measured, 1e-12);
    }
  });
}

// Friction brings a slide without spin to a roll at 2/3 of its speed, which keeps 2/3 of its
// energy.
TEST(EnergyOfRest, ASlideLosesAThirdOfItsEnergyToFriction) {
  for_all_contacts([](Scene scene, double time) {
    scene.balls = {hard::ball(2, 0.5, 1, 0, 0.5, 2)};
    const Measurements measured = after(scene, time);
    EXPECT_NEAR(measured.energy_dissipated, scene.effects.friction ? 1.0 / 3 : 0, 1e-10);
    expect_balanced(measured, 1e-12);
  });
}

TEST(EnergyOfRest, ADropLosesAllOfItsFall) {
  for_all_contacts([](Scene scene, double time) {
    scene.balls = {hard::ball(2, 2.5, 0, 0, 0.5, 2)};
    const Measurements measured = after(scene, 2 + time);
    EXPECT_NEAR(measured.energy_dissipated, 2 * kG * 2, 1e-10);
    expect_balanced(measured, 1e-12);
  });
}

TEST(EnergyOfRest, ABallOnAFixedOneLosesNothing) {
  for_all_contacts([](Scene scene, double time) {
    scene.balls = {peg(4, 1), hard::ball(4, 2, 0, 0, 0.5, 2)};
    const Measurements measured = after(scene, time);
    EXPECT_NEAR(measured.energy_dissipated, 0, 1e-12);
    expect_balanced(measured, 1e-12);
  });
}

// Without friction it loses nothing before it lands on the floor.
TEST(EnergyOfRest, ABallThatSlidesOffAFixedOneKeepsItsEnergy) {
  for (const double restitution : {0.0, 0.5}) {
    Scene scene = pulled_box(restitution, 0);
    scene.balls = {peg(4, 3), hard::ball(4, 4, 0.3, 0, 0.5, 2)};
    const Measurements measured = after(scene, 0.75);
    EXPECT_NEAR(measured.energy_dissipated, 0, 1e-12);
    expect_balanced(measured, 1e-12);
  }
  for_all_contacts([](Scene scene, double time) {
    scene.balls = {peg(4, 1), hard::ball(4, 2, 0.3, 0, 0.5, 2)};
    expect_balanced(after(scene, time), 1e-12);
  });
}

TEST(EnergyOfRest, AStackLosesNothing) {
  for_all_contacts([](Scene scene, double time) {
    scene.balls = {hard::ball(4, 0.5, 0, 0, 0.5, 2), hard::ball(4, 1.5, 0, 0)};
    const Measurements measured = after(scene, time);
    EXPECT_NEAR(measured.energy_dissipated, 0, 1e-12);
    expect_balanced(measured, 1e-12);
  });
}

// In the cleft between two it may be lifted by too much in a step, never more and more.
TEST(EnergyOfRest, ABallInACleftLosesNothing) {
  for_all_contacts([](Scene scene, double time) {
    scene.balls = {peg(4, 1), peg(5.2, 1), hard::ball(4.6, 1.8, 0, 0, 0.5, 2)};
    const Measurements measured = after(scene, time);
    EXPECT_NEAR(measured.energy_dissipated, 0, 1e-3);
    expect_balanced(measured, 1e-4);
  });
}

}  // namespace
}  // namespace carom::energy_rest_test
