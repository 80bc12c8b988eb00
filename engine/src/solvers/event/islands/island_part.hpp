#pragma once

#include <cstddef>
#include <vector>

#include "solvers/event/islands/island_motion.hpp"

namespace carom::event {

/// The balls of a contact island that move, and their contacts: what else is of the island stands
/// still, as what never moves does.
struct IslandPart {
  std::vector<ConeBody> bodies;
  std::vector<ConeContact> contacts;
  std::vector<std::size_t> body_number;     ///< in the island, by body
  std::vector<std::size_t> contact_number;  ///< the same, by contact

  /// Of the contacts that last, those of balls that do not stand.  Both by number in the island.
  IslandPart(const IslandMotion& island, const std::vector<char>& stands,
             const std::vector<char>& lasts);

  /// The island's balls move as those of the part do.
  void pass_on(IslandMotion& island) const;
};

/// Whether a ball that is faster than `still` is near to one that stands: that would feel it.
[[nodiscard]] bool reaches_standing(const IslandMotion& island, const std::vector<char>& stands,
                                    double still);

/// Whether it is no faster than `most` along either axis, nor in turning.
[[nodiscard]] bool is_slow(const ConeBody& body, double most);

/// Those that are near to what moves move, too, and those near to these, so many times.
void spread_motion(const IslandMotion& island, int times, std::vector<char>& moves);

}  // namespace carom::event
