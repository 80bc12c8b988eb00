#include "solvers/event/islands/island_motion.hpp"

#include <gtest/gtest.h>

#include "contact/contact_graph.hpp"

namespace carom::event::island_motion_test {
namespace {

// Towards the bottom and the left; away from them and along them nothing changes.
TEST(IslandMotion, IsStoppedAtAWallOnlyTowardsIt) {
  const ConeContact bottom{0, kWall, {0, -1}, 0, 0};
  const ConeContact left{0, kWall, {-1, 0}, 0, 0};
  ConeBody body{{-3, -2}, 5, 1};
  stop_at(body, bottom);
  EXPECT_EQ(body.velocity, (Vec<double>{-3, 0}));
  stop_at(body, left);
  EXPECT_EQ(body.velocity, (Vec<double>{0, 0}));
  EXPECT_EQ(body.turning, 5);
  body.velocity = {3, 2};
  stop_at(body, bottom);
  stop_at(body, left);
  EXPECT_EQ(body.velocity, (Vec<double>{3, 2}));
}

}  // namespace
}  // namespace carom::event::island_motion_test
