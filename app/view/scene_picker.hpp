#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "carom/session.hpp"
#include "view/canvas.hpp"
#include "view/glyphs.hpp"
#include "view/user_interface.hpp"

namespace carom {

/// The scenes that can be chosen while one is played.
struct SceneLibrary {
  std::vector<std::string> names;
  /// Errors: SceneError.
  std::function<Scene(const std::string& name)> load;
};

/// The list of all scenes, with what the chosen one is about and how it moves.
///
/// Threads: the control thread only.
class ScenePicker {
 public:
  static constexpr std::size_t kMostBalls = 2000;  ///< more are not shown moving

  explicit ScenePicker(const SceneLibrary& library, const std::string& present);

  void move(int lines);
  /// On to the next name that begins with this letter.
  void seek(char letter);
  /// The name in a cell of the picture is chosen; false where there is none.
  bool choose_at(int column, int row, int columns, int rows);
  [[nodiscard]] const std::string& chosen() const { return library_.names[chosen_]; }

  /// Moves the preview on by `seconds`, until `limit` at the longest.
  void move_preview(const UserInterface& clock, double seconds, Instant limit);
  [[nodiscard]] Canvas picture(int columns, int rows, Glyphs glyphs) const;

 private:
  void choose(std::size_t place);
  void load();
  [[nodiscard]] std::size_t first_line(int lines) const;  // that is shown of so many

  const SceneLibrary& library_;
  std::size_t chosen_ = 0;
  std::optional<Instant> rests_since_;  // the choice
  bool loaded_ = false;
  std::string about_;
  std::string no_preview_;  // why
  std::unique_ptr<Session> preview_;
};

}  // namespace carom
