#include "export/unfinished_files.hpp"

#include <fcntl.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaction is POSIX
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>

#include "ending_signals.hpp"

namespace carom::unfinished_files {
namespace {

/// A signal handler may take no lock and use no allocated memory: so names live in fixed places.
struct Place {
  std::atomic<bool> used{false};
  std::array<char, PATH_MAX> name{};
};

std::array<Place, 12> places;

extern "C" void remove_and_end(int number) {
  for (Place& place : places) {
    if (place.used.load()) (void)unlink(place.name.data());
  }
  (void)signal(number, SIG_DFL);
  (void)raise(number);
}

}  // namespace

int create(std::string& name) {
  const auto place =
      std::find_if(places.begin(), places.end(), [](const Place& each) { return !each.used; });
  if (place == places.end() || name.size() >= place->name.size()) {
    errno = place == places.end() ? EMFILE : ENAMETOOLONG;
    return -1;
  }
  // The handler must know the name as soon as the file is there.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  (void)pthread_sigmask(SIG_SETMASK, &all, &before);
  const int descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) {
    *std::copy(name.begin(), name.end(), place->name.begin()) = '\0';
    place->used = true;
  }
  const int error = errno;
  (void)pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return descriptor;
}

void remove(const std::string& name) {
  (void)unlink(name.c_str());
  forget(name);
}

void forget(const std::string& name) {
  for (Place& place : places) {
    if (place.used && name == place.name.data()) place.used = false;
  }
}

void remove_on_signals() {
  const auto install = [](int number, int flags) {
    struct sigaction action {};
    // What was ignored stays so, and what somebody else handles is theirs.
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) return;
    action = {};
    action.sa_handler = remove_and_end;
    action.sa_flags = flags;
    (void)sigaction(number, &action, nullptr);
  };
  for (const int number : requests_to_end()) install(number, 0);
  // A crash for lack of stack leaves none for the handler: it has its own on the control thread.
  static std::array<char, std::size_t{64} * 1024> stack;
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  (void)sigaltstack(&other, nullptr);
  for (const int number : crashes()) install(number, SA_ONSTACK);
}

}  // namespace carom::unfinished_files
