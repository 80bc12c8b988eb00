#include "progress.hpp"

#include <fmt/format.h>
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
  const std::size_t width = line.size();
  line.resize(std::max(width, width_), ' ');
  width_ = width;
  fmt::print(stderr, "\r{}", line);
  (void)std::fflush(stderr);
}

void Progress::erase() {
  if (width_ == 0) return;
  fmt::print(stderr, "\r{}\r", std::string(width_, ' '));
  (void)std::fflush(stderr);
  width_ = 0;
}

}  // namespace carom
