#pragma once

#include <cstddef>

#include "carom/effects.hpp"

namespace carom::overlap {

/// Which pairs method `overlap` looks at, and which phases its workers have: what the size of a
/// scene calls for when it starts.
///
/// A phase that would never be entered is not there, nor is its barrier; what it would do is done
/// between two phases by the worker that arrives last.  The pairs follow the number of balls as it
/// changes, the phases stay: none of it changes the result.
struct Plan {
  static constexpr std::size_t kManyBalls = 64;       ///< from here on a list of neighbours pays
  static constexpr std::size_t kSharedSearch = 2048;  ///< balls whose neighbours are worth sharing
  static constexpr std::size_t kSharedPairs = 256;    ///< touching pairs worth sharing
  static constexpr std::size_t kFewWorkers = 16;      ///< for more, meeting costs more than sharing

  bool pairs = false;              ///< balls collide at all
  bool neighbour_list = false;     ///< else all pairs are cached once
  bool shared_search = false;      ///< there is a phase neighbour_search
  bool shared_resolution = false;  ///< there is a phase pair_resolution
  bool attraction = false;         ///< there is a phase attraction

  Plan() = default;
  Plan(const Effects& effects, std::size_t balls, std::size_t workers)
      : pairs(effects.collisions.has_value()),
        neighbour_list(pairs && balls >= kManyBalls),
        attraction(effects.attraction.has_value()) {
    const bool shares = workers > 1 && workers <= kFewWorkers;
    shared_search = pairs && shares && balls >= kSharedSearch;
    shared_resolution = neighbour_list && shares;
  }
};

}  // namespace carom::overlap
