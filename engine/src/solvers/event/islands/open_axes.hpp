#pragma once

#include <vector>

#include "numbers/scalar.hpp"
#include "solvers/event/islands/island_motion.hpp"

namespace carom::event {

/// The axes along which nothing that never moves can push balls: walls across it without friction
/// at most.  Along such an axis their centre of mass moves as gravity alone makes it.
struct OpenAxes {
  bool x = true;
  bool y = true;

  void add(const ConeContact& contact);
  /// The part of a vector along them.
  [[nodiscard]] Vec<double> along(const Vec<double>& v) const { return {x ? v.x : 0, y ? v.y : 0}; }
};

/// Of a whole island.
[[nodiscard]] OpenAxes open_axes(const IslandMotion& island);

/// By ball: it and all that it is in contact with lie on walls, and nothing holds what gravity
/// makes of them along those. `presses`: by contact: it can take a load.
[[nodiscard]] std::vector<char> pulled_along(const IslandMotion& island, const Vec<double>& pull,
                                             const std::vector<char>& presses);

}  // namespace carom::event
