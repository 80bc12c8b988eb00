#include <unistd.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "commands.hpp"
#include "load_scene.hpp"
#include "standard_streams.hpp"
#include "view/player.hpp"
#include "view/signals.hpp"
#include "view/terminal_info.hpp"
#include "view/terminal_screen.hpp"

namespace carom {
namespace {

constexpr int kEndedBySignal = 128;  // as a shell tells it
constexpr const char* kInstead = "; 'carom run SCENE' needs no terminal";

/// As https://no-color.org has it: set and not empty.
bool colors_wanted(const Options& options) {
  const char* const refused = std::getenv("NO_COLOR");
  return !options.no_color && (refused == nullptr || *refused == '\0');
}

Settings settings_of(const Options& options) {
  Settings settings;
  settings.glyphs = glyphs_named(options.glyphs).value_or(settings.glyphs);
  settings.frames_per_second = static_cast<int>(options.fps);
  return settings;
}

void require_terminal() {
  for (const auto& [descriptor, name] :
       {std::pair(STDIN_FILENO, "standard input"), {STDOUT_FILENO, "standard output"}}) {
    if (isatty(descriptor) == 0)
      throw UsageError(std::string("play needs a terminal, and ") + name + " is none" + kInstead);
  }
}

}  // namespace

int play(const Options& options) {
  const bool builtin = options.scenes.empty();
  if (!builtin && options.scenes.front() == "-")
    throw UsageError("play reads keys from standard input: give the scene as a file");
  Scene scene = builtin ? load_builtin_scene(options) : load_scene(options.scenes.front(), options);
  scene.played = true;
  require_terminal();
  const TerminalInfo info = load_terminal_info();
  if (!info.problem.empty())
    throw UsageError("play needs a terminal, and " + info.problem + kInstead);
  if (!info.remark.empty()) print_error("carom: " + info.remark + '\n');

  Signals signals;  // before any worker starts
  std::string summary;
  int signal = 0;
  {
    TerminalScreen::Options how;
    how.colors = colors_wanted(options);
    TerminalScreen screen(signals, info, how);
    Player player(scene, screen, settings_of(options));
    signal = player.play();
    summary = player.summary();
  }
  if (signal != SIGHUP) print("carom: " + summary + '\n');
  return signal == 0 ? 0 : kEndedBySignal + signal;
}

}  // namespace carom
