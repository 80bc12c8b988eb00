#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sweep/axis.hpp"

namespace carom::sweeps {

/// What a sweep is: the same for all of its tasks, and never changed.
struct Plan {
  std::string version;
  std::vector<Axis> axes;
  std::vector<std::string> options;  ///< of `carom run`
  std::string scene;                 ///< JSON

  bool operator==(const Plan&) const = default;
};

/// The folder of a sweep, which is all that its tasks know of each other.
///
///     sweep.json         the plan
///     runs/000017.json   what point 17 has measured: whole or not there
///     runs/000017.failed why point 17 has failed
///     runs.csv           a line a point         } once all points are there
///     summary.csv        means over the seeds   }
///
/// Errors: std::system_error, UsageError for a folder that is not a sweep's, or another's.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}

  /// Makes the folder of this plan, or finds it.
  void begin(const Plan& plan) const;
  [[nodiscard]] Plan plan() const;

  enum class State { open, done, failed };
  [[nodiscard]] State state(std::size_t point) const;
  void put_report(std::size_t point, const std::string& report) const;
  void put_failure(std::size_t point, const std::string& message) const;
  [[nodiscard]] std::string report(std::size_t point) const;
  [[nodiscard]] std::string failure(std::size_t point) const;
  /// Puts a file of the folder in its place, whole.
  void put(const std::string& name, const std::string& text) const;
  /// Removes what tasks that were killed have left unfinished.
  void tidy() const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[nodiscard]] std::filesystem::path file(std::size_t point, const char* extension) const;

  std::filesystem::path path_;
};

}  // namespace carom::sweeps
