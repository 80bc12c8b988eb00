#include "solvers/event/domains/halo_width.hpp"

#include <gtest/gtest.h>

namespace carom::event::halo_width_test {
namespace {

HaloWidth halo_of(double spacing, double radius) {
  HaloWidth halo;
  halo.reset({spacing, radius});
  return halo;
}

// Two balls that both may go this far, and touch, were no farther apart.
TEST(HaloWidth, ReachesWhatMayComeNear) {
  for (const double displaced : {0.0, 0.3, 7.0}) {
    HaloWidth halo = halo_of(3, 0.5);
    halo.follow_beyond(0);
    const HaloWidth::Width width = halo.of(displaced, 1);
    EXPECT_GT(width.full, 2 * displaced + 2 * 0.5);
    EXPECT_LT(width.full, (2 * displaced + 2 * 0.5) * 1.2);
    EXPECT_GT(width.reach, width.full + 2 * 3);
    halo.follow_beyond(2);
    EXPECT_NEAR(halo.of(displaced, 1).full, width.full + 2 * 2 * 0.5, 1e-12);
    EXPECT_NEAR(halo.of(displaced, 2).reach, 2 * halo.of(displaced, 1).reach, 1e-12);
  }
}

TEST(HaloWidth, GrowsWhereManyAreSolvedAgainAndShrinksWhereNoneIs) {
  HaloWidth halo = halo_of(1, 0.4);
  const auto beyond = [&] { return halo.of(0, 1).reach - halo.of(0, 1).full; };
  const double first = beyond();
  halo.learn(3, 10);
  EXPECT_NEAR(beyond(), 1.2 * first, 1e-12);
  const double before = beyond();
  halo.learn(0, 10);
  EXPECT_LT(beyond(), before);
  for (int k = 0; k < 1000; ++k) halo.learn(0, 10);
  EXPECT_NEAR(beyond(), 1, 1e-12);  // a spacing
  for (int k = 0; k < 1000; ++k) halo.learn(10, 10);
  EXPECT_NEAR(beyond(), 40, 1e-12);
}

// One in twenty is what pays.
TEST(HaloWidth, StaysWhereOneInTwentyIsSolvedAgain) {
  HaloWidth halo = halo_of(1, 0.4);
  const double first = halo.of(0, 1).reach;
  for (int k = 0; k < 100; ++k) {
    halo.learn(1, 20);
    halo.learn(2, 20);
  }
  EXPECT_GT(halo.of(0, 1).reach, first);
  for (int k = 0; k < 2000; ++k) halo.learn(1, 20);
  EXPECT_LT(halo.of(0, 1).reach, first);
}

}  // namespace
}  // namespace carom::event::halo_width_test
