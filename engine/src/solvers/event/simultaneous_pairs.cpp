#include "solvers/event/simultaneous_pairs.hpp"

#include <algorithm>

namespace carom::event {

bool has_pair(const std::vector<Pair>& pairs, Index i, Index j) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
    return (pair.first == i && pair.second == j) || (pair.first == j && pair.second == i);
  });
}

void SimultaneousPairs::reset(std::size_t balls) {
  waiting_.clear();
  linked_.clear();
  resolved_.clear();
  pressed_.clear();
  hits_.assign(balls, 0);
  hit_.clear();
}

}  // namespace carom::event
