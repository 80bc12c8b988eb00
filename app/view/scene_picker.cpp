#include "view/scene_picker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "carom/crew.hpp"
#include "carom/scene_file.hpp"
#include "view/paint.hpp"
#include "view/panel.hpp"

namespace carom {
namespace {

constexpr int kWithPreview = 60;  // columns from which there is room for more than the list
constexpr std::chrono::milliseconds kRests{120};  // so long a choice stays before it is loaded

int list_width(const std::vector<std::string>& names, int columns) {
  std::size_t widest = 0;
  for (const std::string& name : names) widest = std::max(widest, name.size());
  constexpr int kTitle = 16;  // the list has room for its title
  const int wanted = std::max(static_cast<int>(widest) + 2, kTitle) + kFrame;
  return columns < kWithPreview ? columns : std::min(wanted, columns / 2);
}

std::vector<std::string> wrapped(const std::string& text, int width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits =
        !lines.empty() && lines.back().size() + 1 + word.size() <= static_cast<std::size_t>(width);
    if (fits) {
      lines.back() += ' ' + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::size_t count_balls(const Scene& scene) {
  std::size_t balls = scene.balls.size();
  for (const Fill& fill : scene.fills) balls += fill.count;
  return balls;
}

}  // namespace

ScenePicker::ScenePicker(const SceneLibrary& library, const std::string& present)
    : library_(library) {
  const auto at = std::find(library.names.begin(), library.names.end(), present);
  if (at != library.names.end()) chosen_ = static_cast<std::size_t>(at - library.names.begin());
}

void ScenePicker::choose(std::size_t place) {
  if (place == chosen_) return;
  chosen_ = place;
  rests_since_.reset();
  loaded_ = false;
  preview_.reset();
  about_.clear();
  no_preview_.clear();
}

void ScenePicker::move(int lines) {
  const auto last = static_cast<int>(library_.names.size()) - 1;
  choose(static_cast<std::size_t>(std::clamp(static_cast<int>(chosen_) + lines, 0, last)));
}

void ScenePicker::seek(char letter) {
  const std::size_t count = library_.names.size();
  for (std::size_t i = 1; i <= count; ++i) {
    const std::size_t place = (chosen_ + i) % count;
    if (library_.names[place].front() == letter) return choose(place);
  }
}

std::size_t ScenePicker::first_line(int lines) const {
  const auto room = static_cast<std::size_t>(std::max(1, lines));
  const std::size_t count = library_.names.size();
  if (count <= room || chosen_ < room / 2) return 0;
  return std::min(chosen_ - room / 2, count - room);
}

bool ScenePicker::choose_at(int column, int row, int columns, int rows) {
  const int lines = rows - kFrame;
  if (column >= list_width(library_.names, columns) || row < kEdge || row > lines) return false;
  const std::size_t place = first_line(lines) + static_cast<std::size_t>(row - kEdge);
  if (place >= library_.names.size()) return false;
  choose(place);
  return true;
}

void ScenePicker::load() {
  loaded_ = true;
  try {
    Scene scene = library_.load(chosen());
    about_ = scene.about;
    const std::size_t balls = count_balls(scene);
    if (balls > kMostBalls) {
      no_preview_ = fmt::format("{} balls: no preview", balls);
      return;
    }
    scene.per_ball = false;
    scene.workers = 1;
    preview_ = std::make_unique<Session>(std::move(scene));
  } catch (const SceneError& error) {
    no_preview_ = error.problems().front().message;
  } catch (const CrewError& error) {
    no_preview_ = error.what();
  }
}

void ScenePicker::move_preview(const UserInterface& clock, double seconds, Instant limit) {
  const Instant now = clock.now();
  if (!rests_since_) rests_since_ = now;
  if (!loaded_ && now >= *rests_since_ + kRests) load();
  if (!preview_ || preview_->quit()) return;
  const double target = preview_->clock() + seconds;
  do {
    const double step = preview_->simulation().step();
    preview_->advance_clock_to(std::min(target, preview_->clock() + step));
  } while (preview_->clock() < target && !preview_->quit() && clock.now() < limit);
}

Canvas ScenePicker::picture(int columns, int rows, Glyphs glyphs) const {
  Canvas picture(columns, rows);
  const int width = list_width(library_.names, columns);
  Canvas list(width - kFrame, rows - kFrame);
  const std::size_t first = first_line(list.rows);
  for (int row = 0; row < list.rows; ++row) {
    const std::size_t place = first + static_cast<std::size_t>(row);
    if (place >= library_.names.size()) break;
    std::string line = ' ' + library_.names[place];
    line.resize(static_cast<std::size_t>(std::max(0, list.columns)), ' ');
    list.write(0, row, line, place == chosen_ ? Ink::chosen : Ink::status);
  }
  lay_over(framed(list, fmt::format("scenes, {}", library_.names.size()), glyphs), 0, 0, picture);
  const int beside = columns - width;
  if (beside <= kFrame) return picture;
  std::vector<std::string> about = wrapped(about_, beside - 2);
  const Canvas text = text_block(about, beside - 2, rows / 2);
  lay_over(text, width + 1, 0, picture);
  const int top = text.rows + 1;
  if (preview_ && rows - top >= 3) {
    Canvas box(beside, rows - top);
    Drawing drawing;
    drawing.glyphs = glyphs;
    paint(preview_->simulation().frame(), box, drawing);
    lay_over(box, width, top, picture);
  } else if (!no_preview_.empty()) {
    picture.write(width + 1, top, no_preview_, Ink::notice);
  }
  return picture;
}

}  // namespace carom
