#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// What the command line asks for.
struct Options {
  enum class Command { play, run, check };

  Command command = Command::play;
  std::vector<std::string> scenes;  ///< files; none: the built-in scene

  // Common: what the scene says is replaced by these.
  std::optional<Method> method;
  std::optional<double> step;
  std::optional<int> digits;
  std::optional<std::string> workers;
  std::optional<std::uint64_t> seed;
  bool no_color = false;

  // run
  std::optional<double> time;
  std::optional<std::uint64_t> frames;
  std::string dump;
  int columns = 80;
  int rows = 24;
  std::uint64_t every = 1;
  std::string report;
  std::string save;
  bool quiet = false;
};

}  // namespace carom
