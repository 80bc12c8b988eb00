#include "solvers/event/touch_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/touch_search_body.hpp"
#include "support/predicted_balls.hpp"

namespace carom::event::touch_search_test {
namespace {

using Group = SimultaneousImpact<double>;

Rules box(double size) {
  Box box;
  box.width = size;
  box.height = size;
  box.origin = Box::Origin::center;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.restitution = 0.75;
  rules.wall_restitution = 0.5;
  rules.all_species = {{0.5, 1}, {0.5, 0}};  // the second ones are fixed
  return rules;
}

struct Place {
  double x;
  double y;
  bool fixed = false;
};

/// Balls of diameter 1 that stand still, around the middle of a box.
struct Balls : PredictedBalls {
  SimultaneousPairs pairs;
  JamLevel jam;
  TouchSearch<Ballistic> search{motion, {disks, spins, neighbours, prediction}, pairs, jam};

  explicit Balls(const std::vector<Place>& places, double size = 20) : PredictedBalls(box(size)) {
    for (const Place& place : places) {
      Disk disk;
      disk.x = place.x;
      disk.y = place.y;
      if (place.fixed) disk.species = 1;
      if (place.fixed) disk.start = kEver;
      disks.push_back(disk);
    }
    neighbours.reset(disks, 0);
    pairs.reset(disks.size());
  }
  [[nodiscard]] Group around(Index i) const {
    std::vector<Index> seeds{i};
    return search.from(seeds, 0);
  }
};

std::vector<Index> sorted(std::vector<Index> balls) {
  std::sort(balls.begin(), balls.end());
  return balls;
}

/// As (ball, partner) of its contacts, the lower first.
std::set<Pair> contacts_of(const Group& group) {
  std::set<Pair> all;
  group.each_contact([&](const Contact<double>&, Index i, Index partner) {
    const bool added = all.insert({std::min(i, partner), std::max(i, partner)}).second;
    EXPECT_TRUE(added) << "twice: " << i << ' ' << partner;
  });
  return all;
}

// Held against a search over all pairs that overlap or touch.
TEST(TouchSearch, FindsAllThatCanBeReachedOverContacts) {
  std::mt19937_64 random(6);
  for (int round = 0; round < 50; ++round) {
    std::vector<Place> places;
    for (int k = 0; k < 100; ++k) {
      if (random() % 3 == 0) continue;  // a lattice of distance 1 with holes
      const int row = k / 10;
      places.push_back(
          {static_cast<double>(k % 10) - 4.5, static_cast<double>(row) - 4.5, random() % 8 == 0});
    }
    Balls balls(places);
    for (Index first = 0; first < balls.disks.size(); first += 7) {
      std::set<Index> members{first};
      std::set<Pair> contacts;
      for (bool more = true; more;) {
        more = false;
        for (const Index i : std::set<Index>(members)) {
          if (places[i].fixed) continue;
          for (Index j = 0; j < places.size(); ++j) {
            const double dx = places[j].x - places[i].x;
            const double dy = places[j].y - places[i].y;
            if (j == i || dx * dx + dy * dy > 1) continue;
            more = members.insert(j).second || more;
            contacts.insert({std::min(i, j), std::max(i, j)});
          }
        }
      }
      const Group group = balls.around(first);
      EXPECT_EQ(sorted(group.members), std::vector<Index>(members.begin(), members.end()));
      EXPECT_EQ(contacts_of(group), contacts);
    }
  }
}

TEST(TouchSearch, TakesWhatItHasFoundFromTheSeeds) {
  const Balls balls({{0, 0}, {1, 0}, {5, 0}, {2, 0}});
  std::vector<Index> seeds{1, 2, 3};
  EXPECT_EQ(sorted(balls.search.from(seeds, 0).members), (std::vector<Index>{0, 1, 3}));
  EXPECT_EQ(seeds, (std::vector<Index>{2}));
}

TEST(TouchSearch, FindsWhatMeetsNowOrIsLinked) {
  Balls balls({{0, 0}, {1 + 0x1p-20, 0}, {0, 3}});
  EXPECT_EQ(balls.around(0).members.size(), 1U);
  balls.pairs.link({1, 0});
  balls.pairs.link({0, kWalls});
  balls.pairs.link({2, 0});
  const Group group = balls.around(0);
  EXPECT_EQ(sorted(group.members), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(contacts_of(group), (std::set<Pair>{{0, 1}, {0, 2}, {0, kWalls}}));
  ASSERT_EQ(group.stops.size(), 1U);
  EXPECT_TRUE(group.stops.front().meets);
}

TEST(TouchSearch, FindsWhatIsNearOnceItIsTakenAsJammed) {
  Balls balls({{0, 0}, {1 + 3 * kTouching, 0}, {-1 - 5 * kTouching, 0}, {9.5 - 3 * kTouching, 5}});
  const auto found = [&](Index i) { return balls.around(i).contacts.size(); };
  EXPECT_EQ(found(0), 0U);
  balls.jam.widen();
  balls.jam.widen();  // a gap of 2 kTouching
  EXPECT_EQ(found(0), 0U);
  balls.jam.widen();  // of 4
  EXPECT_EQ(found(0), 1U);
  EXPECT_EQ(found(3), 1U);
  EXPECT_FALSE(balls.around(3).stops.front().meets);
  balls.jam.widen();
  EXPECT_EQ(found(0), 2U);
}

TEST(TouchSearch, TellsHowContactsBounceUnlessTheJamGivesUp) {
  Balls balls({{0, 0}, {1, 0}, {9.5, 0}, {-9.5, -9.5}});
  EXPECT_EQ(balls.around(0).contacts.front().restitution, 0.75);
  const Group at_wall = balls.around(2);
  EXPECT_EQ(at_wall.contacts.front().restitution, 0.5);
  EXPECT_EQ(at_wall.contacts.front().r.x, 1);
  EXPECT_EQ(contacts_of(balls.around(3)), (std::set<Pair>{{3, kWalls}, {3, kWalls + 2}}));
  for (int k = 0; k <= kMostDoublings; ++k) balls.jam.widen();
  EXPECT_EQ(balls.around(0).contacts.front().restitution, 0);
  EXPECT_EQ(balls.around(2).contacts.front().restitution, 0);
}

}  // namespace
}  // namespace carom::event::touch_search_test
