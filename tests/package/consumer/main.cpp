#include <carom/report.hpp>
#include <carom/simulation.hpp>
#include <cstdio>

int main() {
  carom::Scene scene;
  scene.name = "one ball flies";
  scene.effects.walls = carom::Walls{};
  scene.solver.step = 0.125;
  carom::Ball ball;
  ball.position = {3, 5};
  ball.velocity = {1, 0};
  scene.balls.push_back(ball);

  carom::Simulation simulation(scene);
  simulation.advance_to(2);
  const carom::Vec2 place = simulation.state().front().position;
  std::printf("carom %s: x = %g after %g s\n", carom::version(), place.x(), simulation.time());
  return place == carom::Vec2(5, 5) ? 0 : 1;
}
