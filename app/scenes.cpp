#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "carom/scene_file.hpp"
#include "commands.hpp"
#include "scene_files.hpp"
#include "standard_streams.hpp"

namespace carom {
namespace {

constexpr std::size_t kLineWidth = 80;

/// A name, then what it is about, wrapped beside it.
std::string row(const std::string& name, const std::string& about, std::size_t column) {
  std::string text;
  std::string line = fmt::format("{:<{}}", name, column);
  std::istringstream words(about);
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > kLineWidth && line.size() > column) {
      text += line + '\n';
      line = std::string(column, ' ');
    }
    line += ' ' + word;
  }
  return text + line + '\n';
}

std::string about(const std::string& name) {
  try {
    return read_scene(find_scene(name)).about;
  } catch (const SceneError& error) {
    return error.what();
  }
}

}  // namespace

int scenes(const Options&) {
  const std::vector<std::string> names = scene_names();
  if (names.empty()) throw std::runtime_error("no scenes are installed");
  std::size_t column = 0;
  for (const std::string& name : names) column = std::max(column, name.size() + 1);
  std::string text;
  for (const std::string& name : names) text += row(name, about(name), column);
  print(text);
  return 0;
}

}  // namespace carom
