#include "view/slice_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace carom::slice_cost_test {
namespace {

constexpr double kStep = 1.0 / 240;
constexpr double kFrame = 8 * kStep;
constexpr double kTime = 0.025;

struct Shown {
  int calls = 0;
  double seconds = 0;    ///< real ones, for the frame
  double simulated = 0;  ///< of the frame
};

/// Frames of a player, who computes slices one after the other while there is time.
std::vector<Shown> frames(int count, const std::function<double(double)>& cost_of) {
  SliceCost cost;
  std::vector<Shown> shown;
  for (int i = 0; i < count; ++i) {
    Shown frame;
    double left = kFrame;
    while (left > 0 && frame.seconds < kTime) {
      const double slice = cost.slice(left, kStep, kTime - frame.seconds);
      const double seconds = cost_of(slice);
      cost.note(slice, seconds);
      left = slice < left ? left - slice : 0;
      ++frame.calls;
      frame.seconds += seconds;
      frame.simulated += slice;
    }
    shown.push_back(frame);
  }
  return shown;
}

TEST(SliceCost, AFrameIsOneCallWhereACallCostsMostWhateverItsSlice) {
  for (const double fixed : {0.006, 0.04}) {
    const auto shown = frames(100, [&](double slice) { return fixed + 0.1 * slice; });
    for (std::size_t i = 8; i < shown.size(); ++i) {
      EXPECT_EQ(shown[i].calls, 1) << fixed;
      EXPECT_EQ(shown[i].simulated, kFrame) << fixed;
    }
  }
}

TEST(SliceCost, ASliceIsAStepWhereStepsAreWhatCosts) {
  int longer = 0;
  for (const Shown& frame : frames(200, [](double slice) { return 10 * slice; })) {
    EXPECT_EQ(frame.calls, 1);
    EXPECT_LE(frame.simulated, 2 * kStep);
    longer += frame.simulated > kStep ? 1 : 0;
  }
  EXPECT_LE(longer, 6) << "it is tried now and then";
}

// A frame that takes 20 ms is shown whole; of one that takes 40, not much more than there is time
// for.
TEST(SliceCost, SlicesFillTheTimeOfAFrame) {
  const auto cost = [](double slice) { return 0.020 / kFrame * slice; };
  for (const Shown& frame : frames(100, cost)) {
    EXPECT_NEAR(frame.simulated, kFrame, 1e-12);
    EXPECT_LE(frame.calls, 8);
  }
  for (const Shown& frame : frames(100, [&](double slice) { return 2 * cost(slice); })) {
    EXPECT_LT(frame.seconds, 1.3 * kTime);
  }
}

TEST(SliceCost, OneDearCallMakesNoFrameLate) {
  for (int costly = 1; costly < 60; ++costly) {
    int calls = 0;
    int late = 0;
    const auto cost = [&](double slice) {
      return ++calls == costly ? 0.1 : 0.002 + 0.030 / kFrame * slice;
    };
    for (const Shown& frame : frames(60, cost)) late += frame.seconds > 1.4 * kTime ? 1 : 0;
    EXPECT_LE(late, 1) << "but for its own, after call " << costly;
  }
}

}  // namespace
}  // namespace carom::slice_cost_test
