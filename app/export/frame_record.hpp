#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/impact.hpp"
#include "carom/measurements.hpp"
#include "carom/scene.hpp"
#include "carom/session.hpp"

namespace carom {

/// What a run leaves at a frame for the files that are written along the way.
struct FrameRecord {
  std::uint64_t frame = 0;  ///< its number on the frame clock
  double clock = 0;         ///< seconds of the frame clock
  double time = 0;          ///< simulated seconds
  std::vector<Ball> balls;
  std::vector<std::size_t> ids;  ///< the number that each keeps for good
  std::string state_hash;
  Measurements measured;        ///< since the start of the run
  std::vector<Impact> impacts;  ///< and commands, since the last record
  std::string picture;          ///< rows of text, each with its end of line
};

/// Makes the records of a run: only what is asked for is looked at.
///
/// Threads: the control thread only.
class FrameRecorder {
 public:
  struct Wanted {
    bool balls = false;
    bool state_hash = false;
    bool measured = false;
    bool impacts = false;
  };

  /// `before`: what an earlier part of the run has measured.
  FrameRecorder(Session& session, const Wanted& wanted,
                const std::optional<Measurements>& before = {});

  /// The record of a frame, without its picture.  `last`: with what is measured at the end only.
  [[nodiscard]] FrameRecord record(std::uint64_t frame, bool last = false);

 private:
  Session& session_;
  Wanted wanted_;
  std::optional<Measurements> before_;
};

/// What was measured before and what was measured since, by a simulation that goes on from the
/// bookkeeping of then, as of one run.
Measurements together(const Measurements& before, const Measurements& since);

}  // namespace carom
