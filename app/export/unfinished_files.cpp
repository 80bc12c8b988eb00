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
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
    struct sigaction action {};
    (void)sigaction(number, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = remove_and_end;
    (void)sigaction(number, &action, nullptr);
  }
}

}  // namespace carom::unfinished_files
