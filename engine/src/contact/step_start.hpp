#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/balls.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// Where balls are, how fast they move and how often they have gone round at the start of a step.
/// Threads: each thread notes its own balls.
class StepStart {
 public:
  /// `turns`: as `note` will be given them.
  void make_room(std::size_t balls, const Turns& turns) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      place_[axis].resize(balls);
      velocity_[axis].resize(balls);
      turns_[axis].resize(turns[axis].size());
    }
  }
  /// Notes balls [begin, end).
  void note(const Balls& balls, const Turns& turns, std::size_t begin, std::size_t end) {
    const auto from = static_cast<std::ptrdiff_t>(begin);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::copy(balls.position[axis].data() + begin, balls.position[axis].data() + end,
                place_[axis].begin() + from);
      std::copy(balls.velocity[axis].data() + begin, balls.velocity[axis].data() + end,
                velocity_[axis].begin() + from);
      if (turns[axis].empty()) continue;
      std::copy(turns[axis].data() + begin, turns[axis].data() + end, turns_[axis].begin() + from);
    }
  }
  [[nodiscard]] Vec2 place(std::size_t ball) const { return {place_[0][ball], place_[1][ball]}; }
  [[nodiscard]] Vec2 velocity(std::size_t ball) const {
    return {velocity_[0][ball], velocity_[1][ball]};
  }
  /// Where turns are counted.
  [[nodiscard]] std::int64_t turns(std::size_t axis, std::size_t ball) const {
    return turns_[axis][ball];
  }

 private:
  std::array<std::vector<double>, 2> place_;
  std::array<std::vector<double>, 2> velocity_;
  Turns turns_;
};

}  // namespace carom::contact
