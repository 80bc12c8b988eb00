#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "accuracy/precise.hpp"
#include "carom/scene.hpp"
#include "carom/simulation.hpp"

namespace carom::accuracy {

/// Where the balls are at one instant, in the precision they are computed in.
class Places {
 public:
  /// Of a simulation as it stands.
  static Places of(const Simulation& simulation);

  [[nodiscard]] std::size_t balls() const { return parts_ == 0 ? 0 : numbers_.size() / 2 / parts_; }
  [[nodiscard]] Parts coordinate(std::size_t ball, std::size_t axis) const {
    return {numbers_.data() + (2 * ball + axis) * parts_, parts_};
  }
  [[nodiscard]] bool finite() const;

 private:
  std::size_t parts_ = 1;  // of a coordinate
  std::vector<double> numbers_;
};

/// The largest distance of a ball between the two, the shorter way round periodic axes; infinite
/// where a place is no number.  REQUIRES: as many balls.
double distance(const Places& one, const Places& other, const Box& box);

}  // namespace carom::accuracy
