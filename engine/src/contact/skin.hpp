#pragma once

#include "state/balls.hpp"
#include "state/domain.hpp"

namespace carom {

/// How far apart balls are taken for neighbours.
struct Skin {
  double thickness = 0;  ///< between two balls
  double reach = 0;      ///< between the centres of the two largest balls that are neighbours
};

/// The skin that makes a neighbour list cheapest: a thick one has more pairs to test at each step,
/// a thin one is rebuilt more often.  It depends on density, speed and step alone; the result of a
/// run does not depend on it.
Skin choose_skin(const Balls& balls, const Domain& domain, double step);

}  // namespace carom
