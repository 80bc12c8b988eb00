#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "carom/session.hpp"

namespace carom {

/// When a ball has its next impact: a copy of the run goes ahead of it until the ball meets
/// something, a little in each frame.
///
/// Threads: the control thread only.
class NextEvent {
 public:
  static constexpr double kFarthest = 60;          ///< simulated seconds that are looked ahead
  static constexpr std::size_t kMostBalls = 2000;  ///< more are not looked ahead of

  /// Goes on looking for the next impact of the ball `id`, as long as `in_time` says.
  /// REQUIRES: a ball of that number, which can move; kMostBalls at the most.
  void look(const Session& session, std::size_t id, const std::function<bool()>& in_time);
  /// The next impact; `a` is the ball, `b` its partner, both as of Simulation::ids of the run.
  [[nodiscard]] const std::optional<Impact>& found() const { return found_; }
  /// There is none so soon that it is looked for.
  [[nodiscard]] bool none() const { return none_; }

 private:
  void begin(const Session& session);
  [[nodiscard]] bool holds(const Session& session, std::size_t id) const;

  std::unique_ptr<Simulation> ahead_;
  std::size_t id_ = 0;
  std::size_t balls_ = 0;
  double energy_input_ = 0;
  double begun_ = 0;
  double slice_ = 0;
  std::optional<Impact> found_;
  bool none_ = false;
};

}  // namespace carom
