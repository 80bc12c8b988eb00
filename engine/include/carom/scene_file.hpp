#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "carom/scene.hpp"

namespace carom {

/// One thing that is wrong with a scene.
struct Problem {
  std::string place;    ///< JSON pointer, "line 3, column 5", or empty for the whole file
  std::string message;  ///< what is wrong and what would be right
};

/// A scene that cannot be run.
/// Holds: at least one problem; `what()` is the first one, as one line: "FILE: PLACE: MESSAGE".
class SceneError : public std::runtime_error {
 public:
  SceneError(std::string source, std::vector<Problem> problems);

  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  /// A problem as the line a user reads, without the program's name.
  [[nodiscard]] std::string line(const Problem& problem) const;

 private:
  std::string source_;
  std::vector<Problem> problems_;
};

/// Reads and checks a scene.
/// Errors: SceneError with every problem found, in the file's order.
Scene read_scene(const std::filesystem::path& file);

/// The same from text; `source` is the name used in messages.
Scene parse_scene(std::string_view text, const std::string& source);

/// What has been found right before, and has not changed since.
enum class Known { nothing, balls };

/// What is wrong with a scene that was made or changed in the program.
std::vector<Problem> find_problems(const Scene& scene, Known known = Known::nothing);

/// The scene as JSON text that `parse_scene` reads back to the same bits.
std::string write_scene(const Scene& scene);

/// The JSON Schema of scenes, as text: scenes/scene.schema.json.
std::string scene_schema();

/// The break of fifteen balls: what carom plays when no scene is named.
Scene builtin_scene();

}  // namespace carom
