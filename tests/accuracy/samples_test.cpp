#include "accuracy/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace carom::accuracy::samples_test {
namespace {

TEST(Samples, AreAtEndsOfStepsAndAtTheEnd) {
  for (const double time : {1.0, 10.0, 3.3, 1e-3, 1e4, 1.0 / 7}) {
    SCOPED_TRACE(time);
    const Samples samples(time, 1000);
    EXPECT_GE(samples.count(), 100U);
    EXPECT_LE(samples.count(), 260U);
    EXPECT_EQ(samples.time(samples.count()), time);
    for (std::size_t s = 1; s < samples.count(); ++s) {
      EXPECT_LT(samples.time(s - 1), samples.time(s));
      EXPECT_NEAR(samples.fine_time(s * Samples::kParts), samples.time(s), 1e-14 * time);
      for (double step = kLongestStep; step > kLongestStep / 2000; step /= 2) {
        if (!samples.compares(s, step)) continue;
        const double steps = samples.time(s) / step;
        EXPECT_NEAR(steps, std::rint(steps), 1e-9 * steps);
      }
      EXPECT_TRUE(samples.compares(s, std::nullopt));
    }
  }
}

TEST(Samples, AStepIsComparedAsOftenAsItEndsWhereOneIsDue) {
  const Samples samples(10, 1000);  // every 1/15 s
  EXPECT_DOUBLE_EQ(samples.time(1), 1.0 / 15);
  EXPECT_EQ(samples.stride(1.0 / 30), Samples::kParts / 2);
  EXPECT_EQ(samples.stride(1.0 / 30720), 1U);
  EXPECT_EQ(samples.stride(std::nullopt), 1U);
}

TEST(Samples, ThereAreNoMoreThanThereIsRoomFor) {
  EXPECT_LE(Samples(10, 7).count(), 8U);
  EXPECT_GE(Samples(10, 0).count(), 1U);
}

TEST(Samples, NoTimeHasOneSampleItsEnd) {
  const Samples samples(0, 1000);
  ASSERT_EQ(samples.count(), 1U);
  EXPECT_EQ(samples.time(1), 0);
}

}  // namespace
}  // namespace carom::accuracy::samples_test
