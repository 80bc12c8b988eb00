#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/simulation.hpp"
#include "view/barrier_words.hpp"
#include "view/lanes.hpp"
#include "view/threads_panel.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// Watches what the threads of a simulation do between its barriers, and goes through a frame from
/// barrier to barrier.
///
/// Going through a frame is a replay: the workers are never held up.  The frame is computed at
/// once; its timestamps are told barrier by barrier, and the balls are shown where they were before
/// it until frame_done.
///
/// Threads: the control thread only.
class ThreadsWatch {
 public:
  [[nodiscard]] bool open() const { return open_; }
  void open(Simulation& simulation);
  void close(Simulation& simulation);

  /// A frame of the screen was computed by `calls` calls of `advance_to`.
  void computed(Simulation& simulation, std::size_t calls, Instant now);

  [[nodiscard]] bool slow() const { return slow_; }
  void set_slow(bool slow);
  /// Goes on to the next barrier of the frame; false where its last one has been passed.
  bool pass_barrier();
  /// A frame is about to be computed, whose barriers are then passed one by one.
  void begin_frame(const Simulation& simulation);
  /// The simulated seconds of a frame gone through slowly: a step where there are steps.
  static double slow_frame(const Simulation& simulation, double frame_seconds);
  /// What is on screen instead of the present: the balls before the frame that is gone through.
  /// Null: the present, since the frame is over or something else has happened since.
  [[nodiscard]] const Frame* before(const Simulation& simulation) const;

  [[nodiscard]] ThreadsView view() const;
  /// Rows of a panel in which every worker has a lane.
  [[nodiscard]] int rows_wanted(const Simulation& simulation) const;

 private:
  void start_recording(Simulation& simulation);
  [[nodiscard]] ThreadsView slow_view() const;

  bool open_ = false;
  bool slow_ = false;
  Lanes lanes_;  // of the frame that is shown
  std::vector<std::string> barriers_;
  std::vector<double> computed_;  // by each worker, smoothed
  Instant next_;                  // the panel is renewed at this time, to be read in peace
  double time_ = 0;               // simulated, of the lanes
  std::size_t balls_ = 0;

  std::size_t passed_ = 0;  // passages of the frame that is gone through
  bool awaited_ = false;    // the next frame computed is gone through
  std::optional<Frame> before_;
  Computation computation_ = Computation::overlap;
};

}  // namespace carom
