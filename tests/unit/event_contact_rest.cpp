#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "contact/event_impulse.hpp"
#include "contact/event_joint_impact.hpp"
#include "contact/event_pair_time.hpp"
#include "contact/event_peg_time.hpp"
#include "contact/event_reactions.hpp"
#include "contact/event_rest.hpp"
#include "contact/event_wall_time.hpp"
#include "support/random_numbers.hpp"

namespace carom::event {
namespace {

using V = Vec<double>;
using Bodies = std::vector<Body<double>>;
using Contacts = std::vector<Contact<double>>;

Reactions<double> under(const Bodies& bodies, const Contacts& contacts, const V& gravity) {
  return reactions(std::span<const Body<double>>(bodies),
                   std::span<const Contact<double>>(contacts), gravity);
}

double resolution_at(double t) {
  return t * 0x1p-52;
}

TEST(EventRest, ABallDroppedOnAFloorRestsAtTheTextbookTime) {
  const double g = 9.81;
  for (const double e : {0.1, 0.5, 0.8, 0.95}) {
    double t = wall_time(1.0, 0.0, -g);
    double v = wall_impact(wall_arrival_velocity(1.0, 0.0, -g), e);
    int hops = 0;
    while (!bounces_out(v, g, e, resolution_at(t))) {
      t += wall_time(0.0, v, -g);
      v = wall_impact(wall_arrival_velocity(0.0, v, -g), e);
      ASSERT_LT(++hops, 1000);
    }
    const double truth = std::sqrt(2 / g) * (1 + e) / (1 - e);
    EXPECT_NEAR(t, truth, 1e-13 * truth) << e;
    if (e == 0.8) {
      EXPECT_NEAR(t, 4.06371, 5e-6);
    }
    EXPECT_LE(hops, 10 + 37 / -std::log(e));
  }
}

TEST(EventRest, ABallDroppedOnTheTopOfAFixedBallRestsThereToo) {
  const double g = 9.81;
  const double e = 0.5;
  const V top{0, 1};
  auto t = peg_time<double>({0, 2}, {0, 0}, {0, -g}, 1);
  V v = pair_impact<double>(top, {0, 0}, {0, -g * t}, 0, 1, e).b;
  int hops = 0;
  while (!bounces_out(v.y, g, e, resolution_at(t))) {
    const auto hop = peg_time<double>(top, v, {0, -g}, 1, true);
    t += hop;
    v = pair_impact<double>(top, {0, 0}, {0, v.y - g * hop}, 0, 1, e).b;
    ASSERT_LT(++hops, 100);
  }
  EXPECT_NEAR(t, std::sqrt(2 / g) * (1 + e) / (1 - e), 1e-12);
}

TEST(EventRest, BouncingThatLosesNothingNeverEnds) {
  EXPECT_FALSE(bounces_out(1e-300, 9.81, 1.0, 1.0));
  EXPECT_FALSE(bounces_out(1.0, 0.0, 0.5, 1.0));  // nothing presses
  EXPECT_TRUE(bounces_out(0.0, 9.81, 0.5, 1e-16));
}

TEST(EventReactions, AFloorCarriesAStackAndEachBallWhatIsAboveIt) {
  const Bodies bodies{{{0, 0}, 1 / 2.0}, {{0, 0}, 1 / 3.0}, {{0, 0}, 1 / 5.0}};
  const Contacts contacts{{0, kWall, {0, -1}, 0}, {0, 1, {0, 1}, 0}, {1, 2, {0, 1}, 0}};
  const V g{0, -10};
  const auto result = under(bodies, contacts, g);
  EXPECT_NEAR(result.forces[0], 100, 1e-12);
  EXPECT_NEAR(result.forces[1], 80, 1e-12);
  EXPECT_NEAR(result.forces[2], 50, 1e-12);
  EXPECT_TRUE(holds_still(result, g));
}

TEST(EventReactions, ABallInTheGapOfTwoFixedOnesRestsOnBoth) {
  const double c = std::sqrt(0.75);
  const Bodies bodies{{{0, 0}, 1}, {{0, 0}, 0}, {{0, 0}, 0}};
  const Contacts contacts{{0, 1, {-0.5, -c}, 0}, {0, 2, {0.5, -c}, 0}};
  const V g{0, -10};
  const auto result = under(bodies, contacts, g);
  EXPECT_NEAR(result.forces[0], 5 / c, 1e-13);
  EXPECT_EQ(result.forces[1], result.forces[0]);
  EXPECT_TRUE(holds_still(result, g));
  EXPECT_FALSE(holds_still(under(bodies, contacts, V{10, 0}), V{10, 0}));
}

TEST(EventReactions, ABallOnTheSideOfAFixedOneSlidesDownAlongIt) {
  const Bodies bodies{{{0, 0}, 1}, {{0, 0}, 0}};
  const Contacts contacts{{1, 0, {0.6, 0.8}, 0}};
  const auto result = under(bodies, contacts, V{0, -10});
  EXPECT_NEAR(result.forces[0], 8, 1e-14);
  EXPECT_NEAR(result.accelerations[0].x, 4.8, 1e-14);
  EXPECT_NEAR(result.accelerations[0].y, -3.6, 1e-14);
  EXPECT_FALSE(holds_still(result, V{0, -10}));
}

TEST(EventReactions, ABallFastEnoughOverTheTopFliesOff) {
  const Contacts contacts{{1, 0, {0, 2}, 0}};
  const V g{0, -10};
  EXPECT_NEAR(under({{{4, 0}, 1}, {{0, 0}, 0}}, contacts, g).forces[0], 2, 1e-14);  // g - v^2 / |r|
  EXPECT_EQ(under({{{5, 0}, 1}, {{0, 0}, 0}}, contacts, g).forces[0], 0);
}

TEST(EventReactions, ACeilingDoesNotPull) {
  const auto result = under({{{0, 0}, 1}}, {{0, kWall, {0, 1}, 0}}, V{0, -10});
  EXPECT_EQ(result.forces[0], 0);
  EXPECT_EQ(result.accelerations[0].y, -10);
}

TEST(EventReactions, APileInABoxHoldsStillAndItsFloorCarriesItsWeight) {
  // rows of 6 and 5 in turn between two walls that just fit; a triangular lattice
  Bodies bodies;
  std::vector<V> place;
  for (int row = 0; row < 6; ++row) {
    for (int k = 0; k < 6 - row % 2; ++k) {
      place.push_back({k + 0.5 * (row % 2), row * std::sqrt(0.75)});
      bodies.push_back({{0, 0}, 1});
    }
  }
  Contacts contacts;
  for (int a = 0; a < static_cast<int>(place.size()); ++a) {
    const V& p = place[static_cast<std::size_t>(a)];
    if (p.y == 0) contacts.push_back({a, kWall, {0, -1}, 0});
    if (p.x == 0) contacts.push_back({a, kWall, {-1, 0}, 0});
    if (p.x == 5) contacts.push_back({a, kWall, {1, 0}, 0});
    for (int b = a + 1; b < static_cast<int>(place.size()); ++b) {
      const V r = place[static_cast<std::size_t>(b)] - p;
      if (std::hypot(r.x, r.y) < 1.001) contacts.push_back({a, b, r, 0});
    }
  }
  const V g{0, -1};
  const auto result = under(bodies, contacts, g);
  EXPECT_TRUE(holds_still(result, g));
  double floor = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_GE(result.forces[k], 0);
    if (contacts[k].b == kWall && contacts[k].r.y < 0) floor += result.forces[k];
  }
  EXPECT_NEAR(floor, static_cast<double>(bodies.size()), 1e-10);
}

}  // namespace
}  // namespace carom::event
