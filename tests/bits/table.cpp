#include "bits/table.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"

namespace carom::bits {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead =
    "# The bits that every scene ends with: SCENE METHOD SECONDS OUTCOME.\n"
    "# The outcome is the hash of the state; \"refused\" where the method does not take the "
    "scene;\n"
    "# \"failed\" where the run says that it cannot go on; \"crashed\" where its process ends.\n"
    "# A change here is a change of results: the commit says why.  To write the table again:\n"
    "#   CAROM_BITS_TABLE=tests/bits/pinned.txt build/release/tests/carom_bits_tests\n";

constexpr const char* kFolders[] = {"scenes", "scenes/hard", "tests/bits/scenes"};

std::vector<std::string> scenes_of(const fs::path& top) {
  std::vector<std::string> scenes;
  for (const char* folder : kFolders) {
    for (const auto& entry : fs::directory_iterator(top / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(".json") && !name.ends_with(".schema.json")) {
        scenes.push_back(folder + ("/" + name));
      }
    }
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

}  // namespace

std::string to_line(const Row& row) {
  std::ostringstream line;
  line.precision(17);
  line << row.scene << ' ' << method_name(row.method) << ' ' << row.seconds << ' ' << row.outcome;
  return line.str();
}

std::vector<Row> read_table(const fs::path& file) {
  std::vector<Row> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    Row row;
    std::string method;
    words >> row.scene >> method >> row.seconds >> row.outcome;
    row.method = method == method_name(Method::event) ? Method::event : Method::overlap;
    rows.push_back(row);
  }
  return rows;
}

void write_table(const fs::path& file, const std::vector<Row>& rows) {
  std::ofstream out(file);
  out << kHead;
  for (const Row& row : rows) out << to_line(row) << '\n';
}

std::vector<Row> all_rows(const fs::path& top, const std::vector<Row>& known, double seconds) {
  std::vector<Row> rows;
  for (const std::string& scene : scenes_of(top)) {
    for (const Method method : {Method::event, Method::overlap}) {
      const auto row = std::find_if(known.begin(), known.end(), [&](const Row& each) {
        return each.scene == scene && each.method == method;
      });
      if (row != known.end()) {
        rows.push_back(*row);
      } else {
        const double whole = read_scene(top / scene).duration;
        rows.push_back({scene, method, std::min(whole, seconds), "not pinned"});
      }
    }
  }
  return rows;
}

}  // namespace carom::bits
