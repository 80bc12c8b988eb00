#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace carom::test {

/// Runs `body(i)` on `count` threads and waits for them.
inline void on_threads(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < count; ++i) threads.emplace_back(body, i);
  for (std::thread& thread : threads) thread.join();
}

/// Long enough for a thread that waits to have gone through spins and yields, and to sleep.
inline void let_them_sleep() {
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace carom::test
