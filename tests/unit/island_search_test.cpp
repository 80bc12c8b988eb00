#include "solvers/event/islands/island_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "contact/contact_graph.hpp"
#include "contact/rest_rules.hpp"
#include "support/island_balls.hpp"

namespace carom::event::island_search_test {
namespace {

using Island = FoundIsland<double>;
using Contacts = std::set<std::pair<Index, Index>>;

std::set<Index> members_of(const Island& island) {
  return {island.members.begin(), island.members.end()};
}

/// As (ball, partner), the lower first.
Contacts contacts_of(const Island& island) {
  Contacts all;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const Index a = island.members[static_cast<std::size_t>(c.a)];
    const Index b =
        c.b == kWall ? island.near[k].partner : island.members[static_cast<std::size_t>(c.b)];
    const bool added = all.insert({std::min(a, b), std::max(a, b)}).second;
    EXPECT_TRUE(added) << "twice: " << a << ' ' << b;
  }
  return all;
}

/// A lattice with holes of balls that are near some of their neighbours, and not near others; some
/// are fixed, some of no island.
void add_some(IslandBalls& balls, std::mt19937_64& random) {
  std::uniform_real_distribution<double> jitter(-0.005, 0.005);
  for (int k = 0; k < 64; ++k) {
    if (random() % 4 == 0) continue;
    const double x = 1.01 * (k % 8) + jitter(random);
    const int row = k / 8;
    const double y = 1.01 * row - 9.5 + 0.01 + jitter(random);
    if (random() % 8 == 0) {
      balls.add_fixed(x, y);
    } else {
      balls.add(x, y, 0, 0, random() % 8 == 0 ? 0 : kStepped);
    }
  }
}

// Held against a search over all pairs and the floor.
TEST(IslandSearch, FindsAllThatCanBeReachedOverNearContactsOfIslands) {
  std::mt19937_64 random(4);
  std::size_t most = 0;
  for (int round = 0; round < 40; ++round) {
    IslandBalls balls(island_rules(0.5, 0.5));
    add_some(balls, random);
    balls.begin();
    const auto n = static_cast<Index>(balls.disks.size());
    const auto is_near = [&](Index i, Index j) {
      const double x = balls.disks[i].x - balls.disks[j].x;
      const double y = balls.disks[i].y - balls.disks[j].y;
      return std::hypot(x, y) <= 1 + kNear;
    };
    for (Index first = 0; first < n; first += 5) {
      if (balls.motion.fixed(balls.disks[first])) continue;
      std::set<Index> members{first};
      Contacts contacts;
      for (bool more = true; more;) {
        more = false;
        for (const Index i : std::set<Index>(members)) {
          if (balls.disks[i].y + 9.5 <= kNear) contacts.insert({i, kWalls + 2});
          for (Index j = 0; j < n; ++j) {
            if (j == i || !is_near(i, j)) continue;
            const bool fixed = balls.motion.fixed(balls.disks[j]);
            const bool joins = balls.motion.in_island(balls.disks[j]);
            if (!fixed && joins) more = members.insert(j).second || more;
            if (fixed || members.count(j) != 0) contacts.insert({std::min(i, j), std::max(i, j)});
          }
        }
      }
      const Island island = balls.search.of_step({first}, 0, 0).front();
      EXPECT_EQ(members_of(island), members);
      EXPECT_EQ(contacts_of(island), contacts);
      most = std::max(most, members.size());
    }
  }
  EXPECT_GT(most, 20U);
}

TEST(IslandSearch, TellsTouchingGapsAndNormals) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(0, 0, 0, 0, kStepped, 2);
  balls.add(0.6, 0.8 + kTouching / 2);
  balls.add(-1 - 0x1p-8, 0);
  const Island island = balls.around(0);
  ASSERT_EQ(island.contacts.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const ConeContact& c = island.contacts[k];
    const Index other = island.members[static_cast<std::size_t>(std::max(c.a, c.b))];
    const bool touches = other == 1;
    EXPECT_EQ(island.touches[k] != 0, touches);
    EXPECT_NEAR(c.gap, touches ? 0 : 0x1p-8, 1e-9);
    const Vec<double> normal = island.members[static_cast<std::size_t>(c.a)] == 0
                                   ? c.normal
                                   : Vec<double>{-c.normal.x, -c.normal.y};
    EXPECT_NEAR(normal.x, touches ? 0.6 : -1, 1e-9);
    EXPECT_NEAR(normal.y, touches ? 0.8 : 0, 1e-9);
  }
  EXPECT_EQ(island.bodies[0].inverse_mass, 0.5);
}

// Its height has grown by 1/1024, at a weight of 2.
TEST(IslandSearch, PutsWhatIsInAWallOntoItAndTellsTheEnergy) {
  IslandBalls balls(island_rules(0.5, 0.5));
  balls.add(3, -9.5 - 0x1p-10, 0, 0, kStepped, 2);
  const Island island = balls.around(0);
  EXPECT_EQ(island.places[0].y, -9.5);
  EXPECT_EQ(island.lifted, 0x1p-9);
  ASSERT_EQ(island.contacts.size(), 1U);
  EXPECT_EQ(island.contacts[0].normal, (Vec<double>{0, -1}));
  EXPECT_EQ(island.contacts[0].gap, 0);
}

TEST(IslandSearch, TellsTheDeepestOverlap) {
  IslandBalls balls(island_rules(0.5, 0.5));
  for (int k = 0; k < 3; ++k) balls.add(k - 0x1p-6 * k * k, 0);
  EXPECT_NEAR(balls.around(0).deepest, 3 * 0x1p-6 / 0.5, 1e-12);  // of a radius
}

TEST(IslandSearch, HitsOfOneIslandAreOneAndOfOthersApart) {
  IslandBalls balls(island_rules(0.5, 0.5));
  for (int k = 0; k < 5; ++k) balls.add(k, 0);  // a row
  for (int k = 0; k < 2; ++k) balls.add(k, 5);  // another
  balls.add(0, 1, 0, -1, 0);                    // of none, as are those that follow
  balls.add(4, 1, 0, -1, 0);
  balls.add(-8, 8, 0, 0, 0);
  balls.add(-7, 8, 0, 0, 0);
  balls.begin();
  const auto islands = balls.search.of_hits({{7}, {5}, {8}, {9}, {10}}, 0);
  ASSERT_EQ(islands.size(), 3U);
  std::set<std::set<Index>> all;
  for (const Island& island : islands) all.insert(members_of(island));
  EXPECT_EQ(all, (std::set<std::set<Index>>{{0, 1, 2, 3, 4, 7, 8}, {5, 6}, {9, 10}}));
  // Later they are of none again.
  EXPECT_EQ(members_of(balls.search.of_step({9}, 0, 0).front()), (std::set<Index>{9}));
}

/// A square lattice of 12 by 12 balls that touch, numbered in this order, and one that comes from
/// above at a speed of 1, from 1/32 over it.
struct Lattice : IslandBalls {
  explicit Lattice(const std::vector<int>& order) : IslandBalls(island_rules(0.5, 0.5)) {
    for (const int k : order) {
      const int row = k / 12;
      add(k % 12 - 5, row - 5);
    }
    add(0, 7 + 0x1p-5, 0, -1, 0);
    begin();
  }
};

std::vector<int> in_order() {
  std::vector<int> order(144);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

TEST(IslandSearch, NumberingDoesNotChangeAnIslandOfManyContacts) {
  std::vector<int> order = in_order();
  Lattice first(order);
  const Island wanted = first.search.of_step({0}, 0, 0).front();
  ASSERT_EQ(wanted.contacts.size(), 2U * 12 * 11);
  std::mt19937_64 random(2);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    Lattice balls(order);
    const Island island = balls.search.of_step({static_cast<Index>(round)}, 0, 0).front();
    ASSERT_EQ(island.members.size(), wanted.members.size());
    for (std::size_t m = 0; m < island.places.size(); ++m) {
      EXPECT_EQ(island.places[m], wanted.places[m]);
      EXPECT_EQ(balls.disks[island.members[m]].x, island.places[m].x);
    }
    ASSERT_EQ(island.contacts.size(), wanted.contacts.size());
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      EXPECT_EQ(island.contacts[k].a, wanted.contacts[k].a);
      EXPECT_EQ(island.contacts[k].b, wanted.contacts[k].b);
      EXPECT_EQ(island.contacts[k].normal, wanted.contacts[k].normal);
      EXPECT_EQ(island.near[k].r, wanted.near[k].r);
    }
  }
}

TEST(IslandSearch, WhatFlightsAreCountedWithoutStaysWithItsBall) {
  std::vector<int> order = in_order();
  std::mt19937_64 random(3);
  std::shuffle(order.begin(), order.end(), random);
  Lattice balls(order);
  balls.left_out.resize(balls.disks.size());
  std::iota(balls.left_out.begin(), balls.left_out.end(), 0.0);
  const Island island = balls.search.of_step({0}, 0, 0).front();
  ASSERT_EQ(island.left_out.size(), 144U);
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    EXPECT_EQ(island.left_out[m], balls.left_out[island.members[m]]);
  }
}

// It falls through the gap in 1/32 of a second at a speed of 1, before the next step or after it.
TEST(IslandSearch, WhatComesToManyBeforeTheNextStepIsOfThem) {
  for (const double step : {0x1p-4, 0x1p-6}) {
    Lattice balls(in_order());
    balls.next_step = balls.motion.rules().scale.ticks(step);
    const bool comes = step > 0x1p-5;
    for (const bool hit : {true, false}) {
      const auto islands =
          hit ? balls.search.of_hits({{0}}, 0) : balls.search.of_step({0}, 0, balls.next_step);
      ASSERT_EQ(islands.size(), 1U);
      const Island& island = islands.front();
      EXPECT_EQ(members_of(island).count(144) == 1, comes);
      EXPECT_EQ(std::count_if(island.near.begin(), island.near.end(),
                              [](const Island::Near& near) { return near.comes; }),
                comes ? 1 : 0);
      for (std::size_t k = 0; k < island.contacts.size(); ++k) {
        if (!island.near[k].comes) continue;
        EXPECT_NEAR(island.contacts[k].gap, 0x1p-5, 1e-9);
      }
    }
  }
}

// It passes the corner ball at (6, 6): when they meet it is half a diameter beside it, at 60
// degrees, and until then it is farther away that way than it is from touching.
TEST(IslandSearch, WhatComesIsAsFarAwayAsItIsTheWayItWillBeThen) {
  Lattice balls(in_order());
  const Vec<double> then{6.5, 6 + std::sqrt(0.75)};
  const double age = 0x1p-6;
  const Index ball = balls.add(then.x - 3 * age, then.y + 2 * age + age * age / 2, 3, -2, 0);
  balls.begin();
  const auto islands = balls.search.of_step({0}, 0, balls.motion.rules().scale.ticks(2 * age));
  ASSERT_EQ(islands.size(), 1U);
  const Island& island = islands.front();
  ASSERT_EQ(members_of(island).count(ball), 1U);
  const auto is_of_it = [&](const ConeContact& c) {
    return c.b != kWall && (island.members[static_cast<std::size_t>(c.a)] == ball ||
                            island.members[static_cast<std::size_t>(c.b)] == ball);
  };
  ASSERT_EQ(std::count_if(island.contacts.begin(), island.contacts.end(), is_of_it), 1);
  const auto k = static_cast<std::size_t>(
      std::find_if(island.contacts.begin(), island.contacts.end(), is_of_it) -
      island.contacts.begin());
  EXPECT_TRUE(island.near[k].comes);
  const ConeContact& c = island.contacts[k];
  const double side = island.members[static_cast<std::size_t>(c.b)] == ball ? 1 : -1;
  EXPECT_NEAR(side * c.normal.x, 0.5, 1e-9);
  EXPECT_NEAR(side * c.normal.y, std::sqrt(0.75), 1e-9);
  EXPECT_NEAR(c.gap, std::sqrt(0.75) * (2 * age + age * age / 2) - 0.5 * 3 * age, 1e-9);
}

// The second is near to the first only; the third, which does not move, is farther away.
TEST(IslandSearch, WhatFliesNearToManyIsOfThemAndWhatIsNearToThat) {
  Lattice balls(in_order());
  balls.add(3, 7 + 0x1p-7, 0, 0, 0);
  balls.add(3, 8 + 0x1p-6, 0, 0, 0);
  balls.add(-3, 7 + 0x1p-4, 0, 0, 0);
  balls.begin();
  const FixedTime soon = balls.motion.rules().scale.ticks(0x1p-10);
  const std::set<Index> with = members_of(balls.search.of_step({0}, 0, soon).front());
  EXPECT_EQ(with.count(145) + with.count(146), 2U);
  EXPECT_EQ(with.count(147), 0U);
  EXPECT_EQ(members_of(balls.search.of_step({0}, 0, 0).front()).count(145), 0U);
}

// One flies to a fixed ball and the wall behind it, from 1/256 off both, the other away from them.
TEST(IslandSearch, WhatFliesNearToManyToWhatNeverMovesComesToIt) {
  for (const double speed : {1.0, -1.0}) {
    Lattice balls(in_order());
    // Four more lead from it to the corner of the lattice at (6, -5).
    const double lowest = -9.5 + 0x1p-8;
    const double up = (-5 - lowest) / 5;
    const double aside = std::sqrt((1 + 0x1p-8) * (1 + 0x1p-8) - up * up);
    const Index flies = balls.add(6 + aside, lowest, speed, -speed, 0);
    for (int k = 1; k < 5; ++k) balls.add(k % 2 == 0 ? 6 + aside : 6, lowest + k * up);
    const Index fixed = balls.add_fixed(7 + aside + 0x1p-8, lowest);
    balls.begin();
    const FixedTime soon = balls.motion.rules().scale.ticks(0x1p-6);
    const Island island = balls.search.of_step({0}, 0, soon).front();
    ASSERT_EQ(members_of(island).count(flies), 1U);
    int found = 0;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const Index partner = island.near[k].partner;
      if (island.members[static_cast<std::size_t>(island.contacts[k].a)] != flies) continue;
      if (island.contacts[k].b != kWall) continue;
      EXPECT_TRUE(partner == fixed || partner == kWalls + 2);
      EXPECT_EQ(island.near[k].comes, speed > 0) << partner;
      ++found;
    }
    EXPECT_EQ(found, 2);
  }
}

TEST(IslandSearch, WhatFliesNearToFewIsNotOfThem) {
  IslandBalls balls(island_rules(0.5, 0.5));
  for (int k = 0; k < 5; ++k) balls.add(k, 0);
  balls.add(2, 1 + 0x1p-7, 0, -1, 0);
  balls.begin();
  const FixedTime later = balls.motion.rules().scale.ticks(0x1p-4);
  EXPECT_EQ(members_of(balls.search.of_step({0}, 0, later).front()).size(), 5U);
}

// Two balls that are of another island are near to what flies near to many: found before or after.
TEST(IslandSearch, IslandsOfAStepHaveNoBallInCommon) {
  Lattice balls(in_order());
  balls.add(3, 7 + 0x1p-7, 0, 0, 0);
  const Index small = balls.add(3, 8 + 0x1p-6);
  balls.add(4, 8 + 0x1p-6);
  balls.begin();
  const FixedTime soon = balls.motion.rules().scale.ticks(0x1p-10);
  for (const bool first : {true, false}) {
    const std::vector<Index> of =
        first ? std::vector<Index>{small, 0} : std::vector<Index>{0, small};
    const auto islands = balls.search.of_step(of, 0, soon);
    ASSERT_EQ(islands.size(), 1U);
    EXPECT_EQ(islands.front().members.size(), 147U);
  }
}

}  // namespace
}  // namespace carom::event::island_search_test
