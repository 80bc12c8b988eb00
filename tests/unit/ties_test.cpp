#include "solvers/event/ties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "solvers/event/fixed_time.hpp"

namespace carom::event::ties_test {
namespace {

// Held against a list of all that was noted, which forgets nothing.
TEST(Ties, AreThoseNotedOfEitherBallAtTheTime) {
  std::mt19937 random(3);
  const auto below = [&random](unsigned n) { return static_cast<Index>(random() % n); };
  Ties<FixedTimeClock> ties;
  std::vector<std::pair<FixedTime, Index>> all;
  FixedTime now = 0;
  std::size_t seen = 0;
  for (int round = 0; round < 2000; ++round) {
    const FixedTime at = now + below(4);
    const Index i = below(6);
    ties.note(at, i);
    all.emplace_back(at, i);
    now += below(2);
    const Index a = below(6);
    const Index b = below(6);
    const bool wanted = std::any_of(all.begin(), all.end(), [&](const auto& tie) {
      return tie.first == now && (tie.second == a || tie.second == b);
    });
    ASSERT_EQ(ties.any(now, a, b), wanted) << round;
    if (wanted) ++seen;
    if (round % 100 != 99) continue;
    const FixedTime by = now - 1;
    ties.rebase(by);
    for (auto& tie : all) tie.first -= by;
    now -= by;
  }
  EXPECT_GT(seen, 100U);
}

TEST(Ties, AreGoneWhenCleared) {
  Ties<FixedTimeClock> ties;
  ties.note(3, 1);
  ties.clear();
  EXPECT_FALSE(ties.any(3, 1, 2));
}

}  // namespace
}  // namespace carom::event::ties_test
