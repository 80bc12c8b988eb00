#include "state/losses.hpp"

#include <algorithm>
#include <numeric>

namespace carom {

double Losses::sum() const {
  return std::accumulate(by_ball.begin(), by_ball.end(), gone_);
}

void Losses::restart(std::size_t balls) {
  gone_ = sum();
  by_ball.assign(balls, 0.0);
}

void Losses::remove(std::size_t ball) {
  if (by_ball.empty()) return;
  gone_ += by_ball[ball];
  by_ball.erase(by_ball.begin() + static_cast<std::ptrdiff_t>(ball));
}

std::vector<double> Losses::numbers() const {
  std::vector<double> numbers{gone_};
  numbers.insert(numbers.end(), by_ball.begin(), by_ball.end());
  return numbers;
}

void Losses::go_on_from(const std::vector<double>& numbers) {
  if (numbers.empty()) return;
  gone_ = numbers.front();
  if (numbers.size() == by_ball.size() + 1) {
    std::copy(numbers.begin() + 1, numbers.end(), by_ball.begin());
  }
}

}  // namespace carom
