#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace carom {

/// A line on standard error that says how far a run is; on a terminal only, gone at the end.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress() { erase(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The part that is done, 0 to 1, and the simulated seconds; drawn a few times a second.
  void show(double part, double simulated);
  /// The part that is done, the seconds that are left, and what is being done.
  void show_left(double part, double left, const std::string& what);
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool due();
  void draw(double part, const std::string& text);

  bool shown_here_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point next_ = started_;
  std::size_t width_ = 0;
};

}  // namespace carom
