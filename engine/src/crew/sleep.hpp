#pragma once

#include <atomic>
#include <cstdint>

#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace carom {

/// Sleeping on an atomic word, as std::atomic::wait does, but without the pauses and yields that
/// the library puts before it, and with a number of sleepers to wake.
///
/// Source: futex(2).  Where there are no futexes the standard library's wait does the same, slower.
struct BarrierSystem {
  /// Sleeps unless `word` differs from `expected`.  May return early: the caller looks again.
  static void sleep_while_equal(std::atomic<std::uint32_t>& word, std::uint32_t expected) {
#ifdef __linux__
    static_assert(sizeof(word) == sizeof(std::uint32_t));
    syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, expected, nullptr, nullptr, 0);
#else
    word.wait(expected);
#endif
  }

  /// Wakes up to `count` of those who sleep on `word`.
  static void wake(std::atomic<std::uint32_t>& word, int count) {
#ifdef __linux__
    syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, count, nullptr, nullptr, 0);
#else
    (void)count;
    word.notify_all();
#endif
  }

  // Where a test holds a thread; nothing here.
  static void before_counting_a_sleeper() {}
  static void between_word_and_sleepers() {}
};

}  // namespace carom
