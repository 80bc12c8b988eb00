#include "solvers/event/groups/conflict_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace carom::event::conflict_sets_test {
namespace {

using Members = std::vector<Index>;

// Ten balls of which 8 and 9 are fixed.
struct Window {
  Window() {
    fixed[8] = fixed[9] = 1;
    sets.reset(fixed);
    sets.begin_window();
  }

  // One pass in which these meet; what the groups that are to be solved have, the fixed ones last.
  std::vector<Members> pass(const std::vector<Encounter>& met) {
    sets.begin_pass();
    sets.meet(met);
    std::vector<Members> groups;
    for (const ConflictSets::Group& group : sets.joined()) {
      Members members;
      sets.each(group.root, [&](Index i) { members.push_back(i); });
      std::sort(members.begin(), members.end());
      EXPECT_EQ(members.size(), group.size);
      members.insert(members.end(), sets.fixed_of(group.root).begin(),
                     sets.fixed_of(group.root).end());
      groups.push_back(members);
    }
    return groups;
  }

  std::vector<char> fixed = std::vector<char>(10, 0);
  ConflictSets sets;
};

using Groups = std::vector<Members>;

TEST(ConflictSets, PairsThatShareABallAreOneGroupAndTheLargestComesFirst) {
  Window window;
  EXPECT_EQ(window.pass({{0, 1}, {4, 5}, {5, 6}}), (Groups{{4, 5, 6}, {0, 1}}));
  EXPECT_TRUE(window.sets.together(4, 6));
  EXPECT_FALSE(window.sets.together(0, 4));
  EXPECT_FALSE(window.sets.together(2, 3));
}

TEST(ConflictSets, LaterPassesJoinGroupsAndLeaveOthersAlone) {
  Window window;
  ASSERT_EQ(window.pass({{0, 1}, {2, 3}, {4, 5}}).size(), 3U);
  EXPECT_EQ(window.pass({{1, 2}}), (Groups{{0, 1, 2, 3}}));
  EXPECT_EQ(window.pass({}), Groups{});
}

TEST(ConflictSets, AFixedBallIsOfEveryGroupThatComesToItAndJoinsNone) {
  Window window;
  EXPECT_EQ(window.pass({{0, 1}, {0, 8}, {1, 8}, {3, 8}}), (Groups{{0, 1, 8}, {3, 8}}));
  EXPECT_TRUE(window.sets.together(1, 8));
  EXPECT_FALSE(window.sets.together(1, 9));
  EXPECT_FALSE(window.sets.together(0, 3));
  EXPECT_EQ(window.pass({{3, 9}, {1, 3}}), (Groups{{0, 1, 3, 8, 9}}));
}

TEST(ConflictSets, BallsThatTouchComeTogetherOrNotAtAll) {
  Window window;
  window.sets.touch(std::vector<Encounter>{{1, 2}, {2, 3}, {3, 9}});
  window.sets.touch(std::vector<Encounter>{{5, 6}});
  EXPECT_EQ(window.pass({{0, 1}}), (Groups{{0, 1, 2, 3, 9}}));
  EXPECT_FALSE(window.sets.together(5, 6));
  EXPECT_EQ(window.pass({{3, 5}}), (Groups{{0, 1, 2, 3, 5, 6, 9}}));
}

TEST(ConflictSets, ClustersOfWhatAClusterHasJoinedComeToo) {
  Window window;
  window.sets.touch(std::vector<Encounter>{{1, 2}, {3, 4}, {4, 8}});
  // 2 and 4 are of one group, and bring 1, 3 and the fixed ball.
  EXPECT_EQ(window.pass({{2, 4}}), (Groups{{1, 2, 3, 4, 8}}));
  Window two;
  two.sets.touch(std::vector<Encounter>{{1, 2}, {3, 4}, {4, 8}});
  ASSERT_EQ(two.pass({{0, 3}}), (Groups{{0, 3, 4, 8}}));
  EXPECT_EQ(two.pass({{1, 5}, {5, 7}, {2, 7}}), (Groups{{1, 2, 5, 7}}));
  EXPECT_EQ(two.pass({{0, 7}}), (Groups{{0, 1, 2, 3, 4, 5, 7, 8}}));
}

TEST(ConflictSets, AContactThatLastsIsTheWholeGroups) {
  Window window;
  window.sets.begin_pass();
  window.sets.meet(std::vector<Encounter>{{0, 1, true}, {1, 2}, {4, 5}});
  const std::vector<ConflictSets::Group> groups = window.sets.joined();
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_TRUE(groups[0].lasting);
  EXPECT_FALSE(groups[1].lasting);
}

TEST(ConflictSets, TheNextWindowBeginsWithAllAlone) {
  Window window;
  window.sets.touch(std::vector<Encounter>{{1, 2}, {2, 9}});
  ASSERT_EQ(window.pass({{0, 1, true}, {0, 8}}), (Groups{{0, 1, 2, 8, 9}}));
  for (const Index i : {0U, 1U, 2U}) window.sets.forget(i);
  window.sets.begin_window();
  EXPECT_FALSE(window.sets.together(0, 1));
  EXPECT_FALSE(window.sets.together(0, 8));
  EXPECT_EQ(window.pass({{0, 1}}), (Groups{{0, 1}}));
  EXPECT_FALSE(window.sets.joined().front().lasting);
}

TEST(ConflictSets, NoOrderOfThePairsShows) {
  const Groups expected{{0, 1, 2, 3, 9}, {4, 5, 8}};
  std::vector<Encounter> pairs{{0, 1}, {2, 3}, {1, 3}, {4, 5}, {4, 8}};
  for (std::size_t turn = 0; turn < pairs.size(); ++turn) {
    Window window;
    window.sets.touch(std::vector<Encounter>{{2, 9}});
    EXPECT_EQ(window.pass(pairs), expected);
    std::rotate(pairs.begin(), pairs.begin() + 1, pairs.end());
  }
}

}  // namespace
}  // namespace carom::event::conflict_sets_test
