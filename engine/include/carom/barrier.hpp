#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace carom {

/// How the threads of a barrier sleep and wake.
struct BarrierSystem;

/// A reusable meeting point of any number of threads.
///
/// A phase ends when every party has arrived; the last to arrive runs the completion, then all go
/// on.  A thread that waits spins while the parties do not outnumber the cores, then yields a few
/// times, then sleeps.  Where other programs have been seen to take the turns that yields give away
/// it does not yield, for a while.
///
/// Threads: every member may be called by any thread; a thread that waits is one party.
/// Memory order: what a party did before it arrived (or left) happens before the completion of that
/// phase, and the completion happens before everything a party does after the phase.  Completions
/// never overlap.  What happened before cancel() happens before anything done by a thread that
/// learns of it.
/// Holds: 0 <= arrived < parties whenever nobody is inside a member function.
/// System: BarrierSystem, or what a test puts in its place to hold a thread between two moves.
/// Errors: what the completion throws cancels the barrier and is rethrown to the thread that ran
/// it.
/// REQUIRES: destroyed only when no thread is inside a member function.
template <class System>
class BasicBarrier {
 public:
  static constexpr std::size_t kMostParties = (std::size_t{1} << 20) - 1;

  explicit BasicBarrier(std::size_t parties, std::function<void()> completion = {});
  ~BasicBarrier();
  BasicBarrier(const BasicBarrier&) = delete;
  BasicBarrier& operator=(const BasicBarrier&) = delete;

  /// Arrives and waits for the others.  True where the phase ended; false where the barrier was
  /// cancelled before: a party that is slow to wake up from a phase that ended is told so.
  [[nodiscard]] bool arrive_and_wait();
  /// Arrives and goes on without the others.  False where the barrier was cancelled before.
  /// REQUIRES: the party does not arrive again before this phase has ended.
  [[nodiscard]] bool arrive();
  /// One party more: the phase that is open now does not end before it has arrived.
  void join();
  /// One party fewer; counts as the arrival of the party that leaves, and ends the phase (running
  /// the completion here) if all others have arrived.
  /// REQUIRES: that party is not waiting.
  void leave();
  /// Releases everybody, now and for good.
  void cancel();

  [[nodiscard]] std::size_t parties() const;
  [[nodiscard]] bool cancelled() const;

 private:
  /// Where the parties of every other phase wait: those still on their way out of one phase and
  /// those already waiting in the next are never mixed up.
  struct alignas(64) Gate {
    std::atomic<std::uint32_t>
        word;  ///< twice the number of the phase last let out + 1, + cancelled
    std::atomic<std::uint32_t> sleepers{0};
  };

  /// `await`: does not return before the phase has ended.
  [[nodiscard]] bool arrive(bool await);
  [[nodiscard]] bool wait(Gate& gate, std::uint64_t arrival);
  [[nodiscard]] int yields_of(std::size_t parties);
  [[nodiscard]] bool yield_was_long();
  void learn_to_spin(int spins, bool in_vain);
  [[nodiscard]] bool end_phase(std::uint32_t phase);

  std::function<void()> completion_;
  /// Phase, parties and arrived in one word, so that arriving, joining and leaving are each one
  /// indivisible step.
  alignas(64) std::atomic<std::uint64_t> state_;
  std::array<Gate, 2> gates_;
  std::atomic<int> spins_;          ///< that a wait begins with
  std::atomic<int> unyielding_{0};  ///< waits to come that do not yield
};

extern template class BasicBarrier<BarrierSystem>;
using Barrier = BasicBarrier<BarrierSystem>;

}  // namespace carom
