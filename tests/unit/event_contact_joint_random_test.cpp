// Joint impacts of racks and of groups drawn at random: what holds for all of them, and for any
// order of their balls.
#include <gtest/gtest.h>

#include <numeric>
#include <utility>
#include <vector>

#include "support/joint_group.hpp"
#include "support/random_numbers.hpp"

namespace carom::event::event_contact_joint_random_test {
namespace {

using test::approaches;
using test::energy;
using test::Group;
using test::momentum;
using test::Rack;
using test::RandomNumbers;
using test::V;

constexpr double kU = 0x1p-53;

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

}  // namespace
}  // namespace carom::event::event_contact_joint_random_test
