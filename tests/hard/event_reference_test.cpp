#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hard/reference_scene.hpp"
#include "solvers/event/solver.hpp"
#include "support/advance.hpp"

namespace carom::event_reference_test {
namespace {

double number(const nlohmann::json& text) {
  return std::stod(text.get<std::string>());
}

void run(Solver& solver, double until, int frames) {
  for (int frame = 1; frame <= frames; ++frame) {
    test::advance(solver, frame < frames ? until * frame / frames : until);
  }
}

class EventReference : public testing::TestWithParam<const char*> {};

// The scenes' exact ends come from 100-digit arithmetic by an independent program; `condition` is
// how much the flow amplifies a small change of the start.
TEST_P(EventReference, ends_within_the_rounding_its_condition_allows_after_as_many_impacts) {
  const test::ReferenceScene reference = test::reference_scene(GetParam());
  const auto& [scene, time, condition, expected] = reference;
  const double allowed = 64 * condition * 0x1p-53 * reference.size();

  const auto solver = std::make_unique<EventSolver>(scene, populate(scene));
  run(*solver, time, 1);
  Measurements measured;
  solver->count(measured);
  EXPECT_EQ(measured.ball_ball, expected["ball_ball"].get<std::uint64_t>());
  EXPECT_EQ(measured.ball_wall, expected["ball_wall"].get<std::uint64_t>());
  const std::vector<Ball> end = solver->state();
  double worst = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const nlohmann::json& ball = expected["balls"][i];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      double off = end[i].position[axis] - number(ball["position"][k]);
      if (scene.box.periodic[k]) off = std::remainder(off, scene.box.size()[axis]);
      worst = std::max(worst, std::abs(off));
    }
  }
  EXPECT_LE(worst, allowed);
  RecordProperty("part_of_the_allowance", std::to_string(worst / allowed));

  const auto watched = std::make_unique<EventSolver>(scene, populate(scene));
  run(*watched, time, 997);
  EXPECT_EQ(watched->state_hash(), solver->state_hash()) << "frames must only look";
}

INSTANTIATE_TEST_SUITE_P(Scenes, EventReference,
                         testing::Values("gas", "channel", "mixture", "open", "ideal", "periodic",
                                         "gravity", "pegs", "pegs-and-gravity", "inelastic", "drag",
                                         "drag-and-gravity", "friction"));

}  // namespace
}  // namespace carom::event_reference_test
