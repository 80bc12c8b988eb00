#include "contact/pair_list.hpp"

namespace carom {

PairList all_pairs(const Balls& balls) {
  PairList pairs;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = i + 1; j < balls.size(); ++j) {
      if (balls.fixed(i) && balls.fixed(j)) continue;
      pairs.add(i, j, balls.radius[Balls::index(i)] + balls.radius[Balls::index(j)]);
    }
  }
  return pairs;
}

}  // namespace carom
