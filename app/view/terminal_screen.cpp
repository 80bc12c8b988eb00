#include "view/terminal_screen.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <stdexcept>
#include <utility>

#include "view/encoder.hpp"
#include "view/input.hpp"
#include "view/terminal_line.hpp"
#include "view/terminal_modes.hpp"
#include "view/terminal_rescue.hpp"

namespace carom {
namespace {

constexpr std::chrono::milliseconds kRestOfSequence{50};  // how far its bytes may come apart
constexpr UserInterface::Size kUntold{80, 24};
// xterm, "Control Sequences": what comes in between is shown at once (mode 2026).
constexpr const char* kBeginUpdate = "\x1B[?2026h";
constexpr const char* kEndUpdate = "\x1B[?2026l";

UserInterface::Size window_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0 || size.ws_col == 0)
    return kUntold;
  return {size.ws_col, size.ws_row};
}

}  // namespace

class TerminalScreen::Implementation {
 public:
  Implementation(Signals& signals, const TerminalInfo& info, const Options& options)
      : signals_(signals),
        info_(info),
        modes_(terminal_modes(info.name, options.mouse)),
        encoder_({options.colors ? info.colors : Colors::none, options.background}),
        rescue_(line_.output(), line_.before(), modes_.leave) {
    enter();
  }

  ~Implementation() { leave(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  [[nodiscard]] Size size() const { return size_; }
  [[nodiscard]] bool unicode() const { return info_.unicode; }

  void set_title(const std::string& title) {
    if (!has_window(info_.name)) return;
    title_.clear();
    for (const char character : title) {
      // As in pictures: one '?' for a letter beyond ASCII.
      const auto byte = static_cast<unsigned char>(character);
      if ((byte & 0xC0U) != 0x80U) title_ += byte >= 0x20 && byte < 0x7F ? character : '?';
    }
    if (entered_) line_.send("\x1B]2;" + title_ + '\a');
  }

  void show(const Canvas& canvas) {
    if (!entered_) enter();
    line_.flush();
    if (line_.blocked()) {
      next_ = canvas;
      return;
    }
    next_.reset();
    const std::string bytes = encoder_.show(canvas);
    if (!bytes.empty()) line_.send(kBeginUpdate + bytes + kEndUpdate);
  }

  Event wait_until(Instant deadline) {
    for (;;) {
      while (const auto signal = signals_.next()) {
        const Event event = answer(*signal);
        if (event.kind != Event::Kind::none) return event;
      }
      if (const auto event = input_.next()) return *event;
      if (read_input()) continue;
      if (line_.gone()) return {Event::Kind::ended, SIGHUP};
      const Instant until = input_.waiting() ? std::min(deadline, sequence_due_) : deadline;
      if (sleep_until(until)) continue;
      if (input_.waiting() && std::chrono::steady_clock::now() >= sequence_due_) {
        input_.settle();
        continue;
      }
      return {};
    }
  }

 private:
  void enter() {
    line_.take_over();
    std::string bytes = std::exchange(entered_, true) ? modes_.again : modes_.enter;
    if (!title_.empty()) bytes += "\x1B]2;" + title_ + '\a';
    line_.send(bytes);
    size_ = window_size();
    encoder_.forget();
  }

  void leave() {
    if (!std::exchange(entered_, false)) return;
    line_.send_last(modes_.leave);
    line_.give_back();
  }

  bool read_input() {
    // Until it is taken over again, a terminal gives whole lines, and a read waits for one.
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (!entered_ || poll(&input, 1, 0) <= 0) return false;
    std::array<char, 4096> bytes{};
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno == EIO) line_.set_gone();
    if (count <= 0) return false;
    input_.feed({bytes.data(), static_cast<std::size_t>(count)});
    sequence_due_ = std::chrono::steady_clock::now() + kRestOfSequence;
    return true;
  }

  /// False if the deadline came before anything else.
  bool sleep_until(Instant deadline) {
    const auto left = deadline - std::chrono::steady_clock::now();
    const auto wait = std::max(left, Instant::duration{0});
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wait);
    const timespec patience{seconds.count(),
                            static_cast<long>(std::chrono::nanoseconds(wait - seconds).count())};
    std::array<pollfd, 3> sources{{{STDIN_FILENO, POLLIN, 0},
                                   {signals_.descriptor(), POLLIN, 0},
                                   {line_.blocked() ? line_.output() : -1, POLLOUT, 0}}};
    const int ready = ppoll(sources.data(), sources.size(), &patience, nullptr);
    if (ready < 0 && errno != EINTR) throw std::runtime_error("the terminal cannot be waited for");
    // Of a terminal that is gone, nothing can be read any more.
    if ((sources[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) line_.set_gone();
    if (sources[2].revents != 0) {
      line_.flush();
      if (!line_.blocked() && next_) show(Canvas(*next_));
    }
    return ready != 0;
  }

  Event answer(int signal) {
    switch (signal) {
      case SIGWINCH:
        size_ = window_size();
        encoder_.forget();
        return {Event::Kind::resized};
      case SIGTSTP:
        leave();
        Signals::obey(SIGTSTP);  // stands still here until the program is continued
        return {Event::Kind::resumed};
      case SIGCONT:
        if (entered_) enter();  // who had the terminal meanwhile may have changed it
        return {Event::Kind::resumed};
      default:
        return {Event::Kind::ended, signal};
    }
  }

  Signals& signals_;
  TerminalInfo info_;
  TerminalModes modes_;
  TerminalLine line_;
  Encoder encoder_;
  TerminalRescue rescue_;
  Input input_;
  Instant sequence_due_;
  Size size_;
  std::string title_;
  std::optional<Canvas> next_;  // left out so far
  bool entered_ = false;
};

TerminalScreen::TerminalScreen(Signals& signals, const TerminalInfo& info, const Options& options)
    : implementation_(std::make_unique<Implementation>(signals, info, options)) {}
TerminalScreen::~TerminalScreen() = default;

UserInterface::Size TerminalScreen::size() const {
  return implementation_->size();
}
bool TerminalScreen::unicode() const {
  return implementation_->unicode();
}
void TerminalScreen::set_title(const std::string& title) {
  implementation_->set_title(title);
}
void TerminalScreen::show(const Canvas& canvas) {
  implementation_->show(canvas);
}
Event TerminalScreen::wait_until(Instant deadline) {
  return implementation_->wait_until(deadline);
}

}  // namespace carom
