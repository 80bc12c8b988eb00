#include "read_scene.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "carom/scene_file.hpp"

namespace {

void demand(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const carom::Scene scene = carom::parse_scene(text, "fuzz");
    demand(carom::find_problems(scene).empty(), "a scene that is read has no problems");
    const std::string written = carom::write_scene(scene);
    const carom::Scene back = carom::parse_scene(written, "written");
    demand(carom::write_scene(back) == written, "a scene that is written is read back the same");
    std::size_t balls = scene.balls.size();
    for (const carom::Fill& fill : scene.fills) balls += fill.count;
    constexpr std::size_t kFew = 500;  // so that a run is short
    if (balls <= kFew) {
      demand(carom::populate(scene).size() == balls, "a fill makes as many balls as it says");
    }
  } catch (const carom::SceneError& error) {
    demand(!error.problems().empty(), "what is refused has a problem");
    for (const carom::Problem& problem : error.problems()) {
      const std::string line = error.line(problem);
      for (const char c : line) {
        demand(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F, "a problem is one clean line");
      }
    }
  }
  return 0;
}
