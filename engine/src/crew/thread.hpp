#pragma once

#include <pthread.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace carom {

/// A thread with a small stack, of which ten thousand fit; std::thread knows no stack size.
///
/// Holds: the thread runs until its function returns; the destructor waits for that.
/// Errors: std::system_error where the system gives no thread.  What the function throws ends the
/// program, so it throws nothing.
class Thread {
 public:
  /// Runs `body`, on `core` alone where one is given and may be used.
  explicit Thread(std::function<void()> body, std::optional<int> core = {});
  ~Thread();
  Thread(Thread&&) noexcept = default;
  Thread& operator=(Thread&&) = delete;
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

 private:
  std::unique_ptr<std::function<void()>> body_;  ///< empty once moved from: nothing to wait for
  pthread_t id_{};
};

/// The cores that this process may use, by the system's numbers; empty where it does not say.
std::vector<int> usable_cores();

}  // namespace carom
