#include "carom/scene_file.hpp"
#include "carom/scene_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "scene/builtin.hpp"
#include "scene/from_tree.hpp"
#include "scene/json_tree.hpp"
#include "scene/judge.hpp"
#include "scene/set_value.hpp"
#include "scene/shape.hpp"
#include "scene/text_check.hpp"

namespace carom {

namespace {

std::string as_line(const std::string& source, const Problem& problem) {
  std::string line = scene::printable(source);
  if (!line.empty()) line += ": ";
  if (!problem.place.empty()) line += problem.place + ": ";
  return line + problem.message;
}

/// `outer` is a place that `inner` lies in, or the same.
bool contains(std::string_view outer, std::string_view inner) {
  return inner.starts_with(outer) && (inner.size() == outer.size() || inner[outer.size()] == '/');
}

/// The order in the file of what a pointer points to, or of the last part of it that is there.
std::size_t ordinal_of(const scene::Value& root, std::string_view pointer) {
  const scene::Value* value = &root;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    const std::string step(pointer.substr(0, end));
    pointer.remove_prefix(end);
    const scene::Value* next = value->find(step);
    if (value->kind == scene::Value::Kind::list) {
      const std::size_t index = std::strtoul(step.c_str(), nullptr, 10);
      if (index < value->items().size()) next = &value->items()[index];
    }
    if (next == nullptr) break;
    value = next;
  }
  return value->ordinal;
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
  if (scene.name.empty()) scene.name = scene::printable(file.stem().string());
  return scene;
}

Scene parse_scene(std::string_view text, const std::string& source,
                  std::span<const SceneChange> changes) {
  if (changes.empty() || !scene::parse_tree(text).complete) return parse_scene(text, source);
  std::string changed(text);
  try {
    for (const SceneChange& change : changes) changed = scene::set_value(changed, change);
  } catch (const SceneError& error) {
    throw SceneError(source, error.problems());
  }
  return parse_scene(changed, source);
}

Scene parse_scene(std::string_view text, const std::string& source) {
  scene::Tree tree = scene::parse_tree(text);
  std::vector<scene::Finding> findings = std::move(tree.findings);
  scene::Draft draft;
  if (tree.complete) {
    for (scene::Finding& finding : scene::find_shape_problems(tree.root)) {
      findings.push_back(std::move(finding));
    }
    const std::size_t shape_findings = findings.size();
    draft = scene::draft_from_tree(tree.root);
    if (tree.root.kind == scene::Value::Kind::object) {
      for (Problem& problem : scene::judge(draft.scene, draft.script_lines)) {
        // What has the wrong shape is not judged for its meaning as well.
        const bool told = std::any_of(
            findings.begin(), findings.begin() + static_cast<std::ptrdiff_t>(shape_findings),
            [&](const scene::Finding& finding) {
              return contains(finding.problem.place, problem.place) ||
                     contains(problem.place, finding.problem.place);
            });
        if (told) continue;
        const std::size_t ordinal = ordinal_of(tree.root, problem.place);
        findings.push_back({ordinal, std::move(problem)});
      }
    }
  }
  if (!findings.empty()) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const auto& a, const auto& b) { return a.ordinal < b.ordinal; });
    std::vector<Problem> problems;
    problems.reserve(findings.size());
    for (scene::Finding& finding : findings) problems.push_back(std::move(finding.problem));
    throw SceneError(source, std::move(problems));
  }
  draft.scene.source = source;
  return std::move(draft.scene);
}

std::vector<Problem> find_problems(const Scene& scene) {
  return scene::judge(scene, {});
}

Scene builtin_scene() {
  return builtin_scene({});
}

Scene builtin_scene(std::span<const SceneChange> changes) {
  return parse_scene(scene::kBuiltin, "the built-in scene", changes);
}

}  // namespace carom
