#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "carom/scene.hpp"

namespace carom::test {

/// A number in [0, 1) that is the same with every standard library.
inline double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11U) * 0x1p-53;
}

inline double gaussian(std::mt19937_64& engine) {
  const double u = 1 - uniform(engine);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * uniform(engine));
}

inline Box box_of(double width, double height, bool around_x, bool around_y) {
  Box box;
  box.width = width;
  box.height = height;
  box.periodic = {around_x, around_y};
  return box;
}

/// `columns` x `rows` disks of radius 1/2 and mass 1 at a packing, in rows like a honeycomb, in a
/// box they fill evenly; velocities of temperature 1, no net momentum.
inline Scene gas(std::size_t columns, std::size_t rows, double packing, std::uint64_t seed = 1) {
  // One disk has a cell of a x a sqrt(3)/2.
  const double a = std::sqrt(std::numbers::pi / 4 / packing / (std::sqrt(3.0) / 2));
  const double b = a * std::sqrt(3.0) / 2;
  Scene scene;
  scene.name = "gas";
  scene.box.width = a * static_cast<double>(columns);
  scene.box.height = b * static_cast<double>(rows);
  scene.box.periodic = {true, true};
  scene.effects.collisions = Collisions{};
  scene.solver.method = Method::overlap;
  scene.workers = 1;
  std::mt19937_64 engine(seed);
  Vec2 sum{0, 0};
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      Ball ball;
      ball.position = {a * (static_cast<double>(c) + (r % 2 == 0 ? 0.25 : 0.75)),
                       b * (static_cast<double>(r) + 0.5)};
      ball.velocity.x() = gaussian(engine);
      ball.velocity.y() = gaussian(engine);
      sum += ball.velocity;
      scene.balls.push_back(ball);
    }
  }
  for (Ball& ball : scene.balls) ball.velocity -= sum / static_cast<double>(scene.balls.size());
  return scene;
}

/// The same between solid walls; the box has room for the outermost disks.
inline Scene walled_gas(std::size_t columns, std::size_t rows, double packing,
                        std::uint64_t seed = 1) {
  Scene scene = gas(columns, rows, packing, seed);
  scene.box.periodic = {false, false};
  scene.box.width += 1;
  scene.box.height += 1;
  for (Ball& ball : scene.balls) ball.position += Vec2{0.5, 0.5};
  scene.effects.walls = Walls{};
  return scene;
}

/// Disks of radius 1/2 that are dropped in loose rows, slightly out of line, into a box 30 wide.
inline Scene pile(std::size_t balls, double restitution, double width = 30) {
  Scene scene;
  scene.name = "pile";
  scene.box.width = width;
  scene.effects.walls = Walls{restitution};
  scene.effects.collisions = Collisions{restitution};
  scene.effects.gravity = Gravity{{0, -9.8}};
  scene.solver.method = Method::overlap;
  scene.workers = 1;
  std::mt19937_64 engine(5);
  const auto columns = static_cast<std::size_t>(width / 1.2);
  for (std::size_t i = 0; i < balls; ++i) {
    const std::size_t column = i % columns;
    const std::size_t row = i / columns;
    Ball ball;
    ball.position = {0.6 + 1.2 * static_cast<double>(column) + 0.09 * (uniform(engine) - 0.5),
                     0.6 + 1.2 * static_cast<double>(row) + 0.09 * (uniform(engine) - 0.5)};
    scene.balls.push_back(ball);
  }
  scene.box.height = scene.balls.back().position.y() + 2;
  return scene;
}

}  // namespace carom::test
