#include "view/terminal_line.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPatience{1000};

/// Standard output, opened again: not to wait for it then concerns this program only.
int open_output() {
  const char* const name = ttyname(STDOUT_FILENO);
  if (name != nullptr) {
    const int descriptor = open(name, O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0) return descriptor;
  }
  return fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
}

bool takes_output(int descriptor, std::chrono::milliseconds patience) {
  pollfd source{descriptor, POLLOUT, 0};
  return poll(&source, 1, static_cast<int>(patience.count())) > 0 &&
         (source.revents & POLLOUT) != 0;
}

}  // namespace

TerminalLine::TerminalLine() {
  if (tcgetattr(STDIN_FILENO, &before_) != 0)
    throw std::runtime_error("the terminal cannot be used");
  output_ = open_output();
  if (output_ < 0) throw std::runtime_error("the terminal cannot be written to");
}

TerminalLine::~TerminalLine() {
  close(output_);
}

void TerminalLine::take_over() {
  termios mode = before_;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_iflag &= ~static_cast<tcflag_t>(ICRNL | INLCR);
  mode.c_cc[VMIN] = 0;
  mode.c_cc[VTIME] = 0;
  (void)tcsetattr(STDIN_FILENO, TCSANOW, &mode);
}

void TerminalLine::give_back() {
  (void)tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void TerminalLine::send(std::string_view bytes) {
  waiting_ += bytes;
  flush();
}

void TerminalLine::flush() {
  while (!waiting_.empty() && !gone_ && takes_output(output_, std::chrono::milliseconds{0})) {
    const ssize_t count = write(output_, waiting_.data(), waiting_.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count < 0) {
      gone_ = true;
      return;
    }
    waiting_.erase(0, static_cast<std::size_t>(count));
  }
}

void TerminalLine::send_last(std::string_view bytes) {
  if (blocked()) {
    // Linux lets output that Ctrl-S stopped go on only once it was stopped this way, too.
    (void)tcflow(output_, TCOOFF);
    (void)tcflow(output_, TCOON);
  }
  waiting_ = bytes;
  const auto end = Clock::now() + kPatience;
  for (flush(); blocked() && !gone_ && Clock::now() < end; flush())
    (void)takes_output(output_, kPatience / 10);
  if (blocked() && !gone_) {
    // The terminal does not read: what it has not read gives way to what restores it.
    (void)tcflush(output_, TCOFLUSH);
    flush();
  }
  waiting_.clear();
}

}  // namespace carom
