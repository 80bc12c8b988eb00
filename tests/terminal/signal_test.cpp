// The terminal is given back whatever ends the player.
#include <gtest/gtest.h>

#include <csignal>

#include "scenes.hpp"
#include "terminal.hpp"

namespace carom::test::signal_test {
namespace {

class EndedBySignal : public testing::TestWithParam<int> {};

TEST_P(EndedBySignal, GivesTheTerminalBackAndTellsTheSignal) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  for (const char* const mode : {"1002", "1006", "2004"}) ASSERT_TRUE(terminal.mode_on(mode));
  if (GetParam() == SIGINT) {
    terminal.type("\x03");  // ^C
  } else {
    terminal.signal(GetParam());
  }
  EXPECT_EQ(terminal.wait_for_end(), 128 + GetParam());
  EXPECT_TRUE(terminal.given_back()) << terminal.text();
  EXPECT_EQ(terminal.shows("carom: three: "), GetParam() != SIGHUP) << terminal.text();
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedBySignal,
                         testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGUSR1,
                                         SIGUSR2, SIGALRM, SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF,
                                         SIGPOLL, SIGPWR, SIGSTKFLT,
                                         40));  // the last is a real-time one

class Crash : public testing::TestWithParam<int> {};

TEST_P(Crash, GivesTheTerminalBack) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  for (const char* const mode : {"1002", "1006", "2004"}) ASSERT_TRUE(terminal.mode_on(mode));
  ASSERT_FALSE(terminal.given_back());
  terminal.signal(GetParam());
  EXPECT_EQ(terminal.wait_for_end(), Terminal::kKilled + GetParam());
  EXPECT_TRUE(terminal.given_back()) << terminal.text();
}

INSTANTIATE_TEST_SUITE_P(Signals, Crash,
                         testing::Values(SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSYS,
                                         SIGTRAP));

}  // namespace
}  // namespace carom::test::signal_test
