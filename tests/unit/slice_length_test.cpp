#include "view/slice_length.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace carom {
namespace {

constexpr double kStep = 1.0 / 240;
constexpr double kFrame = 8 * kStep;
constexpr double kTime = 0.025;

/// The slice that a player computes, after so many that cost fixed + rate * slice.
double slice_after(int slices, double fixed, double rate) {
  SliceLength length;
  double slice = kStep;
  for (int i = 0; i < slices; ++i) {
    slice = std::min(kFrame, std::max(kStep, length.shortest()));
    length.note(slice, fixed + rate * slice, kTime);
  }
  return slice;
}

TEST(SliceLength, GrowsToTheFrameWhereACallCostsMoreThanAFramesTime) {
  EXPECT_EQ(slice_after(12, 0.04, 0.1), kFrame);
}

TEST(SliceLength, StaysAtTheStepWhereStepsAreWhatCosts) {
  int longer = 0;
  for (int slices = 1; slices < 200; ++slices) longer += slice_after(slices, 0, 10) > kStep;
  EXPECT_LE(longer, 4) << "it is tried now and then";
  EXPECT_EQ(slice_after(30, 0, 10), kStep);
}

TEST(SliceLength, LeavesSlicesAloneThatFitIntoAFrame) {
  for (int slices = 1; slices < 100; ++slices) EXPECT_EQ(slice_after(slices, 0.006, 0), kStep);
}

}  // namespace
}  // namespace carom
