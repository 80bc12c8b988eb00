#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>

#include "accuracy/timing.hpp"
#include "carom/accuracy.hpp"

namespace carom::accuracy {

/// Tells how far a study is, and ends it where that is asked.
class Announcer {
 public:
  explicit Announcer(const AccuracyRequest& request) : request_(request) {}

  /// `run` of `runs` is at hand, 0: none; `left`: wall-clock seconds, foreseen.
  /// Errors: StopAsked.
  void tell(const std::string& what, std::size_t run, std::size_t runs, double left) {
    if (request_.stopped && request_.stopped()) throw StopAsked();
    if (!request_.progress) return;
    const double spent = std::chrono::duration<double>(Clock::now() - started_).count();
    const double part = spent + left > 0 ? spent / (spent + left) : 0;
    farthest_ = std::max(farthest_, part);  // a bar does not go back
    request_.progress({run, runs, left, farthest_, what});
  }

 private:
  using Clock = std::chrono::steady_clock;

  const AccuracyRequest& request_;
  Clock::time_point started_ = Clock::now();
  double farthest_ = 0;
};

}  // namespace carom::accuracy
