#include "solvers/overlap/group_rounds.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carom::overlap {
namespace {

constexpr int kRounds = 6;
// Of the smallest radius: an overlap that a shorter push leaves waits for the next step.
constexpr double kFar = 0.125;

}  // namespace

bool GroupRounds::join(std::size_t balls, double push, std::vector<Pair>& touching) {
  if (!(push > kFar * rules_.smallest_radius) || rounds_ >= kRounds) return false;
  if (rounds_ == 0) known_ = touching;
  const std::vector<Pair> found = pairs_.overlapping_after_pushes(rules_.step);
  std::vector<Pair> fresh;
  std::set_difference(found.begin(), found.end(), known_.begin(), known_.end(),
                      std::back_inserter(fresh));
  if (fresh.empty()) return false;
  std::vector<Pair> all;
  std::set_union(known_.begin(), known_.end(), fresh.begin(), fresh.end(), std::back_inserter(all));
  groups_.sort(all, balls);
  touching.clear();
  for (std::size_t g = 0; g < groups_.count(); ++g) {
    const auto group = groups_.group(g);
    const bool grown = std::any_of(group.begin(), group.end(), [&](const Pair& pair) {
      return std::binary_search(fresh.begin(), fresh.end(), pair);
    });
    if (grown) touching.insert(touching.end(), group.begin(), group.end());
  }
  std::sort(touching.begin(), touching.end());
  known_ = std::move(all);
  ++rounds_;
  return true;
}

}  // namespace carom::overlap
