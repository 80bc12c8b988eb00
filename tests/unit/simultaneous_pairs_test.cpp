#include "solvers/event/simultaneous_pairs.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace carom::event::simultaneous_pairs_test {
namespace {

using Pairs = std::vector<Pair>;

struct Instant : ::testing::Test {
  SimultaneousPairs pairs;
  Instant() { pairs.reset(10); }
};

TEST_F(Instant, KnowsPairsInEitherOrder) {
  pairs.link({1, 2});
  EXPECT_TRUE(pairs.is_linked(1, 2));
  EXPECT_TRUE(pairs.is_linked(2, 1));
  EXPECT_FALSE(pairs.is_linked(1, 3));
  pairs.note_resolved(4, kWalls);
  EXPECT_TRUE(pairs.is_resolved(4, kWalls));
  EXPECT_FALSE(pairs.is_resolved(4, kWalls + 1));
  EXPECT_TRUE(pairs.is_resolved(2, 1));
  EXPECT_FALSE(pairs.is_linked(4, kWalls));
}

TEST_F(Instant, LinksEachPairOnce) {
  pairs.link({1, 2});
  pairs.link({2, 1});
  pairs.link({1, 3});
  EXPECT_EQ(pairs.linked(), (Pairs{{1, 2}, {1, 3}}));
  pairs.drop_links(1);
  EXPECT_EQ(pairs.linked(), (Pairs{{1, 2}}));
}

TEST_F(Instant, GivesWhatWaitsOrIsPressedAwayOnce) {
  pairs.wait(1, 2);
  pairs.wait(3, kWalls);
  pairs.press({4, 5});
  EXPECT_TRUE(pairs.any_pressed());
  EXPECT_EQ(pairs.take_waiting(), (Pairs{{1, 2}, {3, kWalls}}));
  EXPECT_TRUE(pairs.waiting().empty());
  pairs.wait(1, 2);
  pairs.drop_waiting();
  EXPECT_TRUE(pairs.waiting().empty());
  EXPECT_EQ(pairs.take_pressed(), (Pairs{{4, 5}}));
  EXPECT_FALSE(pairs.any_pressed());
}

TEST_F(Instant, CountsTheImpactsOfABallUntilItIsOver) {
  pairs.count_hit(1);
  pairs.count_hit(1);
  pairs.count_hit(2);
  EXPECT_EQ(pairs.hits(1), 2);
  EXPECT_EQ(pairs.hits(2), 1);
  pairs.wait(1, 2);
  pairs.press({4, 5});
  pairs.link({1, 2});
  pairs.note_resolved(1, 3);
  pairs.forget_resolved();
  EXPECT_EQ(pairs.hits(1), 0);
  EXPECT_EQ(pairs.hits(2), 0);
  EXPECT_FALSE(pairs.is_resolved(1, 2));
  EXPECT_FALSE(pairs.is_resolved(1, 3));
  EXPECT_EQ(pairs.waiting(), (Pairs{{1, 2}}));
  EXPECT_TRUE(pairs.any_pressed());
  pairs.count_hit(1);
  EXPECT_EQ(pairs.hits(1), 1);
}

TEST_F(Instant, TakesBackWhatIsOfBalls) {
  pairs.note_resolved(1, 2);
  pairs.note_resolved(3, 4);
  pairs.note_resolved(5, 1);
  pairs.press({4, 1});
  pairs.press({3, 4});
  pairs.link({1, 6});
  EXPECT_EQ(pairs.take_back([](Index i) { return i == 1; }), (Pairs{{4, 1}}));
  EXPECT_FALSE(pairs.is_resolved(1, 2));
  EXPECT_FALSE(pairs.is_resolved(1, 5));
  EXPECT_TRUE(pairs.is_resolved(3, 4));
  EXPECT_TRUE(pairs.is_linked(1, 6));  // it met all the same
  EXPECT_EQ(pairs.take_pressed(), (Pairs{{3, 4}}));
}

TEST_F(Instant, ForgetsAllWhenTheBallsAreOthers) {
  pairs.wait(1, 2);
  pairs.press({4, 5});
  pairs.link({1, 2});
  pairs.note_resolved(1, 3);
  pairs.count_hit(1);
  pairs.reset(10);
  EXPECT_TRUE(pairs.waiting().empty());
  EXPECT_FALSE(pairs.any_pressed());
  EXPECT_FALSE(pairs.is_resolved(1, 2));
  EXPECT_FALSE(pairs.is_resolved(1, 3));
  EXPECT_EQ(pairs.hits(1), 0);
}

// Balls from 7 on never move: what hits only them is no reason to be together.
TEST(PairGroups, ArePairsThatShareBalls) {
  const auto moves = [](Index i) { return i < 7; };
  const Pairs pairs{{1, 2}, {3, 8}, {4, kWalls}, {5, 2}, {4, 8}, {1, kWalls}, {6, 5}};
  std::set<std::set<Pair>> groups;
  std::set<std::set<Index>> balls;
  for (const PairGroup& group : groups_that_share(pairs, moves)) {
    groups.insert({group.pairs.begin(), group.pairs.end()});
    balls.insert({group.balls.begin(), group.balls.end()});
    EXPECT_EQ(std::set<Index>(group.balls.begin(), group.balls.end()).size(), group.balls.size());
  }
  EXPECT_EQ(groups, (std::set<std::set<Pair>>{
                        {{1, 2}, {5, 2}, {1, kWalls}, {6, 5}}, {{3, 8}}, {{4, kWalls}, {4, 8}}}));
  EXPECT_EQ(balls, (std::set<std::set<Index>>{{1, 2, 5, 6}, {3}, {4}}));
  EXPECT_TRUE(groups_that_share({}, moves).empty());
}

}  // namespace
}  // namespace carom::event::simultaneous_pairs_test
