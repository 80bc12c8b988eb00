#include "contact/pushes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace carom::contact {

// The largest over all chains of balls, so any order of the pairs ends at the same: to and fro is
// quick, as pairs are mostly sorted.
void pass_on_pushes(std::span<const Pair> pairs, std::span<const double> gaps,
                    std::vector<double>& pushes) {
  bool more = false;
  const auto pass = [&](std::size_t k) {
    const double gap = std::max(gaps[k], 0.0);
    double& first = pushes[pairs[k].first];
    double& second = pushes[pairs[k].second];
    if (first - gap > second) {
      second = first - gap;
      more = true;
    } else if (second - gap > first) {
      first = second - gap;
      more = true;
    }
  };
  do {
    more = false;
    for (std::size_t k = 0; k < pairs.size(); ++k) pass(k);
    for (std::size_t k = pairs.size(); k-- > 0;) pass(k);
  } while (more);
}

}  // namespace carom::contact
