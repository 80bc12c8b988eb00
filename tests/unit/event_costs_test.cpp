#include "solvers/event/event_costs.hpp"

#include <gtest/gtest.h>

namespace carom::event::event_costs_test {
namespace {

// Events that all cost the same: those that were timed stand for all, however many there were.
TEST(EventCosts, AreThoseOfAllEvents) {
  EventCosts costs;
  EXPECT_EQ(costs.total().collisions, 0);
  int timed = 0;
  for (int events = 1; events <= 1000; ++events) {
    if (costs.is_timed()) {
      costs.add({4, 3, 2, 1});
      ++timed;
    }
    EXPECT_DOUBLE_EQ(costs.total().collisions, 4.0 * events);
    EXPECT_DOUBLE_EQ(costs.total().beside_pairs(), 6.0 * events);
  }
  EXPECT_EQ(timed, 8);  // the first and every 127th after it
}

TEST(EventCosts, HaveIslandsAsTheyAre) {
  EventCosts costs;
  costs.island_seconds() += 5;
  EXPECT_EQ(costs.total().collisions, 5);
  for (int events = 0; events < 127; ++events) {
    if (costs.is_timed()) costs.add({1, 0, 0, 0});
  }
  costs.island_seconds() += 1;
  EXPECT_DOUBLE_EQ(costs.total().collisions, 127 + 6);
}

}  // namespace
}  // namespace carom::event::event_costs_test
