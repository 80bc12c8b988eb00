#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contact/pushes.hpp"

namespace carom::contact::contact_pushes_test {
namespace {

TEST(ContactPushes, ARowPassesOnWhatItsGapsLeave) {
  const std::vector<Pair> pairs{{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  std::vector<double> pushes{1, 0, 0, 0, 0};
  pass_on_pushes(pairs, std::vector<double>{-1, 0.25, 0.5, 0.5}, pushes);
  EXPECT_EQ(pushes, (std::vector<double>{1, 1, 0.75, 0.25, 0}));
}

TEST(ContactPushes, TheFarthestOfAllWaysCountsInAnyOrderOfThePairs) {
  // From 0 to 3 by 1 or by 2; 3 pushes back what is farther.
  std::vector<Pair> pairs{{0, 1}, {0, 2}, {1, 3}, {2, 3}};
  std::vector<double> gaps{0.5, 0.125, 0.125, 0.25};
  for (int turn = 0; turn < 4; ++turn) {
    std::vector<double> pushes{1, 0, 0, 0};
    pass_on_pushes(pairs, gaps, pushes);
    EXPECT_EQ(pushes, (std::vector<double>{1, 0.5, 0.875, 0.625}));
    std::rotate(pairs.begin(), pairs.begin() + 1, pairs.end());
    std::rotate(gaps.begin(), gaps.begin() + 1, gaps.end());
  }
}

TEST(ContactPushes, WithoutPushesThereIsNothingToPassOn) {
  std::vector<double> pushes{0, 0};
  pass_on_pushes(std::vector<Pair>{{0, 1}}, std::vector<double>{-0.5}, pushes);
  EXPECT_EQ(pushes, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace carom::contact::contact_pushes_test
