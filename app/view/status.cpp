#include "view/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace carom {
namespace {

/// One thing the line says, from the wordiest way to the shortest; empty: not at all.
struct Field {
  std::array<std::string, 3> forms;
  std::size_t form = 0;
};

std::string joined(const std::vector<Field>& fields) {
  std::string line;
  for (const Field& field : fields) {
    const std::string& text = field.forms[field.form];
    if (text.empty()) continue;
    line += (line.empty() ? " " : "  ") + text;
  }
  return line;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string error_text(double error, int digits) {
  return error == 0 ? "0" : fmt::format("{:.{}e}", error, digits);
}

std::string pace_text(const Status& status) {
  if (status.paused) return "paused";
  if (status.pace) return fmt::format("{:.2g}x of real time", *status.pace);
  return speed_text(status.speed);
}

}  // namespace

std::string speed_text(double speed) {
  return speed >= 1 ? fmt::format("{:g}x", speed) : fmt::format("1/{:g}x", 1 / speed);
}

std::string status_line(const Status& status, int width) {
  const std::string pace = pace_text(status);
  const std::string short_pace =
      status.pace && !status.paused ? fmt::format("{:.2g}x", *status.pace) : pace;
  const std::string short_name = status.scene.substr(0, 8);
  std::vector<Field> fields = {
      {{status.scene, short_name, ""}},
      {{counted(status.balls, "ball", "balls"), fmt::format("{}b", status.balls), ""}},
      {{counted(status.workers, "worker", "workers"), fmt::format("{}w", status.workers), ""}},
      {{fmt::format("{:.2f} s", status.time), fmt::format("{:.1f}s", status.time), ""}},
      {{pace, short_pace, ""}},
      {{fmt::format("{:.1f} fps", status.frames_per_second),
        fmt::format("{:.0f} fps", status.frames_per_second), ""}},
      {{fmt::format("{} late", status.late), fmt::format("{} late", status.late), ""}},
      {{fmt::format("{:.2f} ms", status.computing_milliseconds),
        fmt::format("{:.1f} ms", status.computing_milliseconds), ""}},
      {{"energy error " + error_text(status.energy_error, 1),
        "energy " + error_text(status.energy_error, 0), ""}},
      {{status.note, status.note, ""}},
  };
  // What gives way first, again and again until the line fits: first every field one form shorter,
  // then whole fields, the least important first.
  constexpr std::array<std::size_t, 10> kGiveWay = {8, 6, 7, 2, 5, 9, 1, 0, 4, 3};
  for (std::size_t form = 1; form < 3; ++form) {
    for (const std::size_t field : kGiveWay) {
      if (joined(fields).size() <= static_cast<std::size_t>(std::max(0, width))) break;
      fields[field].form = form;
    }
  }
  std::string line = joined(fields);
  return line.substr(0, static_cast<std::size_t>(std::max(0, width)));
}

}  // namespace carom
