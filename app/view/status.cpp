#include "view/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "text/counted.hpp"

namespace carom {
namespace {

constexpr std::size_t kApart = 2;  // blanks between fields

struct Field {
  std::string text;  ///< empty: nothing to say
  int rank = 0;      ///< fields of a low one are shown before those of a higher one
};

std::string pace_text(const Status& status) {
  if (status.paused) return "paused";
  if (status.pace)
    return fmt::format("too slow: {:.2g}x of {}", *status.pace, speed_text(status.speed));
  return speed_text(status.speed);
}

std::string energy_text(double error) {
  return error == 0 ? "energy error 0" : fmt::format("energy error {:.0e}", std::abs(error));
}

}  // namespace

std::string speed_text(double speed) {
  return speed >= 1 ? fmt::format("{:g}x", speed) : fmt::format("1/{:g}x", 1 / speed);
}

std::string status_line(const Status& status, int width) {
  const bool moves = !status.paused;
  const std::vector<Field> fields{
      {status.scene, 4},
      {counted(status.balls, "ball", "balls"), 3},
      {counted(status.workers, "worker", "workers"), 8},
      {fmt::format("{:.2f} s", status.time), 0},
      {pace_text(status), 1},
      {moves ? fmt::format("{:.0f} fps", status.frames_per_second) : "", 6},
      {status.late == 0 ? "" : counted(status.late, "frame late", "frames late"), 5},
      {moves ? fmt::format("computing {:.1f} ms", status.computing_milliseconds) : "", 9},
      {energy_text(status.energy_error), 7},
      {status.note, 2},
  };
  std::vector<std::size_t> order(fields.size());
  for (const Field& field : fields)
    order[static_cast<std::size_t>(field.rank)] = static_cast<std::size_t>(&field - fields.data());
  std::vector<bool> shown(fields.size(), false);
  const auto room = static_cast<std::size_t>(std::max(0, width));
  std::size_t used = 1;
  for (const std::size_t index : order) {
    const std::size_t size = fields[index].text.size();
    if (size == 0 || used + size > room) continue;
    shown[index] = true;
    used += size + kApart;
  }
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!shown[i]) continue;
    line += std::string(line.empty() ? 1 : kApart, ' ') + fields[i].text;
  }
  return line;
}

}  // namespace carom
