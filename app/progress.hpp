#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace carom {

/// A line on standard error that says how far a run is, and lines above it with what is done; on a
/// terminal only, gone at the end.
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
  /// Adds a line above.
  void print_above(const std::string& line);
  /// Takes everything back, as far as it is still on the screen.
  void erase();
  [[nodiscard]] bool shown() const { return shown_here_; }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool due();
  void erase_line();
  void draw(double part, const std::string& text);

  bool shown_here_;
  Clock::time_point started_ = Clock::now();
  Clock::time_point next_ = started_;
  std::size_t width_ = 0;
  std::size_t above_ = 0;  // lines
};

}  // namespace carom
