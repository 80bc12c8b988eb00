#include "carom/crew.hpp"

#include <dirent.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "unit/watchdog.hpp"

namespace carom::crew_test {
namespace {

using test::Watchdog;

std::size_t threads_of_this_process() {
  std::size_t count = 0;
  DIR* tasks = opendir("/proc/self/task");
  while (const dirent* entry = readdir(tasks)) count += entry->d_name[0] != '.' ? 1 : 0;
  closedir(tasks);
  return count;
}

/// Waits until the process has that many threads: a thread that was joined stays listed for a
/// moment.
bool threads_become(std::size_t expected) {
  for (int i = 0; i < 500 && threads_of_this_process() != expected; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return threads_of_this_process() == expected;
}

Phase one_phase(std::string name, std::function<void(Share)> work) {
  return {std::move(name), std::move(work), [] { return Phase::kFrameDone; }};
}

TEST(Share, SharesMeetWithoutGapAndDifferByOneAtMost) {
  for (const std::size_t n : {0U, 1U, 7U, 1000U}) {
    for (const std::size_t count : {1U, 3U, 7U, 50U}) {
      std::size_t next = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const Share share{i, count};
        EXPECT_EQ(share.begin(n), next);
        next = share.end(n);
        EXPECT_LE(next - share.begin(n), n / count + 1);
        EXPECT_GE(next - share.begin(n), n / count);
      }
      EXPECT_EQ(next, n);
    }
  }
}

// Plain numbers, on purpose: where a phase begins before the one before has ended everywhere, the
// sums differ, and the thread sanitizer sees a race.
TEST(Crew, KnowsWhatItsWorkersHaveComputedWhereTheyCanWaitForEachOther) {
  const auto work = [](Share share) {
    volatile double sum = 0;
    for (int k = 0; share.index == 0 && k < 100000; ++k) sum = sum + k;
  };
  const std::vector<Phase> phases{{"work", work, [] { return Phase::kFrameDone; }}};
  Crew alone(1, phases);
  alone.do_frame();
  EXPECT_EQ(alone.effort().computing, 0);
  Crew three(3, phases);
  three.do_frame();
  EXPECT_GT(three.effort().computing, 0);
  EXPECT_LE(three.effort().computing, 3 * three.effort().frames);
}

TEST(Crew, APhaseSeesAllThatTheOneBeforeHasDone) {
  const Watchdog watchdog;
  for (const std::size_t workers : {1U, 2U, 3U, 7U, 40U}) {
    std::vector<long> a(workers, 0);
    std::vector<long> b(workers, 0);
    int steps = 0;
    Crew crew(workers,
              {{"wall_computation", [&](Share share) { a[share.index] += 1; },
                [] { return std::size_t{1}; }},
               {"pair_computation",
                [&](Share share) { b[share.index] = std::accumulate(a.begin(), a.end(), 0L); },
                [&] { return ++steps % 5 == 0 ? Phase::kFrameDone : std::size_t{0}; }}});
    for (int frame = 1; frame <= 20; ++frame) {
      crew.do_frame();
      ASSERT_EQ(steps, 5 * frame);
      const long expected = static_cast<long>(workers) * steps;
      for (const long sum : b) ASSERT_EQ(sum, expected);
    }
  }
}

TEST(Crew, AFrameMayBeginWithAnyPhase) {
  std::string order;
  Crew crew(2, {{"first", [](Share) {}, [&] { return order += '0', std::size_t{1}; }},
                {"second", [](Share) {}, [&] { return order += '1', Phase::kFrameDone; }}});
  crew.do_frame(1);
  crew.do_frame();
  EXPECT_EQ(order, "101");
}

TEST(Crew, ItsBarriersAreDoFrameOneForEachPhaseAndFrameDone) {
  Crew crew(3, {one_phase("wall_computation", [](Share) {})});
  const auto expect = [&](std::size_t workers) {
    const std::vector<BarrierStatus> barriers = crew.barriers();
    ASSERT_EQ(barriers.size(), 3U);
    EXPECT_EQ(barriers[0].name, "do_frame");
    EXPECT_EQ(barriers[1].name, "wall_computation");
    EXPECT_EQ(barriers[2].name, "frame_done");
    EXPECT_EQ(barriers[0].parties, workers + 1);  // the control thread too
    EXPECT_EQ(barriers[1].parties, workers);      // the workers alone
    EXPECT_EQ(barriers[2].parties, workers + 1);
  };
  expect(3);
  crew.resize(5);
  expect(5);
  crew.resize(2);
  expect(2);
}

TEST(Crew, ResizingStartsAndEndsJustTheDifference) {
  const Watchdog watchdog;
  const std::size_t others = threads_of_this_process();
  std::vector<pthread_t> ids(16);
  std::atomic<std::size_t> count{0};
  Crew crew(4, {one_phase("wall_computation", [&](Share share) {
              ids.at(share.index) = pthread_self();
              count = share.count;
            })});
  crew.do_frame();
  const std::vector<pthread_t> before = ids;
  EXPECT_TRUE(threads_become(others + 4));

  const auto expect = [&](std::size_t workers) {
    crew.resize(workers);
    EXPECT_EQ(crew.workers(), workers);
    EXPECT_TRUE(threads_become(others + workers));
    crew.do_frame();
    EXPECT_EQ(count, workers);
    for (std::size_t i = 0; i < std::min<std::size_t>(workers, 4); ++i) {
      EXPECT_TRUE(pthread_equal(ids[i], before[i])) << "worker " << i << " was started again";
    }
  };
  for (const std::size_t workers : {5U, 16U, 15U, 15U, 4U}) expect(workers);
  crew.resize(0);
  EXPECT_EQ(crew.workers(), 1U);
  crew.do_frame();
}

TEST(Crew, ResizingBetweenManyFramesNeverHangs) {
  const Watchdog watchdog;
  std::vector<int> seen(32, 0);
  Crew crew(1, {one_phase("wall_computation", [&](Share share) { ++seen[share.index]; })});
  long expected = 0;
  for (std::size_t i = 0; i < 150; ++i) {
    const std::size_t workers = 1 + (i * 7) % 32;
    crew.resize(workers);
    crew.do_frame();
    expected += static_cast<long>(workers);
  }
  EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0L), expected);
}

TEST(Crew, WhatAWorkerThrowsIsRethrownByDoFrameAndAllWorkersEnd) {
  const Watchdog watchdog;
  const std::size_t others = threads_of_this_process();
  for (const std::size_t workers : {1U, 2U, 30U}) {
    int frame = 0;
    Crew crew(workers, {{"wall_computation", [](Share) {}, [] { return std::size_t{1}; }},
                        one_phase("pair_computation", [&](Share share) {
                          if (frame == 3 && share.index + 1 == share.count) {
                            throw std::runtime_error("no more");
                          }
                        })});
    for (frame = 0; frame < 3; ++frame) crew.do_frame();
    for (int again = 0; again < 2; ++again) {
      try {
        crew.do_frame();
        FAIL() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "no more");
      }
      EXPECT_TRUE(threads_become(others));
    }
  }
}

TEST(Crew, OfSeveralFailuresTheOneOfTheLowestWorkerIsRethrown) {
  const Watchdog watchdog;
  for (int round = 0; round < 20; ++round) {
    Crew crew(9, {one_phase("wall_computation", [](Share share) {
                if (share.index >= 2) throw std::runtime_error(std::to_string(share.index));
              })});
    try {
      crew.do_frame();
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "2");
    }
  }
}

TEST(Crew, WhatTheEndOfAPhaseThrowsIsRethrownToo) {
  const Watchdog watchdog;
  Crew crew(5, {{"wall_computation", [](Share) {},
                 []() -> std::size_t { throw std::runtime_error("finish"); }}});
  EXPECT_THROW(crew.do_frame(), std::runtime_error);
}

TEST(Crew, TimeIsKeptForEachPhase) {
  Crew crew(2, {{"quick", [](Share) {}, [] { return std::size_t{1}; }},
                one_phase("slow", [](Share share) {
                  if (share.index == 0) std::this_thread::sleep_for(std::chrono::milliseconds(30));
                })});
  crew.do_frame();
  const Seconds spent = crew.seconds();
  ASSERT_EQ(spent.size(), 2U);
  EXPECT_EQ(spent[0].first, "quick");
  EXPECT_EQ(spent[1].first, "slow");
  EXPECT_GE(spent[1].second, 0.03);
  EXPECT_GE(spent[0].second, 0.0);
}

#if defined(__SANITIZE_THREAD__)
constexpr std::size_t kMany = 2000;  // the sanitizer itself ends at some 8,000 threads
#else
constexpr std::size_t kMany = 10000;
#endif

TEST(Crew, TenThousandWorkersStartAndComputeAFrame) {
  const Watchdog watchdog;
  std::vector<int> seen(kMany, 0);
  Crew crew(kMany, {one_phase("wall_computation", [&](Share share) { ++seen[share.index]; })});
  EXPECT_EQ(crew.workers(), kMany);
  crew.do_frame();
  EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), std::size_t{0}), kMany);
}

/// In a process that may have few threads: what a crew of 50 says, then whether smaller ones work.
[[noreturn]] void live_with_few_threads() {
  if (geteuid() == 0 && setuid(61234) != 0)
    std::exit(3);  // root has no limit; nobody else is 61234
  const rlimit limit{20, 20};
  if (setrlimit(RLIMIT_NPROC, &limit) != 0) std::exit(4);
  std::thread([] {}).join();  // a sanitizer starts threads of its own with the first one
  const std::size_t others = threads_of_this_process();
  const auto phases = [] { return std::vector{one_phase("wall_computation", [](Share) {})}; };
  std::string first;
  try {
    Crew crew(50, phases());
    std::exit(5);
  } catch (const CrewError& error) {
    first = error.what();
  }
  if (!threads_become(others)) std::exit(6);
  if (getuid() == 61234) {
    Crew crew(4, phases());
    try {
      crew.resize(50);
      std::exit(7);
    } catch (const CrewError&) {
      if (crew.workers() != 4 || !threads_become(others + 4)) std::exit(8);
      crew.do_frame();
      crew.resize(5);
      crew.do_frame();
    }
  }
  std::fprintf(stderr, "%s\n", first.c_str());
  std::exit(0);
}

TEST(Crew, WhereTheSystemRefusesThreadsOneLineSaysHowManyThereWereAndWhatCuresIt) {
  EXPECT_EXIT(live_with_few_threads(), testing::ExitedWithCode(0),
              "^the system gave only 1?[0-9] of 50 worker threads \\([^)]+\\): use fewer, as in "
              "--workers 2\n$");
}

}  // namespace
}  // namespace carom::crew_test
