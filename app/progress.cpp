#include "progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace carom {

constexpr auto kBetween = std::chrono::milliseconds(100);
constexpr double kBarWidth = 30;

Progress::Progress(bool wanted) : shown_here_(wanted && isatty(STDERR_FILENO) == 1) {}

void Progress::show(double part, double simulated) {
  if (!due()) return;
  const double spent = std::chrono::duration<double>(Clock::now() - started_).count();
  part = std::clamp(part, 0.0, 1.0);
  std::string text = fmt::format("{:.4g} s simulated in {:.1f} s", simulated, spent);
  if (part > 0) text += fmt::format(", {:.0f} s left", spent / part - spent);
  draw(part, text);
}

void Progress::show_left(double part, double left, const std::string& what) {
  if (!due()) return;
  draw(std::clamp(part, 0.0, 1.0), fmt::format("{}, about {:.0f} s left", what, left));
}

bool Progress::due() {
  if (!shown_here_) return false;
  const auto now = Clock::now();
  if (now < next_) return false;
  next_ = now + kBetween;
  return true;
}

void Progress::draw(double part, const std::string& text) {
  const auto full = static_cast<std::size_t>(part * kBarWidth);
  const std::string bar =
      std::string(full, '#') + std::string(static_cast<std::size_t>(kBarWidth) - full, '.');
  std::string line = fmt::format("[{}] {:3.0f} %  {}", bar, part * 100, text);
  winsize size{};  // a line that wraps cannot be taken back
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) {
    line.resize(std::min<std::size_t>(line.size(), size.ws_col - 1U));
  }
  const std::size_t width = line.size();
  line.resize(std::max(width, width_), ' ');
  width_ = width;
  fmt::print(stderr, "\r{}", line);
  (void)std::fflush(stderr);
}

void Progress::print_above(const std::string& line) {
  if (!shown_here_) return;
  erase_line();
  fmt::print(stderr, "{}\n", line);
  (void)std::fflush(stderr);
  ++above_;
}

void Progress::erase_line() {
  if (width_ == 0) return;
  fmt::print(stderr, "\r{}\r", std::string(width_, ' '));
  (void)std::fflush(stderr);
  width_ = 0;
}

void Progress::erase() {
  erase_line();
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
  if (above_ > 0 && known && above_ < size.ws_row) {
    fmt::print(stderr, "\x1b[{}A\x1b[J", above_);  // up, and clear to the end of the screen
    (void)std::fflush(stderr);
  }
  above_ = 0;
}

}  // namespace carom
