#pragma once

#include <dirent.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>

namespace carom::test {

/// Ends the program, aloud, where a test hangs: where every other thread of the process has slept
/// through a number of looks.  A thread that waits for a core does not sleep, however long it takes
/// on a busy machine; one that sleeps for a while has moved on at the next look.
class Watchdog {
 public:
  explicit Watchdog(std::chrono::milliseconds between_looks = std::chrono::seconds(1))
      : thread_([this, between_looks] { watch(between_looks); }) {}
  ~Watchdog() {
    {
      const std::scoped_lock lock(mutex_);
      done_ = true;
    }
    over_.notify_one();
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  static constexpr int kLooks = 10;

  void watch(std::chrono::milliseconds between_looks) {
    std::string before;
    int same = 0;
    std::unique_lock lock(mutex_);
    while (!over_.wait_for(lock, between_looks, [this] { return done_; })) {
      const std::string now = sleepers();
      same = !now.empty() && now == before ? same + 1 : 0;
      before = now;
      if (same < kLooks) continue;
      std::fputs("the test hangs: a thread was never let go\n", stderr);
      std::abort();
    }
  }

  /// Every other thread, with how often it has fallen asleep; empty where one is not asleep.
  static std::string sleepers() {
    std::string all;
    DIR* tasks = opendir("/proc/self/task");
    while (const dirent* entry = readdir(tasks)) {
      const std::string id = entry->d_name;
      if (id.front() == '.' || id == std::to_string(gettid())) continue;
      std::ifstream status("/proc/self/task/" + id + "/status");
      for (std::string line; std::getline(status, line);) {
        if (line.starts_with("State:") && line.find("(sleeping)") == line.npos) {
          closedir(tasks);
          return {};
        }
        if (line.starts_with("voluntary_ctxt_switches"))
          all.append(id).append(" ").append(line).append("\n");
      }
    }
    closedir(tasks);
    return all;
  }

  std::mutex mutex_;
  std::condition_variable over_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace carom::test
