#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// What a scene will take of the machine while it runs.
struct Footprint {
  using Bytes = std::vector<std::pair<std::string, std::size_t>>;

  std::size_t balls = 0;
  std::size_t pairs = 0;              ///< unique pairs that could meet; 0 without collisions
  Bytes columns;                      ///< exact: one array for each property that an effect needs
  Bytes lists;                        ///< estimated: pairs and cells that the method keeps
  std::size_t workers = 0;            ///< beside the control thread
  std::vector<std::string> barriers;  ///< in the order in which a step meets them

  [[nodiscard]] std::size_t bytes() const;
};

/// Of the scene with these balls, as `populate` gives them.
Footprint footprint(const Scene& scene, const std::vector<Ball>& balls);

}  // namespace carom
