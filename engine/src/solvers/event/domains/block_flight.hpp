#pragma once

#include "solvers/event/disk.hpp"

namespace carom::event {

/// All that lasts of a ball between two windows: its flight, and which ball it is.
struct BlockFlight : BallFlight<double> {
  Index ball = 0;

  /// As an event loop works with it; nothing is known of its end.
  [[nodiscard]] Disk disk() const {
    Disk disk;
    static_cast<BallFlight<double>&>(disk) = *this;
    return disk;
  }
  static BlockFlight of(const BallFlight<double>& flight, Index ball) {
    BlockFlight of_block;
    static_cast<BallFlight<double>&>(of_block) = flight;
    of_block.ball = ball;
    return of_block;
  }
};
static_assert(sizeof(BlockFlight) == 48);

}  // namespace carom::event
