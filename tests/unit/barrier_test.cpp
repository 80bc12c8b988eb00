#include "carom/barrier.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace carom {
namespace {

TEST(Barrier, NobodyPassesBeforeTheLastArrives) {
  Barrier barrier(2);
  int seen = 0;
  std::thread other([&] {
    seen = 1;
    (void)barrier.arrive_and_wait();
  });
  (void)barrier.arrive_and_wait();
  EXPECT_EQ(seen, 1);
  other.join();
}

}  // namespace
}  // namespace carom
