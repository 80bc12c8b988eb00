#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "state/balls.hpp"
#include "state/domain.hpp"

namespace carom {

/// A ball that moves so far in a step that it could pass another one unseen, as it was before.
struct Bullet {
  std::size_t ball = 0;
  Vec2 position{0, 0};
  Vec2 velocity{0, 0};
};

/// Notes which of the balls [begin, end) move farther in a step than two of the smallest touch.
void find_bullets(const Balls& balls, std::size_t begin, std::size_t end, double step,
                  double smallest_radius, std::vector<Bullet>& bullets);

/// How many balls the bullets, of all balls, passed through on their ways: that they do not touch
/// after the step, or beyond which they are by more than a resolved impact brings back; straight
/// ways, sent back by solid walls without loss.
///
/// Holds: at least so many, in any order of the balls; of a way that is sent back very often, only
/// the first pieces count.
std::uint64_t count_missed(const Balls& balls, const Domain& domain, double step,
                           std::vector<Bullet> bullets);

}  // namespace carom
