// The phases of a barrier: who waits for whom, and what runs between two of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <random>
#include <vector>

#include "carom/barrier.hpp"
#include "unit/threads.hpp"
#include "unit/watchdog.hpp"

namespace carom::barrier_test {
namespace {

using std::chrono::microseconds;
using test::let_them_sleep;
using test::on_threads;
using test::Watchdog;

// The counters are plain numbers on purpose: a missing happens-before is a race that the thread
// sanitizer reports.
void nobody_is_a_phase_ahead(std::size_t threads, int phases) {
  const Watchdog watchdog;
  Barrier barrier(threads);
  std::vector<int> done(threads, 0);
  std::atomic<int> wrong{0};
  on_threads(threads, [&](std::size_t me) {
    for (int phase = 1; phase <= phases; ++phase) {
      done[me] = phase;
      if (!barrier.arrive_and_wait()) ++wrong;
      for (const int other : done) {
        if (other != phase) ++wrong;
      }
      if (!barrier.arrive_and_wait()) ++wrong;
    }
  });
  EXPECT_EQ(wrong, 0);
}

TEST(Barrier, NobodyPassesBeforeTheLastArrives) {
  nobody_is_a_phase_ahead(2, 2000);
  nobody_is_a_phase_ahead(5, 500);
  nobody_is_a_phase_ahead(64, 50);
}

TEST(Barrier, OnePartyNeverWaits) {
  const Watchdog watchdog;
  Barrier barrier(1);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(barrier.arrive_and_wait());
}

TEST(Barrier, WhoOnlyArrivesGoesOnAtOnce) {
  const Watchdog watchdog;
  Barrier barrier(3);
  EXPECT_TRUE(barrier.arrive());
  EXPECT_TRUE(barrier.arrive());  // two parties in one thread: the second does not wait for a third
  EXPECT_TRUE(barrier.arrive_and_wait());  // the last ends the phase
  barrier.cancel();
  EXPECT_FALSE(barrier.arrive());
}

// One thread orders work and waits for its end; the others wait for orders only.
// Seen to fail: where an arrival that ends the phase wakes no thread, and where one does not count.
TEST(Barrier, OneWaitsForTheArrivalOfAll) {
  for (const std::size_t workers : {1, 2, 5, 40}) {
    const Watchdog watchdog;
    constexpr int kOrders = 300;
    Barrier order(workers + 1);
    Barrier done(workers + 1);
    std::vector<int> results(workers, 0);
    int number = 0;
    std::atomic<int> wrong{0};
    on_threads(workers + 1, [&](std::size_t me) {
      for (int i = 1; i <= kOrders; ++i) {
        if (me < workers) {
          if (!order.arrive_and_wait()) ++wrong;
          results[me] = number;
          if (!done.arrive()) ++wrong;
          continue;
        }
        number = i;
        if (i % 50 == 0) let_them_sleep();
        if (!order.arrive_and_wait() || !done.arrive_and_wait()) ++wrong;
        for (const int result : results) wrong += result == i ? 0 : 1;
      }
    });
    EXPECT_EQ(wrong, 0);
  }
}

TEST(Barrier, TheCompletionRunsOncePerPhaseAfterAllHaveArrivedAndBeforeAnyGoesOn) {
  const Watchdog watchdog;
  constexpr std::size_t kThreads = 7;
  constexpr int kPhases = 500;
  std::vector<int> done(kThreads, 0);
  int completions = 0;
  int early = 0;
  Barrier barrier(kThreads, [&] {
    ++completions;
    for (const int phase : done) early += phase == completions ? 0 : 1;
  });
  std::atomic<int> wrong{0};
  on_threads(kThreads, [&](std::size_t me) {
    for (int phase = 1; phase <= kPhases; ++phase) {
      done[me] = phase;
      (void)barrier.arrive_and_wait();
      if (completions != phase) ++wrong;  // the next one cannot run before this thread has arrived
    }
  });
  EXPECT_EQ(completions, kPhases);
  EXPECT_EQ(early, 0);
  EXPECT_EQ(wrong, 0);
}

TEST(Barrier, ThreadsThatSleepAreWoken) {
  const Watchdog watchdog;
  Barrier barrier(30);
  std::atomic<int> through{0};
  on_threads(30, [&](std::size_t me) {
    for (int phase = 0; phase < 4; ++phase) {
      if (me == 7) let_them_sleep();
      if (barrier.arrive_and_wait()) ++through;
    }
  });
  EXPECT_EQ(through, 120);
}

// Arrivals are spread over about the time in which a waiter gives up yielding and falls asleep, so
// that the end of the phase meets threads at every point on the way.
TEST(Barrier, NoWakeUpIsLostWhereThePhaseEndsAsThreadsFallAsleep) {
  const Watchdog watchdog;
  for (const std::size_t threads : {2U, 3U, 5U, 12U}) {
    Barrier barrier(threads);
    std::atomic<int> through{0};
    constexpr int kPhases = 1500;
    on_threads(threads, [&](std::size_t me) {
      std::minstd_rand random(static_cast<unsigned>(me + 1));
      std::uniform_int_distribution<int> wait(0, 12);
      for (int phase = 0; phase < kPhases; ++phase) {
        if (random() % threads == 0) {
          const auto until = std::chrono::steady_clock::now() + microseconds(wait(random));
          while (std::chrono::steady_clock::now() < until) continue;
        }
        if (barrier.arrive_and_wait()) ++through;
      }
    });
    EXPECT_EQ(through, static_cast<int>(threads) * kPhases);
  }
}

TEST(Barrier, TheNumberOfPhasesMayWrapAround) {
  const Watchdog watchdog;
  Barrier barrier(1);
  for (int i = 0; i < (1 << 24) - 3; ++i) ASSERT_TRUE(barrier.arrive_and_wait());
  barrier.join();
  int plain = 0;
  on_threads(2, [&](std::size_t me) {
    for (int i = 0; i < 10; ++i) {
      if (static_cast<int>(me) == i % 2) ++plain;
      EXPECT_TRUE(barrier.arrive_and_wait());
    }
  });
  EXPECT_EQ(plain, 10);
}

}  // namespace
}  // namespace carom::barrier_test
