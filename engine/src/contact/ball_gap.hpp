#pragma once

#include "contact/pair_list.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"

namespace carom::contact {

/// From the centre of a pair's first ball to that of its second, the shorter way round periodic
/// axes.
inline Vec2 way_between(const Balls& balls, const Pair& pair, const Domain& domain) {
  return nearest_image(balls.at(pair.second) - balls.at(pair.first), domain);
}

/// Whether the gap between two balls is less than `gap`.
inline bool closer_than(double gap, const Balls& balls, const Pair& pair, const Domain& domain) {
  const double reach = balls.radius[pair.first] + balls.radius[pair.second] + gap;
  return way_between(balls, pair, domain).squaredNorm() < reach * reach;
}

inline bool overlap(const Balls& balls, const Pair& pair, const Domain& domain) {
  return closer_than(0, balls, pair, domain);
}

}  // namespace carom::contact
