#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/measurements.hpp"
#include "carom/timeline.hpp"

namespace carom {

/// Which share of the work is a worker's: worker `index` of `count`.
struct Share {
  std::size_t index = 0;
  std::size_t count = 1;

  /// The share of `n` things in a row: [begin, end), sizes differing by one at most.
  [[nodiscard]] std::size_t begin(std::size_t n) const { return n * index / count; }
  [[nodiscard]] std::size_t end(std::size_t n) const { return n * (index + 1) / count; }
};

/// What every worker does between two barriers.
struct Phase {
  static constexpr std::size_t kFrameDone = static_cast<std::size_t>(-1);

  std::string name;  ///< also the name of the barrier at its end, as in "wall_computation"
  std::function<void(Share)> work;
  /// Run by the last worker to arrive, while the others wait; gives the number of the phase that
  /// comes next, or kFrameDone.
  std::function<std::size_t()> finish;
};

/// The system gave fewer threads than were asked for.
class CrewError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A barrier of a crew, by its name.
struct BarrierStatus {
  std::string name;
  std::size_t parties = 0;
};

/// Worker threads that compute frames together, phase by phase.  Knows no physics.
///
///     control   do_frame ................................................ frame_done
///     worker 0  do_frame [phase 0] wall_computation [phase 1] ... [phase n] frame_done
///     worker 1  do_frame [phase 0] wall_computation [phase 1] ... [phase n] frame_done
///
/// The control thread and the workers meet at `do_frame`, where a frame is ordered, and at
/// `frame_done`, before which nothing of it may be looked at.  In between, the workers alone meet
/// at the barrier of each phase, where the last to arrive runs the phase's `finish`.
///
/// Threads: the members are for the control thread; the phases run on the workers.
/// Holds: between frames every worker waits at `do_frame`.
/// Errors: CrewError where threads cannot be started.  What a worker throws is rethrown by
/// `do_frame` once all workers have ended; of several, the one of the lowest worker.  After that
/// the crew has no workers, and do_frame() throws the same again.
class Crew {
 public:
  /// At least one worker is started.
  Crew(std::size_t workers, std::vector<Phase> phases);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Orders one frame, starting with phase number `first`, and waits until it is done.
  void do_frame(std::size_t first = 0);
  /// Starts or ends workers, between frames: the difference only, and never the last one.  Where
  /// the threads cannot be had the crew stays as it was.
  void resize(std::size_t workers);

  [[nodiscard]] std::size_t workers() const;
  /// do_frame, the barrier of each phase, frame_done.
  [[nodiscard]] std::vector<BarrierStatus> barriers() const;
  /// Wall-clock seconds spent in each phase so far, in the order of the phases.
  [[nodiscard]] Seconds seconds() const;
  /// Wall-clock seconds of all frames so far, and those that the workers have spent in phases, all
  /// of them together; 0 where there is one worker, which is never waited for.
  struct Effort {
    double frames = 0;
    double computing = 0;
  };
  [[nodiscard]] Effort effort() const;

  /// Records from now on what every thread does between the barriers, and keeps the last `frames`
  /// frames; 0: no longer, and forgets them.  Between frames.  Nothing is allocated in a phase.
  void record_timeline(std::size_t frames);
  /// The last `frames` frames that were recorded, or all that are kept.  Between frames.
  [[nodiscard]] Timeline timeline(std::size_t frames = static_cast<std::size_t>(-1)) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace carom
