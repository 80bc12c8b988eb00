#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "carom/session.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// The way that a session has come: from checkpoints, and the commands between them, any moment of
/// it is computed again, to the same bits.
///
/// Checkpoints are the farther apart the older they are, so that all of them stay within
/// kMostBytes.
/// Threads: the control thread only.
class History {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

  /// The way of this session begins where it stands.
  void begin(const Session& session, Instant now);
  /// The session was moved on, and shows this moment; takes a checkpoint where one is due.
  /// `clock` tells the time, to measure what that costs.
  void note(const Session& session, const UserInterface& clock);
  /// A command was given in the past: what came after it does not come again.
  void forget_after(const Session& session);

  /// The moments that can be gone to, simulated seconds.
  [[nodiscard]] double first() const;
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] bool is_past(const Session& session) const {
    return session.simulation().time() < last_;
  }
  /// Whether the checkpoints are small enough for any to be kept.
  [[nodiscard]] bool possible() const { return !checkpoints_.empty(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// The moment that was shown so many frames before or, with a negative number, after `time`.
  [[nodiscard]] double frame_before(double time, int frames) const;

  /// Puts in place of the session the one that it was at the last checkpoint that is not after
  /// `time`, paused; `move_on` then leads to `time`.
  void go_back(std::unique_ptr<Session>& session, double time);
  /// Moves a session of the past on to `time` at the latest, with the commands of its way.
  void move_on(Session& session, double time);
  /// What the session has gone through on its way.
  [[nodiscard]] Measurements measured(const Session& session) const;

 private:
  struct Checkpoint {
    double time = 0;
    Scene scene;
    Bookkeeping bookkeeping;
    Effects when_on;
    Measurements measured;
    std::size_t commands = 0;  // obeyed before
    std::size_t bytes = 0;
  };
  /// Where the way ends so far: what it was, and what is left of the script.
  struct Frontier {
    Scene log;
    std::vector<ScriptLine> rest;
    double clock = 0;
  };

  void add(const Session& session);
  void thin_out();

  std::deque<Checkpoint> checkpoints_;           // in order of time
  std::deque<double> frames_;                    // moments that were shown
  std::optional<Frontier> frontier_;             // of a session that stands in the past
  std::optional<Measurements> measured_before_;  // where the session was put in place
  double last_ = 0;
  std::size_t bytes_ = 0;
  Instant due_;
};

}  // namespace carom
