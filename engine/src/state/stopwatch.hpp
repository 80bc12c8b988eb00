#pragma once

#include <chrono>

namespace carom {

/// Adds the seconds of its scope to a sum, if it is asked to.
class Stopwatch {
 public:
  Stopwatch(bool runs, double& sum) : sum_(runs ? &sum : nullptr) {
    if (runs) start_ = Clock::now();
  }
  ~Stopwatch() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double* sum_;
  Clock::time_point start_;
};

}  // namespace carom
