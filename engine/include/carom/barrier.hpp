#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace carom {

/// A reusable meeting point of any number of threads.
///
/// A phase ends when every party has arrived; the last to arrive runs the completion, then all go
/// on. Everything a party did before arriving happens before the completion, and the completion
/// happens before everything any party does after leaving the phase (release on arrival, acquire on
/// leaving).
///
/// Threads: every member may be called by any thread; a thread that waits is one party.
class Barrier {
 public:
  explicit Barrier(std::size_t parties, std::function<void()> completion = {});
  ~Barrier();
  Barrier(const Barrier&) = delete;
  Barrier& operator=(const Barrier&) = delete;

  /// Arrives and waits for the others; false once the barrier is cancelled.
  [[nodiscard]] bool arrive_and_wait();
  /// One party more, from the present phase on.  REQUIRES: the present phase cannot end meanwhile
  /// (the caller is a party that has not arrived), or nobody waits.
  void join();
  /// One party fewer; counts as the arrival of the party that leaves.
  void leave();
  /// Releases everybody, now and for good.
  void cancel();

  [[nodiscard]] std::size_t parties() const;
  [[nodiscard]] bool cancelled() const;

 private:
  void end_phase();

  std::function<void()> completion_;
  std::atomic<std::size_t> parties_;
  std::atomic<std::size_t> arrived_{0};
  std::atomic<std::uint32_t> phase_{0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace carom
