// The end of a phase meets a thread that falls asleep, at each point of its way: threads are held
// there, and sleep in the test's hands, so that nothing depends on time.
#include <gtest/gtest.h>

#include <climits>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "crew/basic_barrier.hpp"

namespace carom::barrier_hold_test {
namespace {

/// The two threads' system: a thread sleeps here until it is woken, and waits at a point of its way
/// until the other one has done its part.
class Stage {
 public:
  void sleep_while_equal(std::atomic<std::uint32_t>& word, std::uint32_t expected) {
    std::unique_lock lock(mutex_);
    tried_to_sleep_ = true;
    changed_.notify_all();
    if (word.load() != expected) return;
    ++sleeping_;
    changed_.wait(lock, [this] { return woken_ > 0; });
    --woken_;
    --sleeping_;
  }
  void wake(int count) {
    const std::scoped_lock lock(mutex_);
    woken_ += std::min(count, sleeping_ - woken_);
    changed_.notify_all();
  }

  void reach_counting() {
    const std::scoped_lock lock(mutex_);
    about_to_count_ = true;
    changed_.notify_all();
  }
  void wait_for_counting() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return about_to_count_; });
  }

  void hold_sleeper(bool held) {
    const std::scoped_lock lock(mutex_);
    held_ = held;
    changed_.notify_all();
  }
  void wait_while_held() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !held_; });
  }
  /// Until the other thread sleeps, or has seen that it need not, or is on its way out.
  void wait_for_sleeper() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return tried_to_sleep_ || out_; });
  }
  void leave() {
    const std::scoped_lock lock(mutex_);
    out_ = true;
    changed_.notify_all();
  }
  /// Whether a thread sleeps that was not woken.
  bool left_asleep() {
    const std::scoped_lock lock(mutex_);
    return sleeping_ > woken_;
  }

  bool lets_sleep_between = false;  ///< the sleeper goes on between the two moves of the end

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool about_to_count_ = false;
  bool held_ = false;
  bool tried_to_sleep_ = false;
  bool out_ = false;
  int sleeping_ = 0;
  int woken_ = 0;
};

Stage* stage = nullptr;

struct HeldSystem {
  static void sleep_while_equal(std::atomic<std::uint32_t>& word, std::uint32_t expected) {
    stage->sleep_while_equal(word, expected);
  }
  static void wake(std::atomic<std::uint32_t>&, int count) { stage->wake(count); }
  static void before_counting_a_sleeper() {
    stage->reach_counting();
    stage->wait_while_held();
  }
  static void between_word_and_sleepers() {
    if (!stage->lets_sleep_between) return;
    stage->hold_sleeper(false);
    stage->wait_for_sleeper();
  }
};

class BarrierHeld : public testing::Test {
 protected:
  void SetUp() override { stage = &stage_; }
  void TearDown() override { stage = nullptr; }

  /// Starts a thread that waits at the barrier.
  std::thread sleeper() {
    return std::thread([this] {
      through_ = barrier_.arrive_and_wait();
      stage_.leave();
    });
  }
  /// The phase is over: the thread that waits must be on its way without more help.
  void expect_woken(std::thread& sleeper) {
    EXPECT_FALSE(stage_.left_asleep()) << "the wake-up is lost";
    stage_.wake(INT_MAX);
    sleeper.join();
    EXPECT_TRUE(through_);
  }

  Stage stage_;
  BasicBarrier<HeldSystem> barrier_{2};
  bool through_ = false;
};

// Seen to fail: with the sleepers looked at before the word moves.
TEST_F(BarrierHeld, NoWakeUpIsLostWhereASleeperIsCountedBetweenTheTwoMovesOfTheEnd) {
  stage_.hold_sleeper(true);
  stage_.lets_sleep_between = true;
  std::thread other = sleeper();
  stage_.wait_for_counting();
  EXPECT_TRUE(barrier_.arrive_and_wait());
  expect_woken(other);
}

// Seen to fail: with a sleeper that does not look at the word again once it is counted.
TEST_F(BarrierHeld, NoWakeUpIsLostWhereThePhaseEndsBeforeTheSleeperIsCounted) {
  stage_.hold_sleeper(true);
  std::thread other = sleeper();
  stage_.wait_for_counting();
  EXPECT_TRUE(barrier_.arrive_and_wait());
  stage_.hold_sleeper(false);
  stage_.wait_for_sleeper();
  expect_woken(other);
}

// Seen to fail: with an end that wakes nobody.
TEST_F(BarrierHeld, ASleeperIsWoken) {
  std::thread other = sleeper();
  stage_.wait_for_sleeper();
  EXPECT_TRUE(barrier_.arrive_and_wait());
  expect_woken(other);
}

}  // namespace
}  // namespace carom::barrier_hold_test
