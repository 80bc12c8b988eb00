#include "contact/pair_list.hpp"

namespace carom {

PairList all_pairs(const Balls& balls) {
  PairList pairs;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    pairs.make_room(balls.size());
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      pairs.put(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j),
                balls.radius[i] + balls.radius[j], !(balls.fixed(i) && balls.fixed(j)));
    }
  }
  return pairs;
}

}  // namespace carom
