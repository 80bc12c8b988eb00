#include "solvers/event/event_memory.hpp"

#include <gtest/gtest.h>

#include "solvers/event/domains/domains.hpp"
#include "support/event_setting.hpp"

namespace carom::event::event_memory_test {
namespace {

Scene gas(std::size_t side) {
  Scene scene;
  scene.box.width = scene.box.height = static_cast<double>(side);
  scene.box.periodic = {true, true};
  scene.effects.collisions.emplace();
  for (std::size_t k = 0; k < side * side; ++k) {
    Ball ball;
    ball.position = {static_cast<double>(k % side) + 0.5, static_cast<double>(k / side) + 0.5};
    ball.velocity = {k % 3 == 0 ? 1.0 : -0.5, k % 5 == 0 ? 1.0 : -0.25};
    ball.radius = 0.4;
    scene.balls.push_back(ball);
  }
  return scene;
}

/// What domains have taken once they have solved some windows.
std::size_t taken(const Scene& scene, std::size_t workers) {
  Rules rules{carom::Domain(scene.box, false), FixedTimeClock(1)};
  rules.all_species = {{0.4, 1}};
  std::vector<Disk> disks;
  for (const Ball& ball : scene.balls) {
    Disk disk;
    disk.x = ball.position.x();
    disk.y = ball.position.y();
    disk.vx = ball.velocity.x();
    disk.vy = ball.velocity.y();
    disks.push_back(disk);
  }
  Domains<Ballistic> domains(rules);
  domains.set_workers(workers);
  domains.reset(disks, 0, {});
  advance(domains, rules.scale.ticks(0.5), workers);
  return domains.bytes();
}

void expect_about(const Scene& scene, std::size_t workers) {
  const EventMemory memory = event_memory(scene, scene.balls, workers);
  EXPECT_EQ(memory.neighbours, 0U);
  EXPECT_EQ(memory.queue, 0U);
  const auto told = static_cast<double>(memory.flights + memory.domains);
  const auto actual = static_cast<double>(taken(scene, workers));
  EXPECT_GT(told, 0.75 * actual) << workers;
  EXPECT_LT(told, 1.35 * actual) << workers;
}

TEST(EventMemory, OfDomainsIsAboutWhatTheyTake) {
  expect_about(gas(60), 1);
  expect_about(gas(160), 1);
  expect_about(gas(160), 2);
}

// Fewer than 200 balls are solved by one event loop.
TEST(EventMemory, OfFewBallsIsThatOfAnEventLoop) {
  const Scene scene = gas(10);
  const EventMemory memory = event_memory(scene, scene.balls, 1);
  EXPECT_EQ(memory.domains, 0U);
  EXPECT_EQ(memory.flights, 100 * sizeof(Disk));
  EXPECT_GT(memory.neighbours, 0U);
  EXPECT_GT(memory.queue, 0U);
}

TEST(EventMemory, HasNoNeighboursWithoutCollisions) {
  Scene scene = gas(20);
  scene.effects.collisions.reset();
  const EventMemory memory = event_memory(scene, scene.balls, 1);
  EXPECT_EQ(memory.neighbours, 0U);
  EXPECT_EQ(memory.domains, 0U);
}

}  // namespace
}  // namespace carom::event::event_memory_test
