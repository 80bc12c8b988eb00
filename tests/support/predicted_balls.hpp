#pragma once

#include <utility>
#include <vector>

#include "solvers/event/neighbours_body.hpp"
#include "solvers/event/physics.hpp"
#include "solvers/event/prediction_body.hpp"

namespace carom::event {

/// Balls, as yet none, with what predicts their impacts.
struct PredictedBalls {
  Motion<Ballistic> motion;
  HugeVector<Disk> disks;
  std::vector<double> spins;
  std::vector<Index> left;
  FixedTime next_step = kNever;
  Neighbours<Ballistic> neighbours{motion};
  Ties<FixedTimeClock> ties;
  Prediction<Ballistic> prediction{motion, {disks, spins, left, next_step}, neighbours, ties};

  explicit PredictedBalls(Rules rules) : motion(std::move(rules)) {}
};

}  // namespace carom::event
