#include "sweep/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "options.hpp"

namespace carom::sweeps {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::system_error(errno, std::generic_category(), file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string json_of(const Plan& plan) {
  Json json;
  json["version"] = plan.version;
  json["axes"] = Json::array();
  for (const Axis& axis : plan.axes) {
    json["axes"].push_back({{"pointer", axis.pointer}, {"values", axis.values}});
  }
  json["options"] = plan.options;
  json["scene"] = Json::parse(plan.scene);
  return json.dump(1) + '\n';
}

/// A file beside the one to write, with all of the text.
fs::path write_beside(const fs::path& target, const std::string& text) {
  std::array<char, 256> host{};  // of the many that may share the folder
  (void)gethostname(host.data(), host.size() - 1);
  fs::path name =
      target.parent_path() /
      fmt::format(".{}.{}.{}.unfinished", target.filename().string(), host.data(), getpid());
  const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const auto fail = [&] {
    const int error = errno;
    if (file >= 0) close(file);
    (void)unlink(name.c_str());
    throw std::system_error(error, std::generic_category(), target.string());
  };
  if (file < 0) fail();
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0) fail();
    done += static_cast<std::size_t>(written);
  }
  if (fsync(file) != 0) fail();
  close(file);
  return name;
}

/// Of several tasks that begin at once one makes the plan.
void make(const fs::path& target, const std::string& text) {
  const fs::path name = write_beside(target, text);
  const bool made = link(name.c_str(), target.c_str()) == 0;
  const int why = errno;
  (void)unlink(name.c_str());
  if (!made && why != EEXIST)
    throw std::system_error(why, std::generic_category(), target.string());
}

}  // namespace

void Folder::begin(const Plan& plan) const {
  std::error_code error;
  if (fs::exists(path_, error) && !fs::exists(path_ / "sweep.json", error) &&
      !fs::is_empty(path_, error) && !fs::exists(path_ / "runs", error)) {
    throw UsageError(
        fmt::format("'{}' is not empty and holds no sweep: name a new folder", path_.string()));
  }
  fs::create_directories(path_ / "runs", error);
  if (error) throw UsageError(fmt::format("'{}': {}", path_.string(), error.message()));
  const fs::path target = path_ / "sweep.json";
  const std::string text = json_of(plan);
  if (!fs::exists(target)) {
    try {
      make(target, text);
    } catch (const std::system_error& refused) {
      throw UsageError(refused.what());
    }
  }
  if (text_of(target) == text) return;
  throw UsageError(fmt::format(
      "'{}' holds another sweep: its scene, axes, options or version differ; name a new folder",
      path_.string()));
}

Plan Folder::plan() const {
  const fs::path file = path_ / "sweep.json";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw UsageError(
        fmt::format("'{}' is not the folder of a sweep: it has no sweep.json", path_.string()));
  }
  try {
    const Json json = Json::parse(text_of(file));
    Plan plan;
    plan.version = json.at("version");
    for (const Json& axis : json.at("axes")) {
      plan.axes.push_back({axis.at("pointer"), axis.at("values")});
    }
    plan.options = json.at("options");
    plan.scene = json.at("scene").dump(1);
    return plan;
  } catch (const Json::exception&) {
    throw UsageError(fmt::format("'{}' is not the plan of a sweep", file.string()));
  }
}

fs::path Folder::file(std::size_t point, const char* extension) const {
  return path_ / "runs" / fmt::format("{:06}.{}", point, extension);
}

auto Folder::state(std::size_t point) const -> State {
  if (access(file(point, "json").c_str(), F_OK) == 0) return State::done;
  return access(file(point, "failed").c_str(), F_OK) == 0 ? State::failed : State::open;
}

void Folder::put_report(std::size_t point, const std::string& report) const {
  put("runs/" + file(point, "json").filename().string(), report);
  (void)unlink(file(point, "failed").c_str());
}

void Folder::put_failure(std::size_t point, const std::string& message) const {
  put("runs/" + file(point, "failed").filename().string(), message);
}

std::string Folder::report(std::size_t point) const {
  return text_of(file(point, "json"));
}

std::string Folder::failure(std::size_t point) const {
  return text_of(file(point, "failed"));
}

void Folder::put(const std::string& name, const std::string& text) const {
  const fs::path target = path_ / name;
  constexpr int kAttempts = 3;
  for (int attempt = 1;; ++attempt) {
    const fs::path beside = write_beside(target, text);
    if (rename(beside.c_str(), target.c_str()) == 0) return;
    const int error = errno;
    // Another task that found all done has tidied the folder meanwhile.
    if (error == ENOENT && attempt < kAttempts) continue;
    (void)unlink(beside.c_str());
    throw std::system_error(error, std::generic_category(), target.string());
  }
}

void Folder::tidy() const {
  std::error_code ignored;
  for (const fs::path& folder : {path_, path_ / "runs"}) {
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with('.') && name.ends_with(".unfinished")) fs::remove(entry, ignored);
    }
  }
}

}  // namespace carom::sweeps
