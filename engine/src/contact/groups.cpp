#include "contact/groups.hpp"

#include <algorithm>
#include <limits>

namespace carom {

void Groups::sort(std::span<const Pair> pairs, std::size_t balls) {
  constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
  sets_.make_room(balls);
  group_of_.resize(balls);
  for (const Pair& pair : pairs) {
    for (const std::uint32_t ball : {pair.first, pair.second}) {
      sets_.isolate(ball);
      group_of_[ball] = kNone;
    }
  }
  for (const Pair& pair : pairs) sets_.merge(pair.first, pair.second);

  group_.resize(pairs.size());
  starts_.assign(1, 0);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    std::uint32_t& group = group_of_[sets_.find(pairs[k].first)];
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
