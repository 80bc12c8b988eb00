#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace carom::test {

/// A scene in a file that goes away with this.
class SceneFile {
 public:
  explicit SceneFile(const std::string& json) {
    std::string name = std::filesystem::temp_directory_path() / "carom-XXXXXX";
    const int file = mkstemp(name.data());
    if (file >= 0) close(file);
    path_ = name;
    std::ofstream(path_) << json;
  }
  ~SceneFile() { std::filesystem::remove(path_); }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Three balls that fly, under gravity that can be switched off.
inline const char* const kThreeBalls = R"({
  "name": "three", "box": {"width": 20, "height": 10},
  "effects": {"walls": {"restitution": 1}, "collisions": {"restitution": 1}, "gravity": [0, -2]},
  "balls": [{"position": [3, 5], "velocity": [4, 1]}, {"position": [10, 3], "velocity": [-3, 2]},
            {"position": [17, 7], "velocity": [-2, -3]}],
  "solver": {"method": "overlap"}, "workers": "per-ball"})";

}  // namespace carom::test
