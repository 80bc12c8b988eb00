#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "contact/joint_impact.hpp"
#include "support/exact_number.hpp"
#include "support/random_numbers.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event {
namespace {

using test::RandomNumbers;
using V = Vec<double>;

constexpr double kU = 0x1p-53;

struct Group {
  std::vector<Body<double>> bodies;
  std::vector<Contact<double>> contacts;

  JointReport resolve() {
    return joint_impact<double>(bodies, std::span<const Contact<double>>(contacts));
  }
};

double energy(const Group& group) {
  double sum = 0;
  for (const auto& body : group.bodies) {
    if (body.inverse_mass == 0) continue;
    sum += (body.velocity.x * body.velocity.x + body.velocity.y * body.velocity.y) /
           body.inverse_mass / 2;
  }
  return sum;
}

V momentum(const Group& group) {
  V sum{0, 0};
  for (const auto& body : group.bodies) {
    sum = sum + (1 / body.inverse_mass) * body.velocity;
  }
  return sum;
}

bool approaches(const Group& group) {
  return std::any_of(group.contacts.begin(), group.contacts.end(), [&](const auto& c) {
    const auto& a = group.bodies[static_cast<std::size_t>(c.a)];
    const auto b =
        c.b == kWall ? Body<double>{{0, 0}, 0} : group.bodies[static_cast<std::size_t>(c.b)];
    return a.inverse_mass + b.inverse_mass > 0 && sharp_dot(c.r, b.velocity - a.velocity) < 0;
  });
}

Group cradle(int n, int striking, double e) {
  Group group;
  for (int k = 0; k < n; ++k) {
    group.bodies.push_back({{k < striking ? 0.7 : 0.0, 0}, 1 / 0.3});
    if (k > 0) group.contacts.push_back({k - 1, k, {1, 0}, e});
  }
  return group;
}

TEST(EventJointImpact, ACradlePassesExactlyAsManyBallsOnAsStrike) {
  for (int n = 2; n <= 12; ++n) {
    for (int striking = 1; striking < n; ++striking) {
      Group group = cradle(n, striking, 1);
      const auto report = group.resolve();
      for (int k = 0; k < n; ++k) {
        const double expected = k >= n - striking ? 0.7 : 0;
        EXPECT_EQ(group.bodies[static_cast<std::size_t>(k)].velocity.x, expected) << n << k;
        EXPECT_EQ(group.bodies[static_cast<std::size_t>(k)].velocity.y, 0);
      }
      EXPECT_EQ(report.impacts, striking * (n - striking));
      EXPECT_EQ(report.locked, 0);
    }
  }
}

TEST(EventJointImpact, ACradleStruckFromBothEndsSendsBothBack) {
  Group group = cradle(5, 1, 1);
  group.bodies[4].velocity.x = -0.7;
  group.resolve();
  const double expected[] = {-0.7, 0, 0, 0, 0.7};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(group.bodies[k].velocity.x, expected[k], 1e-15);
}

TEST(EventJointImpact, ACornerReversesABallExactly) {
  for (const double e : {1.0, 0.5}) {
    Group group;
    group.bodies.push_back({{0.3, 0.7}, 2});
    group.contacts = {{0, kWall, {1, 0}, e}, {0, kWall, {0, 1}, e}};
    group.resolve();
    EXPECT_EQ(group.bodies[0].velocity.x, -e * 0.3);
    EXPECT_EQ(group.bodies[0].velocity.y, -e * 0.7);
  }
}

TEST(EventJointImpact, ABallPinchedBetweenTwoHeavyOnesThrowsThemBack) {
  // two equal balls close in on a third between them: by symmetry they reverse
  Group group;
  group.bodies = {{{1, 0}, 1}, {{0, 0}, 1}, {{-1, 0}, 1}};
  group.contacts = {{0, 1, {1, 0}, 1}, {1, 2, {1, 0}, 1}};
  group.resolve();
  EXPECT_NEAR(group.bodies[0].velocity.x, -1, 1e-15);
  EXPECT_EQ(group.bodies[1].velocity.x, 0);
  EXPECT_NEAR(group.bodies[2].velocity.x, 1, 1e-15);
}

TEST(EventJointImpact, ABallInTheGapOfTwoDrivesThemApartAsTheBookSays) {
  // cue along x onto two touching balls at 30 degrees to either side: each gets 2 sqrt(3)/5 v along
  // its normal, the cue -1/5 v
  Group group;
  const double c = std::sqrt(0.75);
  group.bodies = {{{1, 0}, 1}, {{0, 0}, 1}, {{0, 0}, 1}};
  group.contacts = {{0, 1, {c, 0.5}, 1}, {0, 2, {c, -0.5}, 1}, {1, 2, {0, -1}, 1}};
  group.resolve();
  EXPECT_NEAR(group.bodies[0].velocity.x, -0.2, 4e-16);
  EXPECT_EQ(group.bodies[0].velocity.y, 0);
  EXPECT_NEAR(group.bodies[1].velocity.x, 0.6, 4e-16);
  EXPECT_NEAR(group.bodies[1].velocity.y, 2 * std::sqrt(3) / 5 / 2, 4e-16);
  EXPECT_EQ(group.bodies[2].velocity.x, group.bodies[1].velocity.x);
  EXPECT_EQ(group.bodies[2].velocity.y, -group.bodies[1].velocity.y);
}

/// Balls on a triangular lattice, rows of 1, 2, 3 ... behind a cue ball on the axis y = 0.
struct Rack {
  Group group;
  std::vector<V> place;

  Rack(int rows, double e) {
    place.push_back({-1, 0});
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k <= row; ++k) place.push_back({row * std::sqrt(0.75), k - row / 2.0});
    }
    for (const V& p : place) group.bodies.push_back({{0, 0}, 1 + 0.1 * std::abs(p.y)});
    group.bodies[0] = {{1, 0}, 1};
    for (int a = 0; a < static_cast<int>(place.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(place.size()); ++b) {
        const V r = place[static_cast<std::size_t>(b)] - place[static_cast<std::size_t>(a)];
        if (std::hypot(r.x, r.y) < 1.001) group.contacts.push_back({a, b, r, e});
      }
    }
  }
};

/// The same group with its bodies and contacts in another order and some contacts seen from the
/// other side.
Group shuffled(const Group& group, std::vector<std::size_t>& where, RandomNumbers& random) {
  where.resize(group.bodies.size());
  std::iota(where.begin(), where.end(), 0);
  for (std::size_t k = where.size(); k > 1; --k) {
    std::swap(where[k - 1], where[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
  }
  Group result = group;
  for (std::size_t k = 0; k < where.size(); ++k) result.bodies[where[k]] = group.bodies[k];
  for (auto& c : result.contacts) {
    c.a = static_cast<int>(where[static_cast<std::size_t>(c.a)]);
    if (c.b == kWall) continue;
    c.b = static_cast<int>(where[static_cast<std::size_t>(c.b)]);
    if (random.below(2) == 0) c = {c.b, c.a, -c.r, c.restitution};
  }
  for (std::size_t k = result.contacts.size(); k > 1; --k) {
    std::swap(result.contacts[k - 1],
              result.contacts[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
  }
  return result;
}

TEST(EventJointImpact, ARackStaysMirroredToTheLastBitInAnyOrderOfItsBalls) {
  RandomNumbers random(1);
  for (const double e : {1.0, 0.9, 0.3}) {
    Rack rack(5, e);
    Group first = rack.group;
    const auto report = first.resolve();
    EXPECT_EQ(report.locked, 0);
    EXPECT_FALSE(approaches(first));
    if (e == 1) {
      EXPECT_NEAR(energy(first), energy(rack.group), 1e-13 * energy(rack.group));
    }
    if (e < 1) {
      EXPECT_LT(energy(first), energy(rack.group));
    }
    for (std::size_t a = 0; a < rack.place.size(); ++a) {
      for (std::size_t b = 0; b < rack.place.size(); ++b) {
        if (rack.place[a].x != rack.place[b].x || rack.place[a].y != -rack.place[b].y) continue;
        EXPECT_EQ(first.bodies[a].velocity.x, first.bodies[b].velocity.x);
        EXPECT_EQ(first.bodies[a].velocity.y, -first.bodies[b].velocity.y);
      }
    }
    for (int n = 0; n < 10; ++n) {
      std::vector<std::size_t> where;
      Group other = shuffled(rack.group, where, random);
      other.resolve();
      for (std::size_t k = 0; k < where.size(); ++k) {
        EXPECT_EQ(other.bodies[where[k]].velocity, first.bodies[k].velocity);
      }
    }
  }
}

/// A patch of a triangular lattice with random places taken out, random masses, velocities, walls
/// and fixed balls.
enum class Held { kNowhere, kByTwoWalls, kByWallsAndFixedBalls };

Group random_group(RandomNumbers& random, Held held) {
  std::vector<V> place;
  for (int row = 0; row < 5; ++row) {
    for (int k = 0; k < 5; ++k) {
      if (random.below(4) > 0) place.push_back({k + 0.5 * (row % 2), row * std::sqrt(0.75)});
    }
  }
  Group group;
  const double spread = random.below(2) == 0 ? 0 : 5;
  for (std::size_t k = 0; k < place.size(); ++k) {
    const bool fixed = held == Held::kByWallsAndFixedBalls && random.below(12) == 0;
    const double mass = std::exp(random.between(-spread, spread));
    const bool resting = random.below(2) == 0;
    V v{random.between(-1, 1), random.between(-1, 1)};
    if (fixed || resting) v = {0, 0};
    group.bodies.push_back({v, fixed ? 0 : 1 / mass});
  }
  const double e = random.below(2) == 0 ? 1 : random.between(0, 1);
  for (int a = 0; a < static_cast<int>(place.size()); ++a) {
    const V& p = place[static_cast<std::size_t>(a)];
    if (held != Held::kNowhere && p.y == 0) group.contacts.push_back({a, kWall, {0, -1}, e});
    if (held != Held::kNowhere && p.x == 0) group.contacts.push_back({a, kWall, {-0.5, 0}, e});
    for (int b = a + 1; b < static_cast<int>(place.size()); ++b) {
      const V r = place[static_cast<std::size_t>(b)] - p;
      if (std::hypot(r.x, r.y) < 1.001) group.contacts.push_back({a, b, r, e});
    }
  }
  return group;
}

TEST(EventJointImpact, OfRandomGroupsEndsWithNothingApproachingAndNoEnergyMade) {
  RandomNumbers random(2);
  for (int n = 0; n < 40; ++n) {
    const Held held = n % 2 == 0 ? Held::kNowhere : Held::kByTwoWalls;
    const Group before = random_group(random, held);
    if (before.contacts.empty()) continue;
    Group group = before;
    const auto report = group.resolve();
    EXPECT_FALSE(approaches(group)) << n;
    EXPECT_EQ(report.locked, 0) << n;
    EXPECT_LE(report.settling, 2) << n;
    const double was = energy(before);
    if (before.contacts[0].restitution == 1) {
      EXPECT_NEAR(energy(group), was, 1e-13 * was) << n;
    } else {
      EXPECT_LE(energy(group), was * (1 + 1e-13)) << n;
    }
    if (held != Held::kNowhere) continue;
    const V moved = momentum(group) - momentum(before);
    double scale = 0;  // the momenta that went through the group
    for (const auto& body : before.bodies) scale += std::sqrt(2 * was / body.inverse_mass);
    EXPECT_LE(std::abs(moved.x), 64 * kU * scale) << n;
    EXPECT_LE(std::abs(moved.y), 64 * kU * scale) << n;
  }
}

TEST(EventJointImpact, OfWedgedBallsEndsTooThoughTheyWouldBounceForEver) {
  Group wedged;  // between two fixed balls that leave no room
  wedged.bodies = {{{0.3, 0.4}, 1}, {{0, 0}, 0}, {{0, 0}, 0}};
  wedged.contacts = {{0, 1, {0.6, 0.8}, 1}, {0, 2, {-0.6, -0.8}, 1}};
  wedged.resolve();
  EXPECT_FALSE(approaches(wedged));
  EXPECT_LE(energy(wedged), 1e-30);

  Group between_walls;  // as tall as its box: it glides on with all its energy
  between_walls.bodies = {{{0.3, 0.4}, 1}};
  between_walls.contacts = {{0, kWall, {0, 1}, 1}, {0, kWall, {0, -1}, 1}};
  between_walls.resolve();
  EXPECT_NEAR(between_walls.bodies[0].velocity.x, 0.5, 1e-15);
  EXPECT_EQ(between_walls.bodies[0].velocity.y, 0);

  RandomNumbers random(5);
  for (int n = 0; n < 3; ++n) {
    const Group before = random_group(random, Held::kByWallsAndFixedBalls);
    Group group = before;
    group.resolve();
    EXPECT_FALSE(approaches(group)) << n;
    EXPECT_LE(energy(group), energy(before) * (1 + 1e-13)) << n;
  }
}

TEST(EventJointImpact, OfRandomGroupsDoesNotSeeOrderMirrorsOrAxes) {
  RandomNumbers random(3);
  for (int n = 0; n < 16; ++n) {
    const Group before = random_group(random, static_cast<Held>(n % 2));
    Group plain = before;
    plain.resolve();
    std::vector<std::size_t> where;
    Group other = shuffled(before, where, random);
    Group mirrored = before;
    Group swapped = before;
    for (auto& body : mirrored.bodies) body.velocity.x = -body.velocity.x;
    for (auto& c : mirrored.contacts) c.r.x = -c.r.x;
    for (auto& body : swapped.bodies) std::swap(body.velocity.x, body.velocity.y);
    for (auto& c : swapped.contacts) std::swap(c.r.x, c.r.y);
    other.resolve();
    mirrored.resolve();
    swapped.resolve();
    for (std::size_t k = 0; k < where.size(); ++k) {
      const V v = plain.bodies[k].velocity;
      ASSERT_EQ(other.bodies[where[k]].velocity, v) << n;
      ASSERT_EQ(mirrored.bodies[k].velocity, (V{-v.x, v.y})) << n;
      ASSERT_EQ(swapped.bodies[k].velocity, (V{v.y, v.x})) << n;
    }
  }
}

TEST(EventJointImpact, BetweenAWallAndAHeavyBallCountsThePiBilliard) {
  const int expected[] = {3, 31, 314, 3141};
  for (int k = 0; k < 4; ++k) {
    Group group;
    group.bodies = {{{0, 0}, 1}, {{-1, 0}, std::pow(100.0, -k)}};
    group.contacts = {{0, kWall, {-1, 0}, 1}, {0, 1, {1, 0}, 1}};
    const auto report = group.resolve();
    EXPECT_EQ(report.impacts + report.walls, expected[k]);
    EXPECT_EQ(report.walls, expected[k] / 2);  // in turn, the balls first
    EXPECT_NEAR(energy(group), std::pow(100.0, k) / 2, 1e-12 * std::pow(100.0, k));
  }
}

// A ball that lies in a corner and is hit: it has two impacts, with the walls, and stays.
TEST(EventJointImpact, CountsTheWallsOfACornerApart) {
  const double s = std::sqrt(0.5);
  Group group;
  group.bodies = {{{0, 0}, 1}, {{-1, -1}, 1}};
  group.contacts = {{0, kWall, {-1, 0}, 1}, {0, kWall, {0, -1}, 1}, {0, 1, {s, s}, 1}};
  const auto report = group.resolve();
  EXPECT_EQ(group.bodies[0].velocity, (V{0, 0}));
  EXPECT_EQ(group.bodies[1].velocity, (V{1, 1}));
  EXPECT_EQ(report.impacts, 2);
  EXPECT_EQ(report.walls, 2);
}

TEST(EventJointImpact, InAHundredDigitsKeepsTheRacksEnergyToAllOfThem) {
  using test::Exact;
  const Rack rack(4, 1);
  std::vector<Body<Exact>> bodies;
  std::vector<Contact<Exact>> contacts;
  for (const auto& b : rack.group.bodies) {
    bodies.push_back({{Exact(b.velocity.x), Exact(b.velocity.y)}, Exact(b.inverse_mass)});
  }
  for (const auto& c : rack.group.contacts) {
    contacts.push_back({c.a, c.b, {Exact(c.r.x), Exact(c.r.y)}, Exact(1)});
  }
  Group twin = rack.group;
  twin.resolve();
  joint_impact(std::span<Body<Exact>>(bodies), std::span<const Contact<Exact>>(contacts));
  Exact sum = 0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto& v = bodies[k].velocity;
    sum += (v.x * v.x + v.y * v.y) / bodies[k].inverse_mass / 2;
    EXPECT_LE(abs(v.x - twin.bodies[k].velocity.x), 1e-14);
    EXPECT_LE(abs(v.y - twin.bodies[k].velocity.y), 1e-14);
  }
  EXPECT_LE(abs(sum - Exact(0.5)), Exact("1e-97"));
}

TEST(EventJointImpact, AnInelasticGroupMovesOnAsOne) {
  Group group = cradle(8, 1, 0);
  const auto report = group.resolve();
  EXPECT_FALSE(approaches(group));
  EXPECT_NEAR(momentum(group).x, 0.3 * 0.7, 1e-15);
  for (const auto& body : group.bodies) EXPECT_NEAR(body.velocity.x, 0.7 / 8, 1e-15);
  EXPECT_EQ(report.rounds, 1);
  EXPECT_EQ(report.impacts, 7);
  EXPECT_EQ(report.locked, 0);
}

}  // namespace
}  // namespace carom::event
