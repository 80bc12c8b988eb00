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

namespace carom::event {
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
      const Island island = balls.search.around(first, 0);
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
  EXPECT_EQ(members_of(balls.search.around(9, 0)), (std::set<Index>{9}));
}

/// A square lattice of 12 by 12 balls that touch, numbered in this order, and one that comes from
/// above at a speed of 1, from 1/128 over it.
struct Lattice : IslandBalls {
  explicit Lattice(const std::vector<int>& order) : IslandBalls(island_rules(0.5, 0.5)) {
    for (const int k : order) {
      const int row = k / 12;
      add(k % 12 - 5, row - 5);
    }
    add(0, 7 + 0x1p-7, 0, -1, 0);
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
  const Island wanted = first.search.around(0, 0);
  ASSERT_EQ(wanted.contacts.size(), 2U * 12 * 11);
  std::mt19937_64 random(2);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    Lattice balls(order);
    const Island island = balls.search.around(static_cast<Index>(round), 0);
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

// It falls through the gap in 1/128 of a second at a speed of 1, before the next step or after it.
TEST(IslandSearch, WhatComesToManyBeforeTheNextStepIsOfTheHit) {
  for (const double step : {0x1p-6, 0x1p-8}) {
    Lattice balls(in_order());
    balls.next_step = balls.motion.rules().scale.ticks(step);
    const bool comes = step > 0x1p-7;
    const auto islands = balls.search.of_hits({{0}}, 0);
    ASSERT_EQ(islands.size(), 1U);
    const Island& island = islands.front();
    EXPECT_EQ(members_of(island).count(144) == 1, comes);
    EXPECT_EQ(std::count_if(island.near.begin(), island.near.end(),
                            [](const Island::Near& near) { return near.comes; }),
              comes ? 1 : 0);
    EXPECT_EQ(members_of(balls.search.around(0, 0)).count(144), 0U);  // only hits look ahead
  }
}

}  // namespace
}  // namespace carom::event
