#include "solvers/event/prediction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <random>
#include <set>
#include <vector>

#include "support/predicted_balls.hpp"

namespace carom::event::prediction_test {
namespace {

Rules box(double size, const std::array<double, 2>& gravity, bool periodic) {
  Box box;
  box.width = size;
  box.height = size;
  box.periodic = {periodic, false};
  box.origin = Box::Origin::center;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.gravity = gravity;
  rules.all_species = {{0.5, 1}, {0.3, 0.5}, {0.4, 0}};
  return rules;
}

/// Balls on a lattice, of which one in `fixed` is, with random velocities.
struct Balls : PredictedBalls {
  Balls(const Rules& rules, unsigned seed, std::size_t fixed) : PredictedBalls(rules) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    constexpr int kSide = 9;
    for (int k = 0; k < kSide * kSide; ++k) {
      Disk disk;
      const int column = k % kSide - kSide / 2;
      const int row = k / kSide - kSide / 2;
      disk.x = 1.3 * column + 0.1 * std::tanh(normal(random));
      disk.y = 1.3 * row + 0.1 * std::tanh(normal(random));
      disk.species = static_cast<Index>(k % 2);
      disk.vx = 9 * normal(random);
      disk.vy = 9 * normal(random);
      if (fixed != 0 && static_cast<std::size_t>(k) % fixed == 0) {
        disk.species = 2;
        disk.vx = disk.vy = 0;
        disk.start = kEver;
      }
      if (motion.contacts_last() && k % 4 == 1) {  // it slides along a floor
        disk.vy = 0;
        motion.set_support(disk, 2);
      }
      disks.push_back(disk);
    }
    if ((fixed != 0 || motion.rests()) && motion.bends()) left.assign(disks.size(), kUnknown);
    neighbours.reset(disks, 0);
    for (Index i = 0; i < disks.size(); ++i) disks[i].leaves = neighbours.leaving(disks[i], i, 0);
  }

  /// All other balls looked at, one by one.
  [[nodiscard]] Meeting<Ballistic> slowly(Index i) const {
    Meeting<Ballistic> best{disks[i].meets, kUnknown};
    for (Index j = 0; j < disks.size(); ++j) {
      if (j == i) continue;
      const FixedTime at = motion.pair_event(disks[i], disks[j]);
      if (at < best.time && at < disks[j].meets) best = {at, j};
    }
    const Meeting<Ballistic> alone = motion.alone(disks[i]);
    if (alone.time < best.time) best = alone;
    return best;
  }
};

struct Case {
  const char* name;
  std::array<double, 2> gravity;
  bool periodic;
  std::size_t fixed;
  bool rests = false;
};

void PrintTo(const Case& each, std::ostream* out) {
  *out << each.name;
}

Rules rules_of(const Case& of) {
  Rules rules = box(13, of.gravity, of.periodic);
  rules.rests = of.rests;
  if (of.rests) rules.restitution = 0.5;
  return rules;
}

class OfCase : public ::testing::TestWithParam<Case> {};

// Up to the time at which a ball leaves its safe region, and they are looked at again.
TEST_P(OfCase, TheNextMeetingIsTheFirstOfAll) {
  std::size_t balls = 0;
  std::size_t walls = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Balls all(rules_of(GetParam()), seed, GetParam().fixed);
    std::mt19937_64 random(seed);
    for (Disk& disk : all.disks) {
      // Some are known to meet something soon.
      if (!all.motion.fixed(disk) && random() % 3 == 0)
        disk.meets = static_cast<FixedTime>(random() >> 14);
    }
    for (Index i = 0; i < all.disks.size(); ++i) {
      if (all.motion.fixed(all.disks[i])) continue;
      const Meeting<Ballistic> wanted = all.slowly(i);
      const Meeting<Ballistic> found = all.prediction.next(i, 0);
      FixedTime leaves = all.disks[i].leaves;
      if (wanted.partner < kFirstMark) leaves = std::min(leaves, all.disks[wanted.partner].leaves);
      if (wanted.time > leaves) continue;
      EXPECT_EQ(found.time, wanted.time) << i;
      EXPECT_EQ(found.partner, wanted.partner) << i;
      ++(found.partner < kFirstMark ? balls : walls);
    }
  }
  EXPECT_GT(balls, 100U);
  EXPECT_GT(walls, 10U);
}

TEST_P(OfCase, TheNextOfSomeIsTheFirstOfThose) {
  Balls all(rules_of(GetParam()), 3, GetParam().fixed);
  std::size_t found_ball = 0;
  for (Index i = 0; i < all.disks.size(); ++i) {
    if (all.motion.fixed(all.disks[i])) continue;
    std::vector<Index> some;
    for (Index j = 0; j < all.disks.size(); ++j) {
      if (j != i && (i + j) % 3 == 0) some.push_back(j);
    }
    Meeting<Ballistic> wanted;
    for (const Index j : some) {
      const FixedTime at = all.motion.pair_event(all.disks[i], all.disks[j]);
      if (at < wanted.time) wanted = {at, j};
    }
    const Meeting<Ballistic> alone = all.motion.alone(all.disks[i]);
    if (alone.time < wanted.time) wanted = alone;
    const Meeting<Ballistic> found = all.prediction.next_of(i, some, 0);
    if (wanted.time > all.disks[i].leaves && wanted.partner >= kFirstMark) continue;
    EXPECT_EQ(found.time, wanted.time) << i;
    if (found.partner < kFirstMark) ++found_ball;
  }
  EXPECT_GT(found_ball, 10U);
}

INSTANTIATE_TEST_SUITE_P(Prediction, OfCase,
                         ::testing::Values(Case{"walls", {0, 0}, false, 0},
                                           Case{"periodic", {0, 0}, true, 0},
                                           Case{"fixed", {0, 0}, true, 5},
                                           Case{"falling", {3, -40}, false, 0},
                                           Case{"falling_on_fixed", {0, -40}, true, 5},
                                           Case{"resting", {0, -40}, true, 0, true}),
                         [](const auto& each) { return each.param.name; });

// Three in a row, the outer two of which come to the middle one at the same time.
TEST(Prediction, NotesATieWhereABallMeetsTwoAtOnce) {
  Balls all(box(13, {0, 0}, false), 1, 0);
  all.disks.resize(3);
  for (Index i = 0; i < 3; ++i) {
    Disk& disk = all.disks[i];
    disk = Disk{};
    disk.x = 3 * (static_cast<double>(i) - 1);
    disk.vx = 1 - static_cast<double>(i);
  }
  all.neighbours.reset(all.disks, 0);
  const Meeting<Ballistic> found = all.prediction.next(1, 0);
  EXPECT_EQ(found.time, all.motion.rules().scale.ticks(2));
  EXPECT_TRUE(all.ties.any(found.time, 1, 1));
}

TEST(Prediction, OfAPairKnowsWhatAFlightBeganAt) {
  Balls all(box(13, {0, -1}, false), 1, 0);
  all.disks.resize(2);
  all.disks[0] = Disk{};
  all.disks[1] = Disk{};
  all.disks[0].species = 2;
  all.disks[0].start = kEver;
  all.disks[1].y = 0.9;  // it touches the fixed one
  all.disks[1].vy = 1;
  all.left = {kUnknown, 0};
  // Thrown up at 1 under gravity 1 it is back after 2 seconds.
  EXPECT_NEAR(all.motion.rules().scale.seconds(all.prediction.pair_event(1, 0, kNever)), 2, 1e-12);
}

}  // namespace
}  // namespace carom::event::prediction_test
