#pragma once

#include <cstddef>
#include <vector>

namespace carom {

/// The energy that impacts and drag have taken, ball by ball, so that no sum depends on who worked
/// when.
///
/// Threads: each ball's is written by one thread at a time.
class Losses {
 public:
  /// Of the balls there are; empty while nothing can be lost.
  std::vector<double> by_ball;

  [[nodiscard]] double sum() const;
  /// Keeps the sum, and starts by_ball again at 0 for `balls` balls.
  void restart(std::size_t balls);
  /// A ball is gone; what it lost stays.
  void remove(std::size_t ball);
  /// All that there is to go on from, as numbers, and the way back.
  [[nodiscard]] std::vector<double> numbers() const;
  void go_on_from(const std::vector<double>& numbers);

 private:
  double gone_ = 0;  // of balls that are gone
};

}  // namespace carom
