// Parties that join a barrier and leave it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "carom/barrier.hpp"
#include "unit/threads.hpp"
#include "unit/watchdog.hpp"

namespace carom::barrier_parties_test {
namespace {

using test::let_them_sleep;
using test::on_threads;
using test::Watchdog;

TEST(Barrier, APartyThatJoinsIsWaitedForFromTheOpenPhaseOn) {
  const Watchdog watchdog;
  int completions = 0;
  Barrier barrier(2, [&] { ++completions; });
  std::atomic<int> through{0};
  std::thread first([&] {
    if (barrier.arrive_and_wait()) ++through;
  });
  let_them_sleep();
  barrier.join();
  EXPECT_EQ(barrier.parties(), 3U);
  std::thread second([&] {
    if (barrier.arrive_and_wait()) ++through;
  });
  let_them_sleep();
  EXPECT_EQ(through, 0);
  EXPECT_TRUE(barrier.arrive_and_wait());
  first.join();
  second.join();
  EXPECT_EQ(completions, 1);
  EXPECT_EQ(through, 2);
}

TEST(Barrier, LeavingEndsThePhaseAndRunsTheCompletionWhereAllOthersWait) {
  const Watchdog watchdog;
  int completions = 0;
  Barrier barrier(3, [&] { ++completions; });
  std::atomic<int> through{0};
  std::thread others([&] {
    on_threads(2, [&](std::size_t) {
      if (barrier.arrive_and_wait()) ++through;
    });
  });
  let_them_sleep();
  EXPECT_EQ(through, 0);
  barrier.leave();
  others.join();
  EXPECT_EQ(through, 2);
  EXPECT_EQ(completions, 1);
  EXPECT_EQ(barrier.parties(), 2U);
}

TEST(Barrier, TheLastToLeaveRunsTheCompletionItself) {
  std::thread::id ran_in;
  Barrier barrier(1, [&] { ran_in = std::this_thread::get_id(); });
  barrier.leave();
  EXPECT_EQ(ran_in, std::this_thread::get_id());
  EXPECT_EQ(barrier.parties(), 0U);
}

TEST(Barrier, LeavingWhileOthersAreStillToArriveEndsNothing) {
  int completions = 0;
  Barrier barrier(2, [&] { ++completions; });
  barrier.leave();
  EXPECT_EQ(completions, 0);
  EXPECT_TRUE(barrier.arrive_and_wait());
  EXPECT_EQ(completions, 1);
}

TEST(Barrier, TheLastPartyMayLeaveAndOthersMeetAfter) {
  const Watchdog watchdog;
  int completions = 0;
  Barrier barrier(1, [&] { ++completions; });
  barrier.leave();
  EXPECT_EQ(completions, 1);
  EXPECT_EQ(barrier.parties(), 0U);
  barrier.join();
  barrier.join();
  on_threads(2, [&](std::size_t) { EXPECT_TRUE(barrier.arrive_and_wait()); });
  EXPECT_EQ(completions, 2);
}

TEST(Barrier, CompletionsDoNotOverlapWhereTheOnlyPartyLeavesAndAnotherComes) {
  const Watchdog watchdog;
  std::atomic<int> inside{0};
  std::atomic<bool> overlap{false};
  Barrier barrier(1, [&] {
    if (++inside > 1) overlap = true;
    let_them_sleep();
    --inside;
  });
  std::thread leaver([&] { barrier.leave(); });
  while (inside == 0) std::this_thread::yield();
  barrier.join();
  EXPECT_TRUE(barrier.arrive_and_wait());
  leaver.join();
  EXPECT_FALSE(overlap);
}

// Three threads go on without a break; guests come, take part in a few phases and leave again.
TEST(Barrier, PartiesJoinAndLeaveWhileOthersRun) {
  const Watchdog watchdog;
  constexpr int kPhases = 400;
  constexpr int kGuestPhases = 5;
  int completions = 0;
  std::size_t most = 0;
  std::atomic<int> wrong{0};
  std::vector<std::thread> guests;
  Barrier* meeting = nullptr;
  Barrier barrier(3, [&] {
    ++completions;
    most = std::max(most, meeting->parties());
  });
  meeting = &barrier;
  on_threads(3, [&](std::size_t me) {
    for (int phase = 1; phase <= kPhases; ++phase) {
      // Not arrived yet, so that the guest belongs to this very phase.
      if (me == 0 && phase % 3 == 0 && phase + kGuestPhases < kPhases) {
        barrier.join();
        guests.emplace_back([&, phase] {
          for (int i = 0; i < kGuestPhases; ++i) {
            if (!barrier.arrive_and_wait() || completions != phase + i) ++wrong;
          }
          barrier.leave();
        });
      }
      if (!barrier.arrive_and_wait() || completions != phase) ++wrong;
    }
  });
  for (std::thread& guest : guests) guest.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(completions, kPhases);
  EXPECT_EQ(barrier.parties(), 3U);
  EXPECT_GT(most, 3U);
}

}  // namespace
}  // namespace carom::barrier_parties_test
