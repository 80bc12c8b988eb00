// Method event stopped, saved as text, read back and gone on ends with the bits of the run that was
// never stopped.
#include <gtest/gtest.h>

#include "carom/scene_file.hpp"
#include "carom/simulation.hpp"

namespace carom::event_go_on_test {
namespace {

const char* const kScenes[] = {
    R"({"box": {"width": 20, "height": 10}, "effects": {"walls": {}, "collisions": {}},
        "fill": [{"count": 60, "radius": 0.3, "temperature": 2}], "seed": 5})",
    R"({"box": {"width": 20, "height": 20, "periodic": ["x", "y"]}, "effects": {"collisions": {}},
        "fill": [{"count": 150, "radius": 0.4, "temperature": 1}], "seed": 6})",
    R"({"box": {"width": 20, "height": 10, "origin": "center"},
        "effects": {"walls": {}, "collisions": {}, "gravity": [0.5, -9.81]},
        "balls": [{"position": [-5, -2], "radius": 1, "fixed": true},
                  {"position": [4, -3], "radius": 0.75, "fixed": true}],
        "fill": [{"count": 20, "radius": 0.3, "temperature": 1, "region": [[-10, 0], [10, 5]]}],
        "seed": 7})",
    R"({"box": {"width": 20, "height": 10, "origin": "center"},
        "effects": {"walls": {}, "collisions": {}, "gravity": [0, -3], "drag": {"rate": 0.2}},
        "balls": [{"position": [-5, -2], "radius": 1, "fixed": true}],
        "fill": [{"count": 20, "radius": 0.3, "temperature": 1, "region": [[-10, 0], [10, 5]]}],
        "seed": 7})",
    R"({"box": {"width": 20, "height": 10, "periodic": ["x"]},
        "effects": {"walls": {}, "collisions": {}}, "solver": {"digits": 34},
        "fill": [{"count": 20, "radius": 0.3, "temperature": 2}], "seed": 8})",
    R"({"box": {"width": 20, "height": 10},
        "effects": {"walls": {}, "collisions": {}, "friction": {"balls": 0.2, "walls": 0.3}},
        "fill": [{"count": 40, "radius": 0.3, "temperature": 2}], "seed": 9})",
    // A contact island that keeps its energy: flights of it are counted without some.
    R"({"box": {"width": 10, "height": 6},
        "effects": {"walls": {}, "collisions": {}, "gravity": [0.5, -9.81]},
        "balls": [{"position": [3, 0.5]}, {"position": [4, 0.5]}, {"position": [5, 0.5]},
                  {"position": [3.5, 1.3660254037845]}, {"position": [4.5, 1.3660254037845]},
                  {"position": [4, 2.232050807569]}]})",
    // A ball that ends with the velocity -0.
    R"({"box": {"width": 4, "height": 4, "origin": "center"}, "effects": {"walls": {"restitution": 0}},
        "solver": {"digits": 34}, "balls": [{"position": [0.4, -0.3], "velocity": [1, -20]},
                                          {"position": [-1, -1], "velocity": [0.01, 0.02]}]})",
    R"({"box": {"width": 4, "height": 4, "origin": "center"}, "effects": {"walls": {"restitution": 0}},
        "solver": {"digits": 100}, "balls": [{"position": [0.4, -0.3], "velocity": [1, -20]},
                                          {"position": [-1, -1], "velocity": [0.01, 0.02]}]})",
};

std::string hash_at(const Scene& scene, double time) {
  Simulation simulation(scene);
  simulation.advance_to(time);
  return simulation.state_hash();
}

class EventGoOn : public testing::TestWithParam<const char*> {};

TEST_P(EventGoOn, EndsWithTheSameBits) {
  Scene scene = parse_scene(GetParam(), "scene");
  scene.solver.method = Method::event;
  const double end = 3;
  const std::string whole = hash_at(scene, end);
  EXPECT_NE(whole, hash_at(scene, 2.75));
  for (const double stop : {0.0, 0.001, 1.0, 2.2345}) {
    Simulation first(scene);
    first.advance_to(stop);
    const std::string saved = write_scene(first.save());
    Scene again = parse_scene(saved, "saved");
    // Once more, without moving on in between.
    again = parse_scene(write_scene(Simulation(again).save()), "saved twice");
    EXPECT_EQ(hash_at(again, end), whole) << stop;
  }
}

TEST_P(EventGoOn, RefusesABallThatIsNotWhereItsFlightHasIt) {
  Scene scene = parse_scene(GetParam(), "scene");
  scene.solver.method = Method::event;
  Simulation first(scene);
  first.advance_to(1);
  Scene saved = first.save();
  saved.balls.back().position.x() += 0.01;
  EXPECT_THROW(Simulation{saved}, SceneError);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EventGoOn, testing::ValuesIn(kScenes));

}  // namespace
}  // namespace carom::event_go_on_test
