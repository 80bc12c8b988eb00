#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace carom::sweeps {

/// Which points are this task's: point j belongs to share j mod `count`.
struct TaskShare {
  std::size_t index = 0;
  std::size_t count = 1;
  std::string from;  ///< what said so, as in "Slurm array"; empty: nothing did

  [[nodiscard]] bool owns(std::size_t point) const { return point % count == index; }
};

/// Reads "I/N", I from 0.
/// Errors: UsageError.
TaskShare parse_share(const std::string& text);

/// What the environment of Slurm, Open MPI or PMI says; all points where it says nothing.
/// `look` gives the value of a variable.
/// Errors: UsageError where it contradicts itself.
TaskShare share_of_environment(
    const std::function<std::optional<std::string>(const char* name)>& look);

}  // namespace carom::sweeps
