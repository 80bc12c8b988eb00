#include "hard/reference_scene.hpp"

#include <filesystem>
#include <fstream>

#include "carom/scene_file.hpp"

namespace carom::test {

ReferenceScene reference_scene(const std::string& name) {
  std::ifstream in(std::filesystem::path(CAROM_SOURCE_DIR) / "tests/hard/reference" /
                   (name + ".json"));
  const auto file = nlohmann::json::parse(in);
  return {parse_scene(file["scene"].dump(), name), file["time"].get<double>(),
          file["condition"].get<double>(), file["expected"]};
}

}  // namespace carom::test
