#include <algorithm>
#include <cmath>
#include <string>

#include "carom/scene_file.hpp"
#include "verify/cases.hpp"
#include "verify/runs.hpp"

namespace carom::hard {

namespace {

constexpr const char* kBox = R"({"box": {"width": 8, "height": 8}, )";

/// Scenes that nobody can run: each has to be refused.
constexpr const char* kRefused[] = {
    R"("effects": {"collisions": {}}, "balls": [{"position": [2, 2]}, {"position": [2, 2]}]})",
    R"("effects": {"collisions": {}}, "balls": [{"position": [2, 2]}, {"position": [2.5, 2]}]})",
    R"("effects": {"walls": {}}, "balls": [{"position": [8, 8]}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "radius": 0}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "radius": 5e-324}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "mass": 1e308}]})",
    R"("effects": {}, "balls": [{"position": [2, 2], "velocity": [1e308, 0]}]})",
};

/// Scenes that are odd and right.
constexpr const char* kRight[] = {
    R"("effects": {"walls": {}, "collisions": {}}, "balls": []})",
    R"("effects": {"walls": {}, "collisions": {}, "gravity": [0, 0]}, "balls": [{"position": [2, 2]}]})",
    R"("effects": {"walls": {}, "collisions": {}}, "balls": [{"position": [2, 2], "velocity": [1e-300, 0]}, {"position": [5, 2]}]})",
    R"("effects": {"walls": {}, "collisions": {}}, "balls": [{"position": [2, 2], "velocity": [5e-324, 0]}]})",
    R"("effects": {"collisions": {}}, "balls": [{"position": [2, 2], "velocity": [-1, -1]}]})",
    R"("effects": {}, "balls": [{"position": [2, 2]}, {"position": [2, 2]}]})",
};

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
      const Outcome outcome = run(scene, time);
      const bool finite = std::all_of(
          outcome.balls.begin(), outcome.balls.end(),
          [](const Ball& each) { return each.position.allFinite() && each.velocity.allFinite(); });
      if (!finite || outcome.balls.size() != scene.balls.size()) ++wrong;
    }
  }
  return wrong;
}

}  // namespace

std::vector<Case> start_cases() {
  return {{"start",
           {{Method::event, "neither refused nor right", 0, wrong_starts},
            {Method::overlap, "neither refused nor right", 0, wrong_starts}}}};
}

}  // namespace carom::hard
