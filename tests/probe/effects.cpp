// Runs a small scene with the effects that are named, on one thread and without the program around
// it: what a counter of instructions then sees is what the effects make of a step.

#include <cstddef>
#include <string>

#include "solvers/integrated/solver.hpp"
#include "solvers/overlap/solver.hpp"

namespace {

using namespace carom;

void run(Solver& solver, double time) {
  const std::vector<Phase> phases = solver.phases();
  solver.set_workers(1);
  std::size_t phase = solver.aim(time);
  while (phase != Phase::kFrameDone) {
    phases[phase].work({});
    phase = phases[phase].finish();
  }
}

}  // namespace

int main(int count, char** words) {
  Scene scene;
  scene.box.width = 5;
  scene.box.height = 5;
  scene.workers = 1;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "walls") scene.effects.walls = Walls{0.9};
    if (word == "collisions") scene.effects.collisions = Collisions{0.9};
    if (word == "gravity") scene.effects.gravity = Gravity{{0, -9.81}};
    if (word == "drag") scene.effects.drag = Drag{0.1};
    if (word == "friction") scene.effects.friction = Friction{0.2, 0.3};
    if (word == "attraction") scene.effects.attraction = Attraction{1, 0.1};
  }
  std::vector<Ball> balls;
  for (int i = 0; i < 9; ++i) {
    Ball ball;
    const int row = i / 3;
    ball.position = {1 + 1.5 * (i % 3), 1 + 1.5 * row};
    ball.velocity = {3 - 0.7 * i, 0.5 * i - 1};
    balls.push_back(ball);
  }
  OverlapSolver overlap(scene, balls);
  run(overlap, 1);
  if (!scene.effects.attraction) return 0;
  IntegratedSolver integrated(scene, balls);
  run(integrated, 0.1);
}
