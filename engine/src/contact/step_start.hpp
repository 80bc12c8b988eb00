#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "state/balls.hpp"

namespace carom::contact {

/// Where balls are and how fast they move at the start of a step.
/// Threads: each thread notes its own balls.
class StepStart {
 public:
  void make_room(std::size_t balls) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      place_[axis].resize(balls);
      velocity_[axis].resize(balls);
    }
  }
  /// Notes balls [begin, end).
  void note(const Balls& balls, std::size_t begin, std::size_t end) {
    const auto from = static_cast<std::ptrdiff_t>(begin);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::copy(balls.position[axis].data() + begin, balls.position[axis].data() + end,
                place_[axis].begin() + from);
      std::copy(balls.velocity[axis].data() + begin, balls.velocity[axis].data() + end,
                velocity_[axis].begin() + from);
    }
  }
  [[nodiscard]] Vec2 place(std::size_t ball) const { return {place_[0][ball], place_[1][ball]}; }
  [[nodiscard]] Vec2 velocity(std::size_t ball) const {
    return {velocity_[0][ball], velocity_[1][ball]};
  }

 private:
  std::array<std::vector<double>, 2> place_;
  std::array<std::vector<double>, 2> velocity_;
};

}  // namespace carom::contact
