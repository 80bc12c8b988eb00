#pragma once

#include <csignal>
#include <vector>

namespace carom {

/// The signals whose default action ends a process and that come from outside: a person, a limit, a
/// timer, a closed pipe.  A program has time to tidy up before it obeys them.
inline std::vector<int> requests_to_end() {
  std::vector<int> signals{
      SIGINT,    SIGTERM, SIGHUP,    SIGQUIT, SIGPIPE, SIGUSR1, SIGUSR2,
      SIGALRM,   SIGXCPU, SIGVTALRM, SIGPROF, SIGPOLL, SIGXFSZ,
#ifdef SIGSTKFLT
      SIGSTKFLT,
#endif
#ifdef SIGPWR
      SIGPWR,
#endif
  };
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) signals.push_back(signal);
  return signals;
}

/// The signals of a program that has gone wrong: only what is safe in a handler can still be done.
inline std::vector<int> crashes() {
  return {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSYS, SIGTRAP};
}

}  // namespace carom
