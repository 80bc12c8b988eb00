#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/pair_list.hpp"
#include "contact/sleepers.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"

namespace carom::contact {

/// The pairs that will be of one island though they do not touch after the flight: what overlaps
/// then, or is beyond a wall, will be pushed back by as much, and pushes what is in its way.
class ForeseenLinks {
 public:
  ForeseenLinks(const Domain& domain, const Sleepers& sleepers)
      : domain_(domain), sleepers_(sleepers) {}

  /// Appends those of the `near` pairs, in their order, whose gap is less than `gap` and what
  /// either ball may be pushed together.  `out`: the balls beyond a wall.
  void find(const Balls& balls, std::span<const Pair> near, std::span<const std::uint32_t> out,
            double gap, std::vector<Pair>& linked);

 private:
  [[nodiscard]] double beyond_walls(const Balls& balls, std::uint32_t ball) const;

  const Domain& domain_;
  const Sleepers& sleepers_;
  std::vector<double> pushes_;  // by ball: how far contacts may push it; of those that are near
};

}  // namespace carom::contact
