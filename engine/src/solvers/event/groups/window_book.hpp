#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/impact.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/event/counts.hpp"
#include "state/totals.hpp"

namespace carom::event {

/// What happened in a window to a ball alone, or to a group, noted at its first ball; turns are
/// each ball's own.
struct WindowOutcome {
  Counts counts;
  std::vector<Impact> impacts;  ///< where they are noted
  std::vector<double> lost;     ///< energy, as terms of an exact sum
  std::array<std::int64_t, 2> turns{0, 0};

  void clear() {
    counts = {};
    impacts.clear();
    lost.clear();
    turns = {0, 0};
  }
};

/// What has happened in the windows that have ended.
class WindowBook {
 public:
  /// Nothing is lost, no turns are made and no impacts noted.  `round`, by axis: turns are counted.
  void reset(std::size_t balls, const std::array<bool, 2>& round) {
    impacts_.clear();
    lost_.clear();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      turns_[axis].assign(round[axis] ? balls : 0, 0);
    }
  }
  void lose(double energy) { lost_.add(energy); }
  /// Enters an outcome, which is empty then: a ball may have been solved more than once.
  void enter(std::size_t ball, WindowOutcome& outcome) {
    counts_ += outcome.counts;
    for (const double part : outcome.lost) lost_.add(part);
    const std::uint64_t joint = impacts_.size();
    for (Impact& impact : outcome.impacts) {
      if (impact.event != 0) impact.event += joint;
      impacts_.push_back(impact);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!turns_[axis].empty()) turns_[axis][ball] += outcome.turns[axis];
    }
    outcome.clear();
  }
  /// Adds the impacts since the last time this was asked.
  void take_impacts(std::vector<Impact>& impacts) {
    impacts.insert(impacts.end(), impacts_.begin(), impacts_.end());
    impacts_.clear();
  }

  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] const std::vector<double>& losses() const { return lost_.parts(); }
  /// By axis, then by ball; empty where they are not counted.
  [[nodiscard]] const Turns& turns() const { return turns_; }

 private:
  Counts counts_;
  ExactSum<double> lost_;
  Turns turns_;
  std::vector<Impact> impacts_;
};

}  // namespace carom::event
