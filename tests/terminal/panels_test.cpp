// The panels in a terminal: what keys open, at every size, after a stop, and within others.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "scenes.hpp"
#include "steps.hpp"
#include "terminal.hpp"

namespace carom::test::panels_test {
namespace {

TEST(Panels, ShowWhatTheThreadsDoAndGoFromBarrierToBarrier) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("l");
  for (const char* const words :
       {"control", "worker 0", "worker 2", "do_frame", "frame_done", "# computes", "waiting "})
    EXPECT_TRUE(terminal.wait_for(words)) << words << terminal.text();
  terminal.type("L");
  ASSERT_TRUE(terminal.wait_for("All workers wait at do_frame")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("paused")) << terminal.text();
  for (int round = 0; round < 2; ++round) {
    for (const char* const barrier :
         {"do_frame: The control thread", "wall_computation: Every ball has flown",
          "pair_computation: Every pair", "frame_done: All workers are done"}) {
      terminal.type(".");
      EXPECT_TRUE(terminal.wait_for(barrier)) << barrier << terminal.text();
    }
  }
  terminal.type("Ll");
  EXPECT_TRUE(terminal.wait([](const Terminal& t) { return !t.shows("control"); }))
      << terminal.text();
  expect_end_by_key(terminal);
}

TEST(Panels, ShowTheInstruments) {
  const SceneFile scene(kThreeBalls);
  Terminal::Settings settings;
  settings.columns = 120;
  settings.rows = 40;
  Terminal terminal({scene.path()}, settings);
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("h");
  for (const char* const words : {"temperature", "pressure", "impacts / s", "free path", "kinetic",
                                  "potential", "dissipated", "error", "Maxwell"})
    EXPECT_TRUE(terminal.wait_for(words)) << words << terminal.text();
  terminal.type("E");
  EXPECT_TRUE(terminal.wait_for("right so far")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("energy dissipated 0")) << terminal.text();
}

TEST(Panels, ShowTheNumbersThatFollowFromTheScene) {
  // The momentum is (-1, 0), so that of 21.5 of kinetic energy 1/6 is no heat, and two balls' worth
  // of freedom is left: T = (21.5 - 1/6) / 2.
  const SceneFile scene(R"({"box": {"width": 20, "height": 10, "periodic": ["x", "y"]},
    "effects": {"collisions": {}}, "solver": {"method": "event"}, "workers": 2,
    "balls": [{"position": [3, 5], "velocity": [4, 1]}, {"position": [10, 3], "velocity": [-3, 2]},
              {"position": [17, 7], "velocity": [-2, -3]}]})");
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("h");
  EXPECT_TRUE(terminal.wait_for("temperature 10.67 ")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("kinetic    21.5 ")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("potential  0 ")) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("dissipated 0 ")) << terminal.text();
}

TEST(Panels, HoldAtEverySizeThroughAStormOfThem) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path(), "--fps", "60"});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("hlEzvN");
  for (int k = 0; k < 200; ++k) {
    terminal.resize(1 + k * 37 % 300, 1 + k * 13 % 100);
    terminal.watch(std::chrono::milliseconds{5}, [] {});
  }
  struct {
    int columns;
    int rows;
  } const sizes[] = {{300, 100}, {20, 8}, {300, 8}, {20, 100}, {80, 24}, {96, 30}, {200, 60}};
  for (const auto& size : sizes) {
    terminal.resize(size.columns, size.rows);
    const int status = status_row(size.rows);
    EXPECT_TRUE(terminal.wait([&](const Terminal& t) {
      return t.row(status).find(" s ") != std::string::npos ||
             t.row(status).find(" s") == t.row(status).size() - 2;
    })) << size.columns
        << 'x' << size.rows << '\n'
        << terminal.text();
  }
  expect_end_by_key(terminal);
}

TEST(Panels, AreThereAgainAfterAStop) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal({scene.path()});
  ASSERT_TRUE(terminal.wait_for("fps")) << terminal.text();
  terminal.type("l");
  ASSERT_TRUE(terminal.wait_for("frame_done")) << terminal.text();
  expect_stop_by_key(terminal);
  terminal.signal(SIGCONT);
  EXPECT_TRUE(terminal.wait([](const Terminal& t) {
    return t.alternate_screen() && t.shows("frame_done");
  })) << terminal.text();
}

/// Runs carom within another program that is a terminal.
void play_within(const std::vector<std::string>& words) {
  const SceneFile scene(kThreeBalls);
  Terminal terminal([&] {
    for (const char* const name : {"TMUX", "STY", "COLORTERM"}) unsetenv(name);
    setenv("LANG", "C.UTF-8", 1);
    setenv("HOME", "/nonexistent", 1);
    std::vector<std::string> copies = words;
    copies.emplace_back(CAROM_PROGRAM);
    copies.push_back(scene.path());
    copies.emplace_back("--glyphs");
    copies.emplace_back("blocks");
    std::vector<char*> pointers;
    pointers.reserve(copies.size() + 1);
    for (std::string& each : copies) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    execvp(pointers.front(), pointers.data());
    return 127;
  });
  if (!terminal.wait_for("fps") && terminal.output().empty())
    GTEST_SKIP() << words.front() << " is not here";
  terminal.type("h");
  EXPECT_TRUE(terminal.wait_for("temperature")) << terminal.text();
  terminal.type("h");
  terminal.type("l");
  EXPECT_TRUE(terminal.wait_for("frame_done")) << terminal.text();
  terminal.resize(120, 40);
  EXPECT_TRUE(terminal.wait([](const Terminal& t) {
    return t.row(37).find(" s ") != std::string::npos || t.row(38).find(" s ") != std::string::npos;
  })) << terminal.text();
  expect_end_by_key(terminal);
}

bool is_here(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;  // NOLINT
}

TEST(Panels, HoldWithinTmux) {
  if (!is_here("tmux")) GTEST_SKIP() << "tmux is not here";
  const std::string name = "carom-test-" + std::to_string(getpid());
  play_within({"tmux", "-L", name, "-f", "/dev/null", "new-session"});
}

TEST(Panels, HoldWithinScreen) {
  if (!is_here("screen")) GTEST_SKIP() << "screen is not here";
  play_within({"screen", "-c", "/dev/null", "-U"});
}

}  // namespace
}  // namespace carom::test::panels_test
