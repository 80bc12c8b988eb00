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
  if (!shown_here_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kBetween;
  const double spent = std::chrono::duration<double>(now - started_).count();
  part = std::clamp(part, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(part * kBarWidth);
  const std::string bar =
      std::string(full, '#') + std::string(static_cast<std::size_t>(kBarWidth) - full, '.');
  std::string line = fmt::format("[{}] {:3.0f} %  {:.4g} s simulated in {:.1f} s", bar, part * 100,
                                 simulated, spent);
  if (part > 0) line += fmt::format(", {:.0f} s left", spent / part - spent);
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
