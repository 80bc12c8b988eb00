// A hang is a thread that nobody lets go; a busy machine is none.
#include "unit/watchdog.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>

#include "carom/barrier.hpp"

namespace carom::watchdog_test {
namespace {

using std::chrono::milliseconds;

TEST(WatchdogDeathTest, EndsTheProgramWhereEveryThreadSleepsForGood) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the sanitizer has a thread of its own, which wakes up every 100 ms";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(
      {
        const test::Watchdog watchdog(milliseconds(20));
        Barrier barrier(2);
        (void)barrier.arrive_and_wait();
      },
      "the test hangs");
}

// Far more looks than it takes, none of which finds this thread asleep for good.
TEST(Watchdog, LetsAThreadComputeAndSleepForAsLongAsItTakes) {
  const test::Watchdog watchdog(milliseconds(1));
  timespec now{};
  do {
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  } while (now.tv_sec == 0 && now.tv_nsec < 300'000'000);
  for (int nap = 0; nap < 100; ++nap) std::this_thread::sleep_for(milliseconds(1));
}

}  // namespace
}  // namespace carom::watchdog_test
