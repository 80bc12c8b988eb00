#include "view/terminal_rescue.hpp"

#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is POSIX
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>

#include "ending_signals.hpp"

namespace carom {
namespace {

// A handler may take no lock and use no allocated memory: all it needs lies in fixed places.
constexpr std::size_t kLongestLeave = 512;
constexpr int kRescuePatience = 1000;  // milliseconds
constexpr std::size_t kStackSize = std::size_t{64} * 1024;

struct Given {
  std::atomic<bool> armed{false};
  int descriptor = -1;
  termios before{};
  std::array<char, kLongestLeave> leave{};
  std::size_t length = 0;
};
Given given;

struct Before {
  int number = 0;
  struct sigaction action {};
};
std::array<Before, 16> actions_before;
std::size_t actions_changed = 0;

extern "C" void give_back(int number) {
  if (given.armed.exchange(false)) {
    // Output that was stopped goes on, and is waited for no longer than a second.
    (void)tcflow(given.descriptor, TCOOFF);
    (void)tcflow(given.descriptor, TCOON);
    pollfd output{given.descriptor, POLLOUT, 0};
    if (poll(&output, 1, kRescuePatience) > 0)
      (void)!write(given.descriptor, given.leave.data(), given.length);
    (void)tcsetattr(given.descriptor, TCSANOW, &given.before);
  }
  for (std::size_t i = 0; i < actions_changed; ++i) {
    if (actions_before[i].number == number)
      (void)sigaction(number, &actions_before[i].action, nullptr);
  }
  (void)raise(number);  // comes once this handler has returned
}

}  // namespace

TerminalRescue::TerminalRescue(int descriptor, const termios& before, const std::string& leave) {
  given.descriptor = descriptor;
  given.before = before;
  given.length = std::min(leave.size(), kLongestLeave);
  std::copy_n(leave.begin(), given.length, given.leave.begin());
  given.armed = true;
  // A crash for lack of stack leaves none for the handler.
  static std::array<char, kStackSize> stack;
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  (void)sigaltstack(&other, nullptr);
  actions_changed = 0;
  for (const int number : crashes()) {
    Before& place = actions_before[actions_changed];
    place.number = number;
    if (sigaction(number, nullptr, &place.action) != 0 || place.action.sa_handler == SIG_IGN)
      continue;
    struct sigaction action {};
    action.sa_handler = give_back;
    action.sa_flags = SA_ONSTACK;
    if (sigaction(number, &action, nullptr) == 0) ++actions_changed;
  }
}

TerminalRescue::~TerminalRescue() {
  given.armed = false;
  for (std::size_t i = 0; i < actions_changed; ++i)
    (void)sigaction(actions_before[i].number, &actions_before[i].action, nullptr);
}

}  // namespace carom
