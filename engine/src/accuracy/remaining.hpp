#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace carom::accuracy {

/// How far a study is: what it has taken, and what is foreseen of the rest.
class Remaining {
 public:
  using Told = std::function<void(double part, double left, const std::string& what)>;

  explicit Remaining(Told told) : told_(std::move(told)) {}

  /// Says what is being done and how many seconds it and the rest will take.
  void tell(double left, const std::string& what) {
    if (!told_) return;
    const double spent = std::chrono::duration<double>(Clock::now() - started_).count();
    const double part = spent + left > 0 ? spent / (spent + left) : 0;
    farthest_ = part > farthest_ ? part : farthest_;  // a bar does not go back
    told_(farthest_, left, what);
  }

 private:
  using Clock = std::chrono::steady_clock;

  Told told_;
  Clock::time_point started_ = Clock::now();
  double farthest_ = 0;
};

}  // namespace carom::accuracy
