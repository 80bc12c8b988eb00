#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// A command line that cannot be obeyed; one line that quotes the argument and says what to do.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the command line asks for.
struct Options {
  enum class Command { play, run, accuracy, check, verify, sweep, scenes, help, print };

  Command command = Command::play;
  std::string text;                 ///< print: the help or the version
  std::vector<std::string> scenes;  ///< files or installed names; none: the built-in scene

  // Common: what the scene says is replaced by these.
  std::optional<Method> method;
  std::optional<double> step;
  std::optional<int> digits;
  std::optional<std::string> workers;  ///< "per-ball" or a whole number from 1
  std::optional<std::uint64_t> seed;
  std::vector<std::string> set;  ///< each "/POINTER=VALUE", a change of the scene
  bool no_color = false;

  // run
  std::optional<double> time;           ///< simulated seconds of this run
  std::optional<std::uint64_t> frames;  ///< frames of the frame clock of this run
  std::string dump;                     ///< files: empty: none, "-": standard output
  int columns = 80;
  int rows = 24;
  std::uint64_t every = 1;
  std::string report;
  std::string save;
  bool quiet = false;
  std::string trajectory;
  std::string events;
  std::string series;
  std::string trace;
  std::uint64_t trace_frames = 120;
  std::string cast;
  bool no_state = false;
  std::string checkpoint;
  double checkpoint_every = 60;  ///< wall-clock seconds

  // play
  std::string record;
  std::string log;
  std::string glyphs;                ///< empty: of the settings file
  std::optional<std::uint64_t> fps;  ///< of the screen
  bool no_mouse = false;

  // accuracy, which takes the time of run too
  std::vector<std::string> crews;  ///< each as `workers`; the first computes every row
  std::optional<double> target;    ///< error of position, scene units
  double share = 2;                ///< wall-clock seconds of a run
  std::string json;                ///< files, as above
  std::string csv;
  std::string plot;  ///< .svg or .png
  std::uint64_t seeds = 8;
  std::vector<std::string> observables;

  // verify, which takes json and seed too
  std::string case_name;  ///< empty: all
  bool thorough = false;  ///< the long versions
  bool list = false;      ///< name the cases instead

  // sweep, which takes the time, frames and quiet of run
  std::vector<std::string> over;      ///< each "/POINTER=VALUES"
  std::optional<std::uint64_t> jobs;  ///< processes at the same time
  std::string sweep_share;            ///< "I/N"; empty: what the environment says
  bool status = false;
  bool merge = false;
  bool retry = false;
};

/// Reads the arguments, without the program's name; `commit` is printed with the version.
/// Errors: UsageError.
Options parse_options(const std::vector<std::string>& arguments, const std::string& commit = "");

}  // namespace carom
