#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "carom/scene_file.hpp"
#include "commands.hpp"
#include "export/output_file.hpp"
#include "export/unfinished_files.hpp"
#include "load_scene.hpp"
#include "one_file.hpp"
#include "scene_files.hpp"
#include "standard_streams.hpp"
#include "view/player.hpp"
#include "view/recorder.hpp"
#include "view/settings_file.hpp"
#include "view/signals.hpp"
#include "view/terminal_info.hpp"
#include "view/terminal_screen.hpp"

namespace carom {
namespace {

constexpr const char* kBuiltIn = "break";
constexpr int kEndedBySignal = 128;  // as a shell tells it
constexpr const char* kInstead = "; 'carom run SCENE' needs no terminal";

/// As https://no-color.org has it: set and not empty.
bool colors_wanted(const Options& options) {
  const char* const refused = std::getenv("NO_COLOR");
  return !options.no_color && (refused == nullptr || *refused == '\0');
}

/// The file's, where the command line says nothing.
Settings settings_of(const Options& options, const StoredSettings& stored, Palette palette) {
  Settings settings;
  settings.palette = palette;
  settings.glyphs = stored.glyphs.value_or(settings.glyphs);
  if (const auto named = glyphs_named(options.glyphs)) settings.glyphs = *named;
  settings.frames_per_second = stored.fps.value_or(settings.frames_per_second);
  if (options.fps) settings.frames_per_second = static_cast<int>(*options.fps);
  settings.scene_library.names = scene_names();
  settings.scene_library.load = [](const std::string& name) {
    return read_scene(find_scene(name));
  };
  settings.scene = options.scenes.empty() ? kBuiltIn : options.scenes.front();
  settings.folder.assign(1, '.');  // the current one
  return settings;
}

StoredSettings stored_settings() {
  try {
    return read_settings(settings_file());
  } catch (const std::runtime_error& error) {
    throw UsageError(error.what());
  }
}

/// What a key chose is the default from now on.
void remember(const std::optional<Glyphs>& chosen) {
  if (!chosen) return;
  try {
    remember_glyphs(settings_file(), *chosen);
  } catch (const std::exception& error) {
    print_error_line(std::string("the glyphs are not remembered: ") + error.what());
  }
}

void require_terminal() {
  for (const auto& [descriptor, name] :
       {std::pair(STDIN_FILENO, "standard input"), {STDOUT_FILENO, "standard output"}}) {
    if (isatty(descriptor) == 0)
      throw UsageError(std::string("play needs a terminal, and ") + name + " is none" + kInstead);
  }
}

/// The screen is standard output.
void refuse_the_screen(const char* option, const std::string& file) {
  if (!is_standard_output(file)) return;
  throw UsageError(std::string(option) + ": must be a file: standard output is the screen");
}

/// The files that are written in the end, opened before anything is shown.
struct Outputs {
  explicit Outputs(const Options& options, Palette palette) : log("--log", options.log) {
    if (!options.record.empty())
      record = std::make_unique<Recorder>("--record", options.record, palette);
  }

  OutputFile log;
  std::unique_ptr<Recorder> record;
};

std::unique_ptr<Outputs> open_outputs(const Options& options, Palette palette) {
  refuse_the_screen("--record", options.record);
  refuse_the_screen("--log", options.log);
  refuse_one_file_for_two({{"--record", options.record}, {"--log", options.log}});
  unfinished_files::remove_on_signals();
  try {
    return std::make_unique<Outputs>(options, palette);
  } catch (const std::system_error& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

int play(const Options& options) {
  const bool builtin = options.scenes.empty();
  if (!builtin && options.scenes.front() == "-")
    throw UsageError("play reads keys from standard input: give the scene as a file");
  const StoredSettings stored = stored_settings();
  Scene scene = builtin ? load_builtin_scene(options) : load_scene(options.scenes.front(), options);
  scene.played = true;
  require_terminal();
  const TerminalInfo info = load_terminal_info();
  if (!info.problem.empty())
    throw UsageError("play needs a terminal, and " + info.problem + kInstead);
  if (!info.remark.empty()) print_error("carom: " + info.remark + '\n');

  TerminalScreen::Options how;
  how.colors = colors_wanted(options);
  how.mouse = !options.no_mouse && stored.mouse.value_or(true);
  how.background = stored.palette.value_or(how.background);
  const Palette palette(how.colors ? info.colors : Colors::none, how.background);

  Signals signals;  // before any worker starts
  const std::unique_ptr<Outputs> outputs = open_outputs(options, palette);
  std::string summary;
  std::string error;
  std::optional<Glyphs> chosen;
  int signal = 0;
  {
    TerminalScreen screen(signals, info, how);
    Player player(scene, screen, settings_of(options, stored, palette));
    player.record(std::move(outputs->record));
    signal = player.play();
    summary = player.summary();
    error = player.recording_error();
    chosen = player.chosen_glyphs();
    if (outputs->log) outputs->log.write(write_scene(player.session().log()));
  }
  outputs->log.commit();
  remember(chosen);
  if (signal != SIGHUP) print("carom: " + summary + '\n');
  if (!error.empty()) throw std::runtime_error(error);
  return signal == 0 ? 0 : kEndedBySignal + signal;
}

}  // namespace carom
