#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/pair_impact.hpp"
#include "contact/rest_rules.hpp"
#include "support/random_numbers.hpp"
#include "trajectory/fixed_disk_time.hpp"
#include "trajectory/pair_time.hpp"
#include "trajectory/wall_time.hpp"

namespace carom::event::event_contact_rest_test {
namespace {

using V = Vec<double>;
using Contacts = std::vector<ConeContact>;

/// What a second of gravity would do to touching balls that are initially still.
struct Carried {
  std::vector<double> forces;
  ConeIsland::Bodies bodies;  ///< their velocities are accelerations

  bool holds_still() const {
    return std::all_of(bodies.begin(), bodies.end(), [](const ConeBody& body) {
      return std::abs(body.velocity.x) + std::abs(body.velocity.y) + std::abs(body.turning) < 1e-5;
    });
  }
};

Carried under(const V& gravity, const std::vector<double>& masses, const Contacts& contacts) {
  Carried result;
  for (const double mass : masses) result.bodies.push_back({gravity, 0, 1 / mass});
  result.forces = ConeIsland(result.bodies, contacts).resolve(result.bodies, 0, 1e-12);
  return result;
}

double resolution_at(double t) {
  return t * 0x1p-52;
}

TEST(EventRest, ABallDroppedOnAFloorRestsAtTheTextbookTime) {
  const double g = 9.81;
  for (const double e : {0.1, 0.5, 0.8, 0.95}) {
    double t = wall_time(1.0, 0.0, -g);
    double v = wall_impact(wall_arrival_velocity(1.0, 0.0, -g), e);
    int bounces = 0;
    while (!bounces_out(v, g, e, resolution_at(t))) {
      t += wall_time(0.0, v, -g);
      v = wall_impact(wall_arrival_velocity(0.0, v, -g), e);
      ASSERT_LT(++bounces, 1000);
    }
    const double truth = std::sqrt(2 / g) * (1 + e) / (1 - e);
    EXPECT_NEAR(t, truth, 1e-13 * truth) << e;
    if (e == 0.8) {
      EXPECT_NEAR(t, 4.06371, 5e-6);
    }
    EXPECT_LE(bounces, 10 + 37 / -std::log(e));
  }
}

TEST(EventRest, ABallDroppedOnTheTopOfAFixedBallRestsThereToo) {
  const double g = 9.81;
  const double e = 0.5;
  const V top{0, 1};
  auto t = fixed_disk_time<double>({0, 2}, {0, 0}, {0, -g}, 1);
  V v = pair_impact<double>(top, {0, 0}, {0, -g * t}, 0, 1, e).b;
  int bounces = 0;
  while (!bounces_out(v.y, g, e, resolution_at(t))) {
    const auto bounce = fixed_disk_time<double>(top, v, {0, -g}, 1, true);
    t += bounce;
    v = pair_impact<double>(top, {0, 0}, {0, v.y - g * bounce}, 0, 1, e).b;
    ASSERT_LT(++bounces, 100);
  }
  EXPECT_NEAR(t, std::sqrt(2 / g) * (1 + e) / (1 - e), 1e-12);
}

TEST(EventRest, BouncingThatLosesNothingNeverEnds) {
  EXPECT_FALSE(bounces_out(1e-300, 9.81, 1.0, 1.0));
  EXPECT_FALSE(bounces_out(1.0, 0.0, 0.5, 1.0));  // nothing presses
  EXPECT_TRUE(bounces_out(0.0, 9.81, 0.5, 1e-16));
}

TEST(EventRest, AHopOffAnElasticWallIsNoneWhereItIsAsShortAsAContact) {
  const double g = 9.81;
  const double s = 0.5;
  const double shortest = 0x1p-12 * std::sqrt(s / g);
  EXPECT_TRUE(barely_bounces(g * shortest / 2 * 0.99, g, s));
  EXPECT_FALSE(barely_bounces(g * shortest / 2 * 1.01, g, s));
  EXPECT_FALSE(barely_bounces(0.0, 0.0, s));  // nothing presses
}

TEST(EventIsland, AFloorCarriesAStackAndEachBallWhatIsAboveIt) {
  const auto result = under(
      {0, -10}, {2, 3, 5}, {{0, kWall, {0, -1}, 0, 0}, {0, 1, {0, 1}, 0, 0}, {1, 2, {0, 1}, 0, 0}});
  EXPECT_NEAR(result.forces[0], 100, 1e-4);
  EXPECT_NEAR(result.forces[1], 80, 1e-4);
  EXPECT_NEAR(result.forces[2], 50, 1e-4);
  EXPECT_TRUE(result.holds_still());
}

TEST(EventIsland, ABallInTheGapOfTwoFixedOnesIsCarriedByBoth) {
  const double c = std::sqrt(0.75);
  const Contacts contacts{{0, kWall, {-0.5, -c}, 0, 0}, {0, kWall, {0.5, -c}, 0, 0}};
  const auto result = under({0, -10}, {1}, contacts);
  EXPECT_NEAR(result.forces[0], 5 / c, 1e-6);
  EXPECT_EQ(result.forces[1], result.forces[0]);
  EXPECT_TRUE(result.holds_still());
  EXPECT_FALSE(under({10, 0}, {1}, contacts).holds_still());
}

TEST(EventIsland, ABallOnTheSideOfAFixedOneSlidesDownAlongIt) {
  const auto result = under({0, -10}, {1}, {{0, kWall, {-0.6, -0.8}, 0, 0}});
  EXPECT_NEAR(result.forces[0], 8, 1e-6);
  EXPECT_NEAR(result.bodies[0].velocity.x, 4.8, 1e-6);
  EXPECT_NEAR(result.bodies[0].velocity.y, -3.6, 1e-6);
}

// A disk of inertia m r^2 / 2 that rolls keeps a third of what drives it in its spin.
TEST(EventIsland, ABallThatRubsRollsDownASlope) {
  const auto result = under({0, -10}, {1}, {{0, kWall, {-0.6, -0.8}, 0, 0.5}});
  EXPECT_NEAR(result.bodies[0].velocity.x, 4.8 * 2 / 3, 1e-6);
  EXPECT_NEAR(result.bodies[0].velocity.y, -3.6 * 2 / 3, 1e-6);
  EXPECT_NEAR(std::abs(result.bodies[0].turning), 6 * 2.0 / 3, 1e-6);
}

// Friction lets a ball lie between two others that stand further apart than frictionless ones may.
TEST(EventIsland, AnArchOfThreeStandsWhereFrictionIsEnough) {
  const auto arch = [](double friction) {
    const double s = std::sin(0.4);
    const double c = std::cos(0.4);
    return under({0, -1}, {1, 1, 1},
                 {{0, kWall, {0, -1}, 0, friction},
                  {1, kWall, {0, -1}, 0, friction},
                  {2, 0, {-s, -c}, 0, friction},
                  {2, 1, {s, -c}, 0, friction}});
  };
  EXPECT_FALSE(arch(0).holds_still());
  EXPECT_FALSE(arch(0.1).holds_still());
  EXPECT_TRUE(arch(0.3).holds_still());  // tan(0.4 / 2) = 0.203
}

TEST(EventIsland, ACeilingDoesNotPull) {
  const auto result = under({0, -10}, {1}, {{0, kWall, {0, 1}, 0, 0}});
  EXPECT_EQ(result.forces[0], 0);
  EXPECT_EQ(result.bodies[0].velocity.y, -10);
}

/// Rows of 6 and 5 in turn between two walls that just fit: a triangular lattice.
Contacts lattice(std::size_t& count, double friction) {
  std::vector<V> place;
  for (int row = 0; row < 6; ++row) {
    for (int k = 0; k < 6 - row % 2; ++k) {
      place.push_back({k + 0.5 * (row % 2), row * std::sqrt(0.75)});
    }
  }
  count = place.size();
  Contacts contacts;
  for (int a = 0; a < static_cast<int>(count); ++a) {
    const V& p = place[static_cast<std::size_t>(a)];
    if (p.y == 0) contacts.push_back({a, kWall, {0, -1}, 0, friction});
    if (p.x == 0) contacts.push_back({a, kWall, {-1, 0}, 0, friction});
    if (p.x == 5) contacts.push_back({a, kWall, {1, 0}, 0, friction});
    for (int b = a + 1; b < static_cast<int>(count); ++b) {
      const V r = place[static_cast<std::size_t>(b)] - p;
      if (std::hypot(r.x, r.y) < 1.001) contacts.push_back({a, b, r, 0, friction});
    }
  }
  return contacts;
}

TEST(EventIsland, APileInABoxHoldsStillAndItsFloorCarriesItsWeight) {
  std::size_t count = 0;
  const Contacts contacts = lattice(count, 0);
  const auto result = under({0, -1}, std::vector<double>(count, 1), contacts);
  EXPECT_TRUE(result.holds_still());
  double floor = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_GE(result.forces[k], 0);
    if (contacts[k].b == kWall && contacts[k].normal.y < 0) floor += result.forces[k];
  }
  EXPECT_NEAR(floor, static_cast<double>(count), 1e-4);
}

// Fails where the impulses are not the least ones: doubled, they make energy.
TEST(EventIsland, ResolvingNeverMakesEnergyAndLeavesNothingApproaching) {
  for (const double friction : {0.0, 0.3}) {
    std::size_t count = 0;
    const Contacts contacts = lattice(count, friction);
    test::RandomNumbers random(5);
    for (int round = 0; round < 50; ++round) {
      ConeIsland::Bodies bodies;
      for (std::size_t k = 0; k < count; ++k) {
        bodies.push_back({{random.between(-1, 1), random.between(-1, 1)},
                          friction > 0 ? random.between(-1, 1) : 0,
                          random.between(0.5, 2)});
      }
      const auto energy = [&bodies] {
        double sum = 0;
        for (const ConeBody& b : bodies) {
          sum += (dot(b.velocity, b.velocity) + b.turning * b.turning / 2) / b.inverse_mass;
        }
        return sum;
      };
      const double before = energy();
      (void)ConeIsland(bodies, contacts).resolve(bodies, 0, 1e-6);
      EXPECT_LE(energy(), before);
      for (const ConeContact& c : contacts) {
        const V& a = bodies[static_cast<std::size_t>(c.a)].velocity;
        const V b = c.b == kWall ? V{0, 0} : bodies[static_cast<std::size_t>(c.b)].velocity;
        EXPECT_GT(dot(c.normal, b - a), -1e-3);  // what little they give way
      }
    }
  }
}

}  // namespace
}  // namespace carom::event::event_contact_rest_test
