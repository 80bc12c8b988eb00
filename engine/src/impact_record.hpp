#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "carom/impact.hpp"

namespace carom {

/// The impacts of a simulation that have not been taken yet, in the order of time and numbered.
class ImpactRecord {
 public:
  /// The first event is called so.
  explicit ImpactRecord(std::uint64_t next_event = 0) : next_event_(next_event) {}

  [[nodiscard]] std::uint64_t next_event() const { return next_event_; }
  /// Adds what a solver has noted since the last call; `ids`: the lasting numbers of the balls.
  void add(std::vector<Impact> impacts, const std::vector<std::size_t>& ids);
  /// Adds a command, not before what has happened: a step may end a rounding beyond its time.
  void add(Impact command);
  /// What was added since the last call, none of it before what was taken then.
  [[nodiscard]] std::vector<Impact> take();

 private:
  std::vector<Impact> impacts_;
  std::uint64_t next_event_;
  std::uint64_t joints_ = 0;  // the last number of what belongs together, of those not taken yet
  double latest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace carom
