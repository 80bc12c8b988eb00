#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "carom/report.hpp"
#include "verify/runs.hpp"

namespace carom {

inline constexpr Method kMethods[] = {Method::event, Method::overlap};

inline Scene box_of(Method method, double width = 8, double height = 8) {
  Scene scene;
  scene.box.width = width;
  scene.box.height = height;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  scene.solver.method = method;
  scene.workers = 1;
  return scene;
}

/// Nothing is lost that nothing accounts for, but for this part.
inline void expect_balanced(const Measurements& measured, double limit) {
  const double unexplained =
      std::abs(measured.energy_final -
               (measured.energy_initial + measured.energy_input - measured.energy_dissipated));
  EXPECT_GE(measured.energy_dissipated, 0);
  EXPECT_LE(unexplained, limit * measured.energy_largest);
  EXPECT_LE(measured.relative_energy_error(), limit);
}

inline Measurements after(const Scene& scene, double time) {
  return hard::run(scene, time).measured;
}

}  // namespace carom
