#include "solvers/event/resolutions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "numbers/exact_sum.hpp"

namespace carom::event::resolutions_test {
namespace {

/// One group of balls, and what it does: one impact for each of its balls.
using Balls = std::vector<Index>;

struct State {
  Counts counts;
  EnergyBook book;
  ImpactLog log;
  ImpactNotes notes;
  Resolutions resolutions{counts, book, notes};

  explicit State(std::size_t balls) {
    notes.write_to(&log);
    resolutions.reset(balls);
    resolutions.begin_instant();
  }

  /// Of losses no two of which add up to others.
  void resolve(const Balls& balls) {
    resolutions.begin();
    const std::uint64_t event = balls.size() > 1 ? notes.next_event() : 0;
    for (const Index i : balls) {
      resolutions.add(i);
      ++counts.ball_ball;
      if (i == 3) ++counts.wakes;
      book.note(std::ldexp(1.0, static_cast<int>(i)));
      book.keep();
      Impact line;
      line.a = i;
      line.event = event;
      notes.add(line);
    }
    if (balls.size() > 1) ++counts.joint_impacts;
    resolutions.end();
  }
};

void expect_same(const State& one, const State& other) {
  EXPECT_EQ(one.counts.ball_ball, other.counts.ball_ball);
  EXPECT_EQ(one.counts.joint_impacts, other.counts.joint_impacts);
  EXPECT_EQ(one.counts.wakes, other.counts.wakes);
  ExactSum<double> lost;
  for (const double part : one.book.parts()) lost.add(part);
  for (const double part : other.book.parts()) lost.add(-part);
  EXPECT_EQ(lost.rounded(), 0);
  ASSERT_EQ(one.log.impacts.size(), other.log.impacts.size());
  for (std::size_t k = 0; k < one.log.impacts.size(); ++k) {
    EXPECT_EQ(one.log.impacts[k].a, other.log.impacts[k].a) << k;
    EXPECT_EQ(one.log.impacts[k].event, other.log.impacts[k].event) << k;
  }
}

/// Which of the groups are linked to these balls, by going over all until nothing is added.
std::vector<char> linked(const std::vector<Balls>& groups, const Balls& to) {
  std::set<Index> reached(to.begin(), to.end());
  std::vector<char> result(groups.size(), 0);
  for (bool more = true; more;) {
    more = false;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (result[k] != 0) continue;
      if (std::none_of(groups[k].begin(), groups[k].end(),
                       [&](Index i) { return reached.contains(i); })) {
        continue;
      }
      result[k] = 1;
      reached.insert(groups[k].begin(), groups[k].end());
      more = true;
    }
  }
  return result;
}

// What is left is what there would be, had those that are linked to some balls not been resolved.
TEST(Resolutions, TakeBackWhatIsLinkedAndNothingElse) {
  constexpr std::size_t kBalls = 12;
  std::mt19937 random(5);
  const auto below = [&random](std::size_t n) { return static_cast<Index>(random() % n); };
  std::size_t taken = 0;
  std::size_t left = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Balls> groups(1 + below(7));
    for (Balls& group : groups) {
      std::set<Index> balls;
      for (std::size_t k = 0; k < 1U + below(3); ++k) balls.insert(below(kBalls));
      group.assign(balls.begin(), balls.end());
    }
    State all(kBalls);
    for (const Balls& group : groups) all.resolve(group);
    const Balls back{below(kBalls), below(kBalls)};
    const auto chosen = all.resolutions.with(back);
    const std::vector<char> gone = linked(groups, back);
    std::vector<char> undone(kBalls, 0);
    State wanted(kBalls);
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (gone[k] == 0) wanted.resolve(groups[k]);
      for (const Index i : groups[k]) undone[i] = gone[k];
      ++(gone[k] != 0 ? taken : left);
    }
    for (Index i = 0; i < kBalls; ++i) {
      EXPECT_EQ(all.resolutions.contains(chosen, i), undone[i] != 0) << i;
    }
    all.resolutions.take_back(chosen);
    expect_same(all, wanted);
    for (Index i = 0; i < kBalls; ++i) {
      EXPECT_EQ(all.resolutions.contains(i), wanted.resolutions.contains(i)) << i;
    }
    // Others of the same instant can be taken back afterwards, and so can what comes later.
    all.resolve({0, 1});
    std::vector<Balls> rest;
    for (std::size_t k = 0; k < groups.size(); ++k) {
      if (gone[k] == 0) rest.push_back(groups[k]);
    }
    rest.push_back({0, 1});
    const Balls more{below(kBalls)};
    const std::vector<char> gone_too = linked(rest, more);
    State at_last(kBalls);
    for (std::size_t k = 0; k < rest.size(); ++k) {
      if (gone_too[k] == 0) at_last.resolve(rest[k]);
    }
    all.resolutions.take_back(all.resolutions.with(more));
    expect_same(all, at_last);
  }
  EXPECT_GT(taken, 100U);
  EXPECT_GT(left, 100U);
}

TEST(Resolutions, StayOnceTheInstantIsOver) {
  State state(4);
  state.resolve({1, 2});
  EXPECT_TRUE(state.resolutions.any());
  EXPECT_TRUE(state.resolutions.contains(1));
  EXPECT_FALSE(state.resolutions.contains(3));
  state.resolutions.begin_instant();
  EXPECT_FALSE(state.resolutions.any());
  EXPECT_FALSE(state.resolutions.contains(1));
  state.resolutions.take_back(state.resolutions.with(Balls{1, 2}));
  EXPECT_EQ(state.counts.ball_ball, 2U);
  EXPECT_EQ(state.log.impacts.size(), 2U);
}

TEST(Resolutions, KnowEachBallOnce) {
  State state(4);
  state.resolutions.begin();
  EXPECT_TRUE(state.resolutions.add(2));
  state.resolutions.end();
  state.resolutions.begin();
  EXPECT_FALSE(state.resolutions.add(2));
  EXPECT_TRUE(state.resolutions.add(1));
  state.resolutions.end();
  EXPECT_EQ(state.resolutions.balls(), (Balls{2, 1}));
}

}  // namespace
}  // namespace carom::event::resolutions_test
