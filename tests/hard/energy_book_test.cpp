// The energy book: what restitution, friction and drag take is booked by the formula of each impact
// and flight, so that nothing of a lossy run is left that nothing accounts for.
//
// What is booked is held against theory: the whole of a drop, an impact by hand, exp(-2 rate t).
// What is left over is rounding where flights are exact, and the error of the step elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "carom/report.hpp"
#include "carom/session.hpp"
#include "support/scenes.hpp"
#include "verify/runs.hpp"

namespace carom {
namespace {

constexpr Method kMethods[] = {Method::event, Method::overlap};

Scene box_of(Method method, double width = 8, double height = 8) {
  Scene scene;
  scene.box.width = width;
  scene.box.height = height;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.solver.method = method;
  scene.workers = 1;
  return scene;
}

void expect_balanced(const Measurements& measured, double limit) {
  const double unexplained =
      std::abs(measured.energy_final -
               (measured.energy_initial + measured.energy_input - measured.energy_dissipated));
  EXPECT_GE(measured.energy_dissipated, 0);
  EXPECT_LE(unexplained, limit * measured.energy_largest);
  EXPECT_LE(measured.relative_energy_error(), limit);
}

Measurements after(const Scene& scene, double time) {
  return hard::run(scene, time).measured;
}

// Seen to fail: without what the last bounces of a ball that is laid to rest have left, and without
// the impacts at walls.
TEST(EnergyBook, ABallThatBouncesToRestHasLostAllOfItsDrop) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    Scene scene = box_of(method);
    scene.effects.walls = Walls{0.5};
    scene.effects.gravity = Gravity{{0, -10}};
    scene.balls = {hard::ball(4, 3.5, 0, 0, 0.5, 2)};
    const Measurements measured = after(scene, 10);
    EXPECT_NEAR(measured.energy_dissipated, 2 * 10 * 3.0, 1e-10);
    expect_balanced(measured, 1e-13);
  }
}

// A fall from where kinetic and potential energy are 0 together: what is left of both is rounding,
// which is small beside either.
TEST(EnergyBook, ARunWithoutAnyEnergyIsMeasuredByItsMotion) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    Scene scene = box_of(method);
    scene.effects.gravity = Gravity{{9.81, -9.81}};
    scene.balls = {hard::ball(3, 3, 0, 0, 0.5, 2)};
    const Measurements measured = after(scene, 0.37);
    EXPECT_LE(std::abs(measured.energy_final), 1e-13);
    EXPECT_LE(measured.relative_energy_error(), 1e-14);
  }
}

// Head-on, e = 1/2, masses 1 and 3 at 4: (1 - e^2) v^2 / (2 (1/m_1 + 1/m_2)) = 4.5.
TEST(EnergyBook, AnImpactLosesWhatItsRestitutionSays) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    Scene scene = box_of(method);
    scene.effects.collisions = Collisions{0.5};
    scene.balls = {hard::ball(2, 4, 4, 0), hard::ball(5, 4, 0, 0, 0.5, 3)};
    const Measurements measured = after(scene, 1);
    EXPECT_NEAR(measured.energy_dissipated, 4.5, 1e-13);
    expect_balanced(measured, 1e-15);
  }
}

// Against a wall at 45 degrees with spin 0, e = 1 and friction that sticks: the slip v_t is brought
// to 0 by the impulse m v_t / 3, whose work is m v_t^2 / 6.
// Seen to fail: without what friction takes.
TEST(EnergyBook, FrictionThatSticksTakesAThirdOfWhatSlips) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    Scene scene = box_of(method);
    scene.effects.friction = Friction{0, 5};
    scene.balls = {hard::ball(4, 2, 1.5, -3, 0.5, 2)};
    const Measurements measured = after(scene, 1);
    EXPECT_NEAR(measured.energy_dissipated, 2 * 1.5 * 1.5 / 6, 1e-14);
    expect_balanced(measured, 1e-15);
  }
}

// All of a gas in drag: exp(-2 rate t) is left, whatever its elastic impacts.
// Seen to fail: without what drag takes, and counting the present flights twice.
TEST(EnergyBook, DragTakesWhatItsRateSays) {
  for (const Method method : kMethods) {
    SCOPED_TRACE(method_name(method));
    Scene scene = test::walled_gas(6, 6, 0.3);
    scene.solver.method = method;
    scene.effects.drag = Drag{0.3};
    const Measurements measured = after(scene, 2);
    const double lost = -std::expm1(-2 * 0.3 * 2) * measured.energy_initial;
    EXPECT_NEAR(measured.energy_dissipated, lost, (method == Method::event ? 1e-12 : 2e-2) * lost);
    expect_balanced(measured, 1e-12);
  }
}

// Falling in drag, on closed forms: no impact at all.
TEST(EnergyBook, AFallInDragBalances) {
  for (const Method method : kMethods) {
    for (const double rate : {1e-9, 1e-3, 0.5, 20.0}) {
      SCOPED_TRACE(method_name(method) + std::to_string(rate));
      Scene scene = box_of(method, 100, 1000);
      scene.effects.walls.reset();
      scene.effects.gravity = Gravity{{1, -9}};
      scene.effects.drag = Drag{rate};
      scene.balls = {hard::ball(4, 900, 3, 5)};
      scene.balls[0].mass = 7;
      expect_balanced(after(scene, 3), 1e-13);
    }
  }
}

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

TEST(EnergyBook, LossyGasesBalanceWithEverySetOfEffects) {
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
TEST(EnergyBook, PilesBalance) {
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
TEST(EnergyBook, SimultaneousImpactsBalance) {
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
TEST(EnergyBook, ScriptsAreInput) {
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
TEST(EnergyBook, ARunThatGoesOnCountsFromWhereItStands) {
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

TEST(EnergyBook, IsTheSameForAnyNumberOfWorkers) {
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
TEST(EnergyBook, DragBalancesWhereWorkersShareThePlane) {
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
TEST(EnergyBook, FallingRoundAPeriodicSideBalances) {
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

}  // namespace
}  // namespace carom
