#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/measurements.hpp"
#include "carom/scene.hpp"
#include "carom/simulation.hpp"

namespace carom {

/// Where a run stood: enough to go on as if it had never stopped.
struct Checkpoint {
  std::uint64_t frame = 0;        ///< the last one that was written
  std::uint64_t first_frame = 0;  ///< of the run
  double start_time = 0;          ///< simulated seconds at its start
  Measurements measured;          ///< since the start; without seconds
  Bookkeeping bookkeeping;        ///< of balls, events and losses
  /// The files that are written along the way: their option and how long they are.
  std::vector<std::pair<std::string, std::uint64_t>> files;
  Scene scene;  ///< as Session::save has it
};

/// The checkpoints of one run, in a file of their own.
///
/// Holds: the file is whole at any time.
/// Errors: std::system_error that names the option and the
/// file; UsageError where the file is no checkpoint of this run.
class CheckpointFile {
 public:
  /// `file`: empty: there are none.  `run`: what tells this run from others.
  CheckpointFile(std::string file, double seconds, std::string run);

  [[nodiscard]] explicit operator bool() const { return !file_.empty(); }
  /// Where an earlier attempt at this run stood; nothing: there was none.
  [[nodiscard]] std::optional<Checkpoint> read() const;
  [[nodiscard]] bool due() const;
  void write(const Checkpoint& checkpoint);
  /// The run is over.
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::string file_;
  std::chrono::duration<double> every_;
  std::string run_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace carom
