#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace carom {

/// What the status line tells about a run.
struct Status {
  std::string scene;
  std::size_t balls = 0;
  std::size_t workers = 0;
  double time = 0;  ///< simulated seconds
  double frames_per_second = 0;
  double computing_milliseconds = 0;
  double energy_error = 0;
  std::uint64_t late = 0;
  double speed = 1;            ///< simulated seconds wanted per real one
  std::optional<double> pace;  ///< what the simulation reaches, where that is less
  bool paused = false;
  std::string note;  ///< what else there is to know; empty: nothing
};

/// The status in `width` characters at most, in words: what matters most, and of the rest as much
/// as fits.
std::string status_line(const Status& status, int width);

/// A number of simulated or real speed as people write it: "2x", "1/4x".
std::string speed_text(double speed);

}  // namespace carom
