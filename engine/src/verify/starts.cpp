#include <string>

#include "carom/scene_file.hpp"
#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

constexpr const char* kBox = R"({"box": {"width": 8, "height": 8}, )";

/// Invalid scenes: each must be refused.
constexpr const char* kRefused[] = {
    R"("effects": {"collisions": {}}, "balls": [{"position": [2, 2]}, {"position": [2, 2]}]})",
    R"("effects": {"collisions": {}}, "balls": [{"position": [2, 2]}, {"position": [2.5, 2]}]})",
    R"("effects": {"walls": {}}, "balls": [{"position": [8, 8]}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "radius": 0}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "radius": 5e-324}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "mass": 1e308}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "velocity": [1e308, 0]}]})",
};

/// Unusual scenes that are valid.
constexpr const char* kRight[] = {
    R"("effects": {"walls": {}, "collisions": {}}, "balls": []})",
    R"("effects": {"walls": {}, "collisions": {}, "gravity": [0, 0]}, "balls": [{"position": [2, 2]}]})",
    R"("effects": {"walls": {}, "collisions": {}}, "balls": [{"position": [2, 2], "velocity": [1e-300, 0]}, {"position": [5, 2]}]})",
    R"("effects": {"walls": {}, "collisions": {}}, "balls": [{"position": [2, 2], "velocity": [5e-324, 0]}]})",
    R"("effects": {"collisions": {}}, "balls": [{"position": [2, 2], "velocity": [-1, -1]}]})",
    R"("effects": {}, "balls": [{"position": [2, 2]}, {"position": [2, 2]}]})",
};

/// Whether every ball is where it has flown to, with the velocity that it had: in none of kRight
/// does anything touch or pull it.
bool flies_on(const Scene& scene, double time) {
  constexpr double kRounding = 1e-12;  // of a few hundred steps, in a box of 8
  const Outcome outcome = run(scene, time);
  bool right = outcome.balls.size() == scene.balls.size();
  for (std::size_t i = 0; right && i < scene.balls.size(); ++i) {
    const Ball& start = scene.balls[i];
    const Vec2 off = outcome.balls[i].position - (start.position + time * start.velocity);
    right = off.norm() <= kRounding && outcome.balls[i].velocity == start.velocity;
  }
  return right;
}

/// Two balls fly at each other so fast that one step takes both to the same place: each goes back
/// as fast as it came, on its own side.
bool turns_back_where_centres_coincide(const Trial& trial) {
  Scene scene = with_balls(trial.scene, {ball(0.5, 1, 16, 0), ball(3.5, 1, -16, 0)});
  scene.solver.step = 1.5 / 16;
  const Outcome outcome = run(scene, scene.solver.step);
  const Ball& left = outcome.balls[0];
  const Ball& right = outcome.balls[1];
  return left.velocity == Vec2{-16, 0} && right.velocity == Vec2{16, 0} &&
         left.position.x() < right.position.x();
}

double wrong_starts(const Trial& trial) {
  double wrong = 0;
  for (const char* rest : kRefused) {
    try {
      parse_scene(std::string(kBox) + rest, "start");
      ++wrong;
    } catch (const SceneError&) {
    }
  }
  for (const char* rest : kRight) {
    Scene scene = parse_scene(std::string(kBox) + rest, "start");
    scene.solver.method = trial.scene.solver.method;
    for (const double time : {0.0, 2.0}) {
      if (!flies_on(scene, time)) ++wrong;
    }
  }
  if (!turns_back_where_centres_coincide(trial)) ++wrong;
  return wrong;
}

}  // namespace

std::vector<Case> start_cases() {
  return {{"start",
           {{Method::event, "neither refused nor right", 0, wrong_starts},
            {Method::overlap, "neither refused nor right", 0, wrong_starts}}}};
}

}  // namespace carom::hard
