#include <unistd.h>

#include <cstdlib>
#include <string>

#include "commands.hpp"
#include "load_scene.hpp"
#include "standard_streams.hpp"
#include "view/curses_screen.hpp"
#include "view/player.hpp"
#include "view/signals.hpp"
#include "view/terminal_info.hpp"

namespace carom {
namespace {

constexpr int kEndedBySignal = 128;  // as a shell tells it

/// As https://no-color.org has it: set and not empty.
bool colors_wanted(const Options& options) {
  const char* const refused = std::getenv("NO_COLOR");
  return !options.no_color && (refused == nullptr || *refused == '\0');
}

void require_terminal() {
  const std::string instead = "; 'carom run SCENE' needs no terminal";
  if (isatty(STDIN_FILENO) == 0)
    throw UsageError("play needs a terminal, and standard input is none" + instead);
  if (isatty(STDOUT_FILENO) == 0)
    throw UsageError("play needs a terminal, and standard output is none" + instead);
  const std::string problem = terminal_problem();
  if (!problem.empty()) throw UsageError("play needs a terminal, and " + problem + instead);
}

}  // namespace

int play(const Options& options) {
  const bool builtin = options.scenes.empty();
  if (!builtin && options.scenes.front() == "-")
    throw UsageError("play reads keys from standard input: give the scene as a file");
  Scene scene = builtin ? load_builtin_scene(options) : load_scene(options.scenes.front(), options);
  scene.played = true;
  require_terminal();

  Signals signals;  // before any worker starts
  std::string summary;
  int signal = 0;
  {
    CursesScreen screen(signals, colors_wanted(options));
    Player player(scene, screen);
    signal = player.play();
    summary = player.summary();
  }
  if (signal != SIGHUP) print("carom: " + summary + '\n');
  return signal == 0 ? 0 : kEndedBySignal + signal;
}

}  // namespace carom
