// What a joint impact does where reflections do not end: bodies get one velocity, or their energy
// back.
#include <gtest/gtest.h>

#include <vector>

#include "contact/common_velocities.hpp"
#include "contact/kept_energy.hpp"

namespace carom::event {
namespace {

using Bodies = std::vector<Body<double>>;
using Contacts = std::vector<Contact<double>>;
using Velocities = std::vector<Vec<double>>;

TEST(CommonVelocities, KeepTheMomentumOfWhatIsJoined) {
  const Bodies bodies{{{4, 1}, 1}, {{0, 2}, 1.0 / 3}, {{5, 5}, 1}};
  const Contacts contacts{{0, 1, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  CommonVelocities<double> common(bodies, graph);
  common.join(0, 0);
  Velocities velocities{{4, 1}, {0, 2}, {5, 5}};
  common.give(velocities);
  EXPECT_EQ(common.joined(), 2);
  EXPECT_EQ(velocities[0].x, 1) << "(1 * 4 + 3 * 0) / 4";
  EXPECT_EQ(velocities[1].x, 1);
  EXPECT_EQ(velocities[0].y, 1) << "across the contact nothing changes";
  EXPECT_EQ(velocities[1].y, 2);
  EXPECT_EQ(velocities[2].x, 5) << "of no contact";
}

TEST(CommonVelocities, OfWhatIsJoinedToAWallAreNone) {
  const Bodies bodies{{{4, 1}, 1}, {{2, 2}, 1}};
  const Contacts contacts{{0, kWall, {1, 0}, 1}, {0, 1, {-1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  CommonVelocities<double> common(bodies, graph);
  common.join(0, 0);
  common.join(1, 0);
  Velocities velocities{{4, 1}, {2, 2}};
  common.give(velocities);
  EXPECT_EQ(velocities[0].x, 0);
  EXPECT_EQ(velocities[1].x, 0);
  EXPECT_EQ(velocities[0].y, 1);
}

TEST(KeptEnergy, ScalesTheMotionAboutTheCentreOfMass) {
  const Bodies bodies{{{3, 0}, 1}, {{1, 0}, 1}};
  const Contacts contacts{{0, 1, {1, 0}, 1}};
  const ContactGraph<double> graph(bodies, contacts);
  const Velocities start{{3, 0}, {1, 0}};
  Velocities velocities{{1.5, 0}, {2.5, 0}};  // about 2, a half where it was 1
  EXPECT_EQ(KeptEnergy<double>(bodies, graph).give_back(start, velocities), 0);
  EXPECT_EQ(velocities[0].x, 1);
  EXPECT_EQ(velocities[1].x, 3);
}

TEST(KeptEnergy, SendsBackWhatCanMoveNowhereOrHoldsItsEnergy) {
  const Bodies bodies{{{2, 0}, 1}};
  const Contacts wall{{0, kWall, {1, 0}, 1}};
  const ContactGraph<double> at_one_wall(bodies, wall);
  const Velocities start{{2, 0}};
  Velocities velocities{{0, 0}};
  EXPECT_EQ(KeptEnergy<double>(bodies, at_one_wall).give_back(start, velocities), 0);
  EXPECT_EQ(velocities[0].x, -2);
  const Contacts walls{{0, kWall, {1, 0}, 1}, {0, kWall, {-1, 0}, 1}};
  const ContactGraph<double> between(bodies, walls);
  velocities = {{0, 0}};
  EXPECT_EQ(KeptEnergy<double>(bodies, between).give_back(start, velocities), 2) << "m v^2 / 2";
  EXPECT_EQ(velocities[0].x, 0);
}

}  // namespace
}  // namespace carom::event
