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

/// Balls of radius 0.5 on a line, hit pair by pair, and jointly where they collapse.
struct Line {
  std::vector<double> x;
  std::vector<double> v;
  double e;
  double clock = 0;
  int impacts = 0;
  int joint = 0;

  void run() {
    std::vector<double> last(x.size() - 1, -1);
    while (impacts < 100000) {
      auto soonest = never<double>();
      std::size_t hit = 0;
      for (std::size_t k = 0; k + 1 < x.size(); ++k) {
        const auto t = pair_time<double>({x[k + 1] - x[k], 0}, {v[k + 1] - v[k], 0}, 1);
        if (t >= soonest) continue;
        soonest = t;
        hit = k;
      }
      if (soonest == never<double>()) return;
      for (std::size_t k = 0; k < x.size(); ++k) x[k] += v[k] * soonest;
      clock += soonest;
      ++impacts;
      const bool again = last[hit] >= 0 && collapses(e, clock - last[hit], resolution_at(clock));
      last[hit] = clock;
      if (again) {
        collapse(last);
      } else {
        const auto after =
            pair_impact<double>({x[hit + 1] - x[hit], 0}, {v[hit], 0}, {v[hit + 1], 0}, 1, 1, e);
        v[hit] = after.a.x;
        v[hit + 1] = after.b.x;
      }
    }
  }

  void collapse(const std::vector<double>& last) {
    ++joint;
    Bodies bodies;
    Contacts contacts;
    for (const double speed : v) bodies.push_back({{speed, 0}, 1});
    for (std::size_t k = 0; k < last.size(); ++k) {
      if (last[k] < 0 || clock - last[k] > resolution_at(clock)) continue;
      contacts.push_back({static_cast<int>(k), static_cast<int>(k) + 1, {x[k + 1] - x[k], 0}, 0});
    }
    joint_impact(std::span<Body<double>>(bodies), std::span<const Contact<double>>(contacts));
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = bodies[k].velocity.x;
  }
};

TEST(EventRest, LinesOfBallsThatCollapseEndInFewImpactsWithTheirMomentum) {
  test::RandomNumbers random(1);
  for (const int n : {3, 4, 5, 6, 10, 20}) {
    const double limit =
        n == 3 ? 7 - 4 * std::sqrt(3.0) : std::pow(std::tan(std::atan(1.0) * (1 - 2.0 / n)), 2);
    int collapsed = 0;
    for (int sample = 0; sample < 20; ++sample) {
      Line line{{}, {}, limit * random.between(0.05, 0.98)};
      double place = 0;
      double before = 0;
      for (int k = 0; k < n; ++k) {
        line.x.push_back(place);
        place += 1 + random.between(0.01, 1);
        line.v.push_back((2 * k < n ? 1 : -1) * random.between(0.5, 1));
        before += line.v.back();
      }
      line.run();
      EXPECT_LT(line.impacts, 400 * n) << n << " joint " << line.joint << " e " << line.e;
      collapsed += line.joint > 0 ? 1 : 0;
      double after = 0;
      for (const double speed : line.v) after += speed;
      EXPECT_NEAR(after, before, 1e-14 * n) << n;
      for (int k = 0; k + 1 < n; ++k) {
        const auto at = static_cast<std::size_t>(k);
        EXPECT_GT(line.x[at + 1] - line.x[at], 1 - 1e-12);
      }
    }
    EXPECT_GT(collapsed, 5) << n;
  }
}

TEST(EventRest, AHopIsHitWithoutLossAndABounceWithIt) {
  const double hop = hop_time(1.0, 9.81);
  EXPECT_EQ(restitution_of_a_hop(0.3, hop / 2, hop), 1);
  EXPECT_EQ(restitution_of_a_hop(0.3, hop * 2, hop), 0.3);
  EXPECT_EQ(hop_time(4.0, 1.0), 0x1p-9);
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
