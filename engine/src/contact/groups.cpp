#include "contact/groups.hpp"

#include <algorithm>
#include <limits>

namespace carom {

// Path halving keeps the trees flat; the root is always the lowest ball of its tree.
std::uint32_t Groups::root(std::uint32_t ball) {
  while (parent_[ball] != ball) {
    parent_[ball] = parent_[parent_[ball]];
    ball = parent_[ball];
  }
  return ball;
}

void Groups::sort(std::span<const Pair> pairs, std::size_t balls) {
  constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
  parent_.resize(balls);
  group_of_.resize(balls);
  for (const Pair& pair : pairs) {
    for (const std::uint32_t ball : {pair.first, pair.second}) {
      parent_[ball] = ball;
      group_of_[ball] = kNone;
    }
  }
  for (const Pair& pair : pairs) {
    const std::uint32_t a = root(pair.first);
    const std::uint32_t b = root(pair.second);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  group_.resize(pairs.size());
  starts_.assign(1, 0);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    std::uint32_t& group = group_of_[root(pairs[k].first)];
    if (group == kNone) {
      group = static_cast<std::uint32_t>(starts_.size() - 1);
      starts_.push_back(0);
    }
    group_[k] = group;
    ++starts_[group + 1];
  }
  largest_ = 0;
  for (std::size_t g = 1; g < starts_.size(); ++g) {
    largest_ = std::max(largest_, starts_[g]);
    starts_[g] += starts_[g - 1];
  }
  pairs_.resize(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs_[starts_[group_[k]]++] = pairs[k];
  // Filling has moved each start on to the next group's.
  for (std::size_t g = starts_.size() - 1; g > 0; --g) starts_[g] = starts_[g - 1];
  starts_[0] = 0;
}

}  // namespace carom
