#include "contact/foreseen_links.hpp"

#include <algorithm>

#include "contact/ball_gap.hpp"
#include "contact/pushes.hpp"

namespace carom::contact {

double ForeseenLinks::beyond_walls(const Balls& balls, std::uint32_t ball) const {
  double farthest = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain_.solid(axis)) continue;
    const double x = balls.position[axis][ball];
    const double radius = balls.radius[ball];
    farthest =
        std::max({farthest, domain_.lowest(axis, radius) - x, x - domain_.highest(axis, radius)});
  }
  return farthest;
}

void ForeseenLinks::find(const Balls& balls, std::span<const Pair> near,
                         std::span<const std::uint32_t> out, double gap,
                         std::vector<Pair>& linked) {
  pushes_.resize(balls.size());
  std::vector<Pair> pairs;
  std::vector<double> gaps;
  for (const Pair& pair : near) pushes_[pair.first] = pushes_[pair.second] = 0;
  for (const std::uint32_t ball : out) pushes_[ball] = beyond_walls(balls, ball);
  bool any = !out.empty();
  for (const Pair& pair : near) {
    const bool first = sleepers_.moves(balls, pair.first);
    const bool second = sleepers_.moves(balls, pair.second);
    if (!first && !second) continue;
    const double reach = balls.radius[pair.first] + balls.radius[pair.second];
    const double apart = way_between(balls, pair, domain_).norm() - reach;
    if (apart < 0) {
      any = true;
      if (first) pushes_[pair.first] = std::max(pushes_[pair.first], -apart);
      if (second) pushes_[pair.second] = std::max(pushes_[pair.second], -apart);
    }
    if (!first || !second) continue;
    pairs.push_back(pair);
    gaps.push_back(apart);
  }
  if (!any) return;
  pass_on_pushes(pairs, gaps, pushes_);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double push = std::max(pushes_[pairs[k].first], pushes_[pairs[k].second]);
    if (gaps[k] < gap + push) linked.push_back(pairs[k]);
  }
}

}  // namespace carom::contact
