#include "carom/scene_file.hpp"
#include "carom/scene_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "json/reader.hpp"
#include "json/text.hpp"
#include "json/well_formed.hpp"
#include "scene/builtin.hpp"
#include "scene/judge.hpp"
#include "scene/read_scene.hpp"
#include "scene/set_value.hpp"

namespace carom {

namespace {

std::string as_line(const std::string& source, const Problem& problem) {
  std::string line = json::printable(source);
  if (!line.empty()) line += ": ";
  if (!problem.place.empty()) line += problem.place + ": ";
  return line + problem.message;
}

/// Places that were told to be wrong.
class Told {
 public:
  explicit Told(const std::vector<scene::Finding>& findings) {
    for (const scene::Finding& finding : findings) places_.push_back(finding.problem.place);
    std::sort(places_.begin(), places_.end());
  }

  /// Something around the place, the place itself or something in it was told.
  [[nodiscard]] bool meets(const std::string& place) const {
    for (std::size_t end = 0; end <= place.size(); ++end) {
      const bool is_step = end == 0 || end == place.size() || place[end] == '/';
      if (is_step && std::binary_search(places_.begin(), places_.end(), place.substr(0, end))) {
        return true;
      }
    }
    const auto inside = std::lower_bound(places_.begin(), places_.end(), place + '/');
    return inside != places_.end() && inside->starts_with(place + '/');
  }

 private:
  std::vector<std::string> places_;
};

/// What the scene means, less what has the wrong shape already, at its place in the text.
void judge_meaning(std::string_view text, const scene::Draft& draft,
                   std::vector<scene::Finding>& findings) {
  std::vector<Problem> problems = scene::judge(draft.scene, draft.script_lines);
  if (problems.empty()) return;
  const Told told(findings);
  std::erase_if(problems, [&](const Problem& problem) { return told.meets(problem.place); });
  std::vector<std::string_view> places;
  for (const Problem& problem : problems) places.emplace_back(problem.place);
  const std::vector<std::size_t> offsets = scene::offsets_of(text, places);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    findings.push_back({offsets[i], std::move(problems[i])});
  }
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The whole text; reads no further than the first byte that no text has, so that a device that
/// never ends is refused as well.
std::string read_text(const std::filesystem::path& path, const std::string& source) {
  const bool standard_input = path == "-";
  std::error_code ignored;
  if (!standard_input && std::filesystem::is_directory(path, ignored)) {
    throw SceneError(source, {{"", "is a directory, name a scene file"}});
  }
  errno = 0;
  const File file = standard_input ? File(stdin, [](std::FILE*) { return 0; })
                                   : File(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) {
    throw SceneError(source, {{"", fmt::format("cannot be opened: {}", std::strerror(errno))}});
  }
  std::string text;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  constexpr std::uintmax_t kMostAtOnce = std::uintmax_t{1} << 32;
  if (!ignored && size < kMostAtOnce) text.reserve(size);
  std::vector<char> chunk(std::size_t{1} << 16);
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    text.append(chunk.data(), got);
    if (std::memchr(chunk.data(), 0, got) != nullptr) break;
  }
  if (std::ferror(file.get()) != 0) {
    throw SceneError(source, {{"", fmt::format("cannot be read: {}", std::strerror(errno))}});
  }
  return text;
}

}  // namespace

SceneError::SceneError(std::string source, std::vector<Problem> problems)
    : std::runtime_error(as_line(source, problems.front())),
      source_(std::move(source)),
      problems_(std::move(problems)) {}

std::string SceneError::line(const Problem& problem) const {
  return as_line(source_, problem);
}

Scene read_scene(const std::filesystem::path& file) {
  return read_scene(file, {});
}

Scene read_scene(const std::filesystem::path& file, std::span<const SceneChange> changes) {
  const std::string source = file == "-" ? "standard input" : file.string();
  Scene scene = parse_scene(read_text(file, source), source, changes);
  if (scene.name.empty()) scene.name = json::printable(file.stem().string());
  return scene;
}

Scene parse_scene(std::string_view text, const std::string& source,
                  std::span<const SceneChange> changes) {
  if (changes.empty() || !json::is_well_formed(text)) return parse_scene(text, source);
  std::string changed(text);
  try {
    for (const SceneChange& change : changes) changed = scene::set_value(changed, change);
  } catch (const SceneError& error) {
    throw SceneError(source, error.problems());
  }
  return parse_scene(changed, source);
}

Scene parse_scene(std::string_view text, const std::string& source) {
  scene::Draft draft = scene::read_draft(text);
  std::vector<scene::Finding> findings = std::move(draft.findings);
  if (draft.complete) judge_meaning(text, draft, findings);
  if (!findings.empty()) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const auto& a, const auto& b) { return a.offset < b.offset; });
    std::vector<Problem> problems;
    problems.reserve(findings.size());
    for (scene::Finding& finding : findings) problems.push_back(std::move(finding.problem));
    throw SceneError(source, std::move(problems));
  }
  draft.scene.source = source;
  return std::move(draft.scene);
}

std::vector<Problem> find_problems(const Scene& scene, Known known) {
  return scene::judge(scene, {}, known);
}

Scene builtin_scene() {
  return builtin_scene({});
}

Scene builtin_scene(std::span<const SceneChange> changes) {
  return parse_scene(scene::kBuiltin, "the built-in scene", changes);
}

}  // namespace carom
