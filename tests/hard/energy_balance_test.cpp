// The energy book balances with every set of effects, in piles, in simultaneous impacts and over
// commands and saved runs: what is left over is rounding where flights are exact, and the error of
// the step elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "carom/session.hpp"
#include "hard/energy_setting.hpp"
#include "support/scenes.hpp"

namespace carom::energy_balance_test {
namespace {

// What the steps of contacts that last leave unsolved, where method event has them.
constexpr double kIslands = 1e-4;

struct Lossy {
  const char* name;
  Effects effects;
  double event;    // limits of what may be left over
  double overlap;  // of the size of a step
};

Lossy lossy(const char* name, double event, double overlap) {
  Lossy result{name, {}, event, overlap};
  result.effects.walls = Walls{0.7};
  result.effects.collisions = Collisions{0.8};
  return result;
}

std::vector<Lossy> lossy_gases() {
  std::vector<Lossy> all{lossy("inelastic", 1e-13, 1e-13)};
  all.push_back(lossy("friction", 1e-13, 1e-13));
  all.back().effects.friction = Friction{0.3, 0.4};
  all.push_back(lossy("drag", 1e-13, 1e-13));
  all.back().effects.drag = Drag{0.2};
  all.push_back(lossy("falling", kIslands, 1e-3));
  all.back().effects.gravity = Gravity{{0, -9.81}};
  all.push_back(lossy("falling with friction", kIslands, 1e-3));
  all.back().effects.gravity = Gravity{{2, -9.81}};
  all.back().effects.friction = Friction{0.3, 0.4};
  all.push_back(lossy("falling in drag with friction", kIslands, 1e-3));
  all.back().effects.gravity = Gravity{{0, -9.81}};
  all.back().effects.drag = Drag{0.2};
  all.back().effects.friction = Friction{0.3, 0.4};
  all.push_back(lossy("attraction", 1e-5, 5e-2));
  all.back().effects.attraction = Attraction{0.5, 0.2};
  all.push_back(lossy("all", 1e-5, 5e-2));
  all.back().effects.gravity = Gravity{{0, -2}};
  all.back().effects.drag = Drag{0.2};
  all.back().effects.friction = Friction{0.3, 0.4};
  all.back().effects.attraction = Attraction{0.5, 0.2};
  return all;
}

Scene lossy_gas(const Lossy& lossy, Method method) {
  Scene scene = test::walled_gas(5, 4, 0.3, 3);
  scene.effects = lossy.effects;
  scene.solver.method = method;
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    Ball& ball = scene.balls[i];
    ball.velocity *= 3;
    ball.mass = 1 + 0.1 * static_cast<double>(i);
    if (lossy.effects.friction) ball.spin = 0.3 * static_cast<double>(i) - 2;
  }
  return scene;
}

TEST(EnergyBalance, OfLossyGasesWithEverySetOfEffects) {
  for (const Method method : kMethods) {
    for (const Lossy& lossy : lossy_gases()) {
      SCOPED_TRACE(std::string(method_name(method)) + ", " + lossy.name);
      const Measurements measured = after(lossy_gas(lossy, method), 1.5);
      EXPECT_GT(measured.energy_dissipated, 0.05 * measured.energy_initial);
      expect_balanced(measured, method == Method::event ? lossy.event : lossy.overlap);
    }
  }
}

// Piles: contact groups, islands and coming to rest.
TEST(EnergyBalance, OfPiles) {
  for (const Method method : kMethods) {
    for (const double friction : {0.0, 0.3}) {
      SCOPED_TRACE(std::string(method_name(method)) + " friction " + std::to_string(friction));
      Scene scene = test::pile(40, 0.5, 9);
      scene.solver.method = method;
      if (friction > 0) scene.effects.friction = Friction{friction, friction};
      const Measurements measured = after(scene, 12);
      // Half of what it could lose is gone.
      EXPECT_GT(measured.energy_dissipated, 0.25 * measured.energy_initial);
      expect_balanced(measured, method == Method::event ? 1e-5 : 1e-12);
    }
  }
}

// Several contacts at one instant: a row of balls that touch, with and without friction.
TEST(EnergyBalance, OfSimultaneousImpacts) {
  for (const Method method : kMethods) {
    for (const double friction : {0.0, 0.5}) {
      SCOPED_TRACE(std::string(method_name(method)) + " friction " + std::to_string(friction));
      Scene scene = box_of(method);
      scene.effects.collisions = Collisions{0.6};
      scene.effects.walls = Walls{0.9};
      if (friction > 0) scene.effects.friction = Friction{friction, friction};
      scene.balls = {hard::ball(1, 4, 4, 0.5), hard::ball(4, 4, 0, 0), hard::ball(5, 4, 0, 0),
                     hard::ball(4.5, 4 + std::sqrt(0.75), 0, 0)};
      const Measurements measured = after(scene, 3);
      EXPECT_GT(measured.energy_dissipated, 1);
      expect_balanced(measured, 1e-13);
    }
  }
}

// Commands bring and take energy; what impacts and drag took before and after stays in the book.
TEST(EnergyBalance, OfScriptsWhichAreInput) {
  for (const Method method : kMethods) {
    for (const Lossy& lossy : lossy_gases()) {
      SCOPED_TRACE(std::string(method_name(method)) + ", " + lossy.name);
      Session session(lossy_gas(lossy, method));
      session.advance_clock_to(0.31);
      const double before = session.simulation().measure().energy_dissipated;
      session.apply(command::Remove{2});
      EXPECT_NEAR(session.simulation().measure().energy_dissipated, before, 1e-11);
      session.advance_clock_to(0.52);
      command::SetEffects set;
      set.effects.walls = Walls{0.3};
      if (lossy.effects.gravity) set.effects.gravity = Gravity{{3, 1}};
      if (lossy.effects.drag) set.effects.drag = Drag{0.9};
      session.apply(set);
      session.advance_clock_to(0.9);
      session.apply(command::Remove{});
      session.advance_clock_to(1.4);
      expect_balanced(session.simulation().measure(),
                      method == Method::event ? lossy.event : lossy.overlap);
    }
  }
}

// A saved run opens a book of its own.
TEST(EnergyBalance, OfARunThatGoesOnFromWhereItStands) {
  for (const Method method : kMethods) {
    for (const Lossy& lossy : lossy_gases()) {
      SCOPED_TRACE(std::string(method_name(method)) + ", " + lossy.name);
      Session first(lossy_gas(lossy, method));
      first.advance_clock_to(0.4);
      Session second(first.save());
      EXPECT_NEAR(second.simulation().measure().energy_dissipated, 0, 1e-12);
      second.advance_clock_to(0.8);
      expect_balanced(second.simulation().measure(),
                      method == Method::event ? lossy.event : lossy.overlap);
    }
  }
}

TEST(EnergyBalance, IsTheSameForAnyNumberOfWorkers) {
  for (const Method method : kMethods) {
    for (const Lossy& lossy : lossy_gases()) {
      Scene scene = lossy_gas(lossy, method);
      const double one = after(scene, 0.5).energy_dissipated;
      for (const std::size_t workers : {2U, 3U, 20U}) {
        scene.workers = workers;
        EXPECT_EQ(after(scene, 0.5).energy_dissipated, one) << lossy.name << ' ' << workers;
      }
    }
  }
}

// Where workers share the plane, drag alone takes energy.
TEST(EnergyBalance, OfDragWhereWorkersShareThePlane) {
  Scene scene = test::walled_gas(70, 70, 0.4);
  scene.solver.method = Method::event;
  scene.effects.drag = Drag{0.2};
  scene.workers = 2;
  const Measurements measured = after(scene, 1);
  const double lost = -std::expm1(-2 * 0.2) * measured.energy_initial;
  EXPECT_NEAR(measured.energy_dissipated, lost, 1e-11 * lost);
  expect_balanced(measured, 1e-11);
}

// Falling round a periodic side, pushed over it by other balls, too.
// Seen to fail: with laps that are not counted where balls that overlap are moved apart.
TEST(EnergyBalance, OfFallingRoundAPeriodicSide) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    Scene scene = test::gas(5, 6, 0.5, 4);
    scene.solver.method = method;
    scene.effects.gravity = Gravity{{0, -10}};
    for (const double restitution : {1.0, 0.7}) {
      scene.effects.collisions = Collisions{restitution};
      expect_balanced(after(scene, 2), method == Method::event ? 1e-12 : 1e-6);
    }
  }
}

// Its centre is on the periodic side and a fixed ball holds it against gravity along it.  As long
// as others move it is asleep: each flight takes it over the side, and each is taken back.
// Seen to fail: with laps of a flight that is taken back left counted.
TEST(EnergyBalance, OfABallAsleepOnAPeriodicSide) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    for (const double side : {0.0, 9.0}) {
      Scene scene = box_of(method, 9, 12);
      scene.box.periodic = {true, false};
      scene.effects.walls = Walls{0};
      scene.effects.collisions = Collisions{0};
      scene.effects.gravity = Gravity{{side > 0 ? 3.0 : -3.0, -4}};
      scene.balls = {hard::ball(side, 1, 0, 0, 1, 1), hard::ball(side > 0 ? 2 : 7, 1, 0, 0, 1, 1),
                     hard::ball(4.5, 9, 0, 0, 1, 1)};
      scene.balls[1].fixed = true;
      // The third one falls free, through 2 and 3/2 in this time.
      const Measurements falling = after(scene, 1);
      EXPECT_NEAR(falling.energy_dissipated, 0, 1e-9);
      expect_balanced(falling, 1e-11);
      // It has fallen on the others and slid round them.
      expect_balanced(after(scene, 4), method == Method::event ? kIslands : 1e-11);
    }
  }
}

// Heavy balls that close on a light one, a hundredth beside their line, drive it more than half a
// period on in one step: that is its way, not the shorter one round.
// Seen to fail: with what gravity gives on the shorter way.
TEST(EnergyBalance, OfABallSqueezedOutFartherThanHalfAPeriod) {
  for (const double gravity : {1.0, -1.0}) {
    for (const double aside : {0.01, 0.005}) {
      Scene scene = box_of(Method::overlap, 4, 4);
      scene.box.periodic = {true, false};
      scene.effects.walls = Walls{0.5};
      scene.effects.collisions = Collisions{0.5};
      scene.effects.gravity = Gravity{{gravity, 0}};
      scene.solver.step = 0.125;
      scene.balls = {hard::ball(1, 1.5, 0, 0.5, 0.25, 1e6), hard::ball(1, 2.5, 0, -0.5, 0.25, 1e6),
                     hard::ball(1 + aside, 2, 0, 0, 0.25, 1)};
      expect_balanced(after(scene, 0.125), 1e-14);
    }
  }
}

}  // namespace
}  // namespace carom::energy_balance_test
