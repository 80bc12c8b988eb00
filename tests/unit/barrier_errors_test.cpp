// A barrier that is cancelled, whose completion throws, or that cannot count its parties.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <thread>

#include "carom/barrier.hpp"
#include "unit/threads.hpp"
#include "unit/watchdog.hpp"

namespace carom::barrier_errors_test {
namespace {

using std::chrono::microseconds;
using test::let_them_sleep;
using test::on_threads;
using test::Watchdog;

TEST(Barrier, CancelReleasesEverybodyForGood) {
  const Watchdog watchdog;
  for (const std::size_t threads : {1U, 2U, 40U}) {
    int completions = 0;
    Barrier barrier(threads + 1, [&] { ++completions; });
    std::atomic<int> released{0};
    std::thread others([&] {
      on_threads(threads, [&](std::size_t) {
        if (!barrier.arrive_and_wait()) ++released;
      });
    });
    let_them_sleep();
    EXPECT_FALSE(barrier.cancelled());
    barrier.cancel();
    others.join();
    EXPECT_EQ(released, static_cast<int>(threads));
    EXPECT_TRUE(barrier.cancelled());
    EXPECT_FALSE(barrier.arrive_and_wait());
    EXPECT_FALSE(barrier.arrive_and_wait());
    EXPECT_EQ(completions, 0);
  }
}

TEST(Barrier, CancelAtAnyMomentHangsNobody) {
  const Watchdog watchdog;
  for (int round = 0; round < 60; ++round) {
    Barrier barrier(4);
    std::thread killer([&] {
      std::this_thread::sleep_for(microseconds(20 * round));
      barrier.cancel();
    });
    on_threads(4, [&](std::size_t) {
      while (barrier.arrive_and_wait()) continue;
    });
    killer.join();
  }
}

TEST(Barrier, WhatTheCompletionThrowsIsThrownToTheLastAndReleasesTheOthers) {
  const Watchdog watchdog;
  Barrier barrier(6, [] { throw std::runtime_error("completion"); });
  std::atomic<int> thrown{0};
  std::atomic<int> released{0};
  on_threads(6, [&](std::size_t) {
    try {
      if (!barrier.arrive_and_wait()) ++released;
    } catch (const std::runtime_error&) {
      ++thrown;
    }
  });
  EXPECT_EQ(thrown, 1);
  EXPECT_EQ(released, 5);
  EXPECT_TRUE(barrier.cancelled());
}

TEST(Barrier, WhatTheCompletionThrowsIsThrownToThePartyThatLeaves) {
  const Watchdog watchdog;
  Barrier barrier(2, [] { throw std::runtime_error("completion"); });
  std::atomic<bool> released{false};
  std::thread other([&] { released = !barrier.arrive_and_wait(); });
  let_them_sleep();
  EXPECT_THROW(barrier.leave(), std::runtime_error);
  other.join();
  EXPECT_TRUE(released);
}

TEST(Barrier, MorePartiesThanItCanCountAreRefused) {
  EXPECT_THROW(Barrier(Barrier::kMostParties + 1), std::length_error);
  Barrier barrier(Barrier::kMostParties);
  EXPECT_THROW(barrier.join(), std::length_error);
  EXPECT_EQ(barrier.parties(), Barrier::kMostParties);
}

}  // namespace
}  // namespace carom::barrier_errors_test
