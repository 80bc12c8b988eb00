// What only shows after long: energy, overlap and memory stay flat for an hour of the built-in
// scene and for a hundred million collisions of a gas.  Prints the figures.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"
#include "support/scenes.hpp"

namespace carom::long_runs_test {
namespace {

/// Bytes of this program that are in memory.
double resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  double all = 0;
  double resident = 0;
  pages >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

constexpr double kMebibyte = 0x1p20;

/// After a first part memory is what it will be: allocators keep what they once needed.
class Memory {
 public:
  void look() { most_ = std::max(most_, resident_bytes()); }
  void begin() { first_ = most_ = resident_bytes(); }
  [[nodiscard]] double grown() const { return most_ - first_; }

 private:
  double first_ = 0;
  double most_ = 0;
};

void expect_flat(const char* what, const Measurements& measured, const Memory& memory) {
  const double energy_error = std::abs(measured.relative_energy_error());
  std::printf("%s: %.3g collisions, energy off by %.1e, overlap %.1e r, %.2f MiB more\n", what,
              static_cast<double>(measured.ball_ball), energy_error, measured.max_overlap,
              memory.grown() / kMebibyte);
  EXPECT_LE(energy_error, 1e-12);
  EXPECT_LE(measured.max_overlap, 1e-12);
  EXPECT_LE(memory.grown(), kMebibyte);
}

TEST(LongRun, AnHourOfTheBuiltInSceneKeepsItsEnergy) {
  Scene scene = builtin_scene();
  scene.solver.method = Method::event;
  Simulation simulation(scene);
  constexpr double kHour = 3600;
  constexpr double kParts = 360;
  Memory memory;
  for (double part = 1; part <= kParts; ++part) {
    simulation.advance_to(kHour * part / kParts);
    if (part == kParts / 10) memory.begin();
    memory.look();
  }
  expect_flat("an hour of the built-in scene", simulation.measure(), memory);
}

TEST(LongRun, AHundredMillionCollisionsKeepTheirEnergy) {
  Scene scene = test::gas(25, 40, 0.30);
  scene.solver.method = Method::event;
  Simulation simulation(scene);
  constexpr double kCollisions = 1e8;
  Memory memory;
  double time = 0;
  double collisions = 0;
  while (collisions < kCollisions) {
    simulation.advance_to(time += 100);
    const double before = collisions;
    collisions = static_cast<double>(simulation.measure().ball_ball);
    ASSERT_GT(collisions, before);
    if (before < kCollisions / 10 && collisions >= kCollisions / 10) memory.begin();
    memory.look();
  }
  expect_flat("a gas of 1,000 balls", simulation.measure(), memory);
}

}  // namespace
}  // namespace carom::long_runs_test
