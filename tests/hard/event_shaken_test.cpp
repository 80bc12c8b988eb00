// Balls that lose energy while gravity is set again every 0.01 s.

#include <gtest/gtest.h>

#include <string>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"

namespace carom::event_shaken_test {
namespace {

// What a ball that is pressed into an island at the end of an instant touches falls on it at the
// same instant: it is of that impact, or takes it back, and all begins again a few ticks later.
// Seen to fail: it did not end.
TEST(EventShaken, impacts_at_one_instant_end) {
  Session session(parse_scene(R"({
    "box": {"width": 5, "height": 9},
    "effects": {"walls": {"restitution": 0.2}, "collisions": {"restitution": 0.2},
                "gravity": [0, -9.81]},
    "fill": [{"count": 16, "radius": 0.5, "mass": 1, "temperature": 1}],
    "seed": 11, "duration": 2.5, "workers": 1,
    "solver": {"method": "event"}})",
                              "shaken"));
  constexpr int kSets = 249;
  for (int k = 1; k <= kSets; ++k) {
    session.advance_clock_to(k / 100.0);
    const Vec2 pull{((k * 37) % 17 - 8) / 16.0, -9.75 + ((k * 53) % 19 - 9) / 16.0};
    command::SetEffects change;
    change.effects.gravity = Gravity{pull};
    session.apply(change);
  }
  session.advance_clock_to(2.5);
  const Measurements measured = session.simulation().measure();
  EXPECT_LT(measured.max_overlap, 1e-3);
  EXPECT_EQ(measured.jammed, 0U);
  // They press each other at two instants a millisecond at most.
  EXPECT_LT(measured.joint_impacts, 2U * 2500);
}

}  // namespace
}  // namespace carom::event_shaken_test
