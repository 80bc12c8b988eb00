// The player while it is stopped, its output is, or its scene, and after that.
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "scenes.hpp"
#include "steps.hpp"
#include "terminal.hpp"

namespace carom::test::stop_test {
namespace {

TEST(Play, StopsAtTheStopKeyAndGoesOnWhereItWas) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  for (int round = 0; round < 2; ++round) {
    const double stopped = shown_time(terminal);
    ASSERT_GE(stopped, 0);
    expect_stop_by_key(terminal);
    // Longer than the simulated time may be off by below.
    terminal.watch(std::chrono::milliseconds{2500}, [] {});
    terminal.resize(70 + round, 22);
    terminal.signal(SIGCONT);
    EXPECT_TRUE(terminal.wait([](const Terminal& t) {
      return t.alternate_screen() && !t.cursor_visible() &&
             t.row(20).find(" s  ") != std::string::npos;
    })) << terminal.text();
    const double after = shown_time(terminal);
    EXPECT_GE(after, stopped);
    EXPECT_LT(after, stopped + 2) << "the time it was stopped has passed in the scene";
    EXPECT_TRUE(terminal.mode_on("2004"));
    EXPECT_TRUE(terminal.mode_on("1002"));
  }
  expect_end_by_key(terminal);
}

TEST(Play, DrawsAllAgainWhenItIsContinuedAfterAStopThatItCouldNotSee) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.signal(SIGSTOP);
  ASSERT_TRUE(terminal.wait_until_stopped());
  const double before = shown_time(terminal);
  terminal.resize(60, 20);
  terminal.signal(SIGCONT);
  EXPECT_TRUE(terminal.wait([&](const Terminal& t) {
    return t.row(18).find(" s ") != std::string::npos && shown_time(t) > before;
  })) << terminal.text();
}

TEST(Play, EndsThoughItsOutputWasStopped) {
  const SceneFile scene(kThreeBalls);
  for (const int signal : {0, SIGTERM, SIGUSR1}) {
    Terminal terminal({scene.path()});
    ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
    terminal.type("\x13");  // ^S
    terminal.watch(std::chrono::milliseconds{300}, [] {});
    if (signal == 0) {
      terminal.type("q");
    } else {
      terminal.signal(signal);
    }
    EXPECT_EQ(terminal.wait_for_end(), signal == 0 ? 0 : 128 + signal);
    EXPECT_TRUE(terminal.given_back()) << terminal.text();
  }
}

TEST(Play, ShowsTheLatestPictureOnceStoppedOutputGoesOn) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("\x13");
  terminal.watch(std::chrono::milliseconds{200}, [] {});
  const double before = shown_time(terminal);
  terminal.watch(std::chrono::milliseconds{800}, [] {});
  EXPECT_LT(shown_time(terminal), before + 0.3);
  terminal.type("p\x11");  // and ^Q
  EXPECT_TRUE(terminal.wait([&](const Terminal& t) {
    return t.shows("paused") && shown_time(t) > before + 0.3;
  })) << terminal.text();
}

TEST(Play, EndsThoughItsOutputIsNotRead) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  // A pseudo-terminal holds some 64 KiB at the most: large pictures fill it.
  for (int i = 0; i < 60; ++i) {
    terminal.resize(250 + i % 2, 90);
    std::this_thread::sleep_for(std::chrono::milliseconds{40});
  }
  terminal.signal(SIGTERM);
  EXPECT_TRUE(terminal.ends_unread());
}

TEST(Play, AnswersKeysAndSignalsWhilePaused) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("p");
  ASSERT_TRUE(terminal.wait_for("paused")) << terminal.text();
  terminal.resize(100, 30);
  EXPECT_TRUE(terminal.wait([](const Terminal& t) {
    return t.row(28).find("paused") != std::string::npos;
  })) << terminal.text();
  terminal.signal(SIGTERM);
  EXPECT_EQ(terminal.wait_for_end(), 128 + SIGTERM);
  EXPECT_TRUE(terminal.given_back());
}

}  // namespace
}  // namespace carom::test::stop_test
