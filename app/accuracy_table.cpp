#include "accuracy_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/report.hpp"

namespace carom {
namespace {

constexpr double kWholeEnough = 1e-9;
constexpr double kToPercent = 100;

using Line = std::vector<std::string>;

std::string or_lost(const std::optional<double>& error, const char* otherwise) {
  return error ? error_text(*error) : otherwise;
}

/// The range of the middle half of the repeats, as a part of their median.
std::string spread_text(const AccuracyRow& row) {
  if (row.seconds <= 0) return "-";
  return fmt::format("{:.0f} %", (row.quartiles[1] - row.quartiles[0]) / row.seconds * kToPercent);
}

std::string horizon_text(const AccuracyRow& row) {
  if (!row.horizon) return "to the end";
  return fmt::format("{:.4g} s", *row.horizon);
}

std::string figure(const MedianAndSpread& value) {
  return error_text(value.median);
}

/// The figures of a run that should come to rest.
void add_rest(Line& line, const AccuracyRow& row) {
  const AccuracyRest& rest = *row.rest;
  line.push_back(figure(rest.equilibrium_residual));
  line.push_back(error_text(row.max_overlap));
  line.push_back(figure(rest.creep));
  line.push_back(figure(rest.kinetic_energy));
  line.push_back(figure(rest.dissipation_error));
  line.push_back(fmt::format("{}", row.ball_ball));
  line.push_back(fmt::format("{}", row.ball_wall));
  line.push_back(rest.rest_time ? fmt::format("{:.4g} s", rest.rest_time->median) : "never");
}

Line line_of(const AccuracyStudy& study, const AccuracyRow& row, bool best, bool crews) {
  Line line{best ? "*" : "", run_name(row)};
  if (crews) line.push_back(fmt::format("{}{}", row.workers, row.per_ball ? " per-ball" : ""));
  if (!row.failure.empty()) {
    line.push_back(row.failure);
    return line;
  }
  line.push_back(duration_text(study.seconds_per_simulated_second(row)));
  line.push_back(spread_text(row));
  line.push_back(duration_text(study.time > 0 ? row.cpu_seconds / study.time : 0));
  if (row.rest) {
    add_rest(line, row);
    return line;
  }
  line.push_back(or_lost(row.position_error, "lost"));
  line.push_back(or_lost(row.energy_error, "unknown"));
  line.push_back(row.max_overlap == 0 ? "0" : fmt::format("{:.1e}", row.max_overlap));
  line.push_back(fmt::format("{}", row.ball_ball));
  line.push_back(fmt::format("{}", row.ball_wall));
  line.push_back(horizon_text(row));
  return line;
}

std::string reference_text(const AccuracyStudy& study) {
  const AccuracyReference& reference = study.reference;
  if (reference.equilibrium) {
    return fmt::format(
        "reference: static equilibrium, to which losses under gravity lead; medians over {}\n\n",
        !study.drawn        ? "one start, as the scene has no fill"
        : study.starts == 1 ? fmt::format("one start, seed {}", study.seed)
                            : fmt::format("{} starts, seeds {} to {}", study.starts, study.seed,
                                          study.seed + study.starts - 1));
  }
  if (!reference.absent.empty()) {
    return fmt::format("{}; only averages are compared\n", reference.absent);
  }
  std::string text = fmt::format("reference: {} ", method_name(reference.method));
  std::string checked;
  if (reference.step) {
    text += "in steps of " + step_text(*reference.step);
    checked = step_text(reference.checked_step.value_or(0));
  } else {
    text += fmt::format("with {} digits", reference.digits);
    checked = fmt::format("{}", reference.checked_digits);
  }
  if (reference.holds_until) {
    return text + fmt::format("; right until {:.4g} s, where {} part from it\n",
                              *reference.holds_until,
                              reference.step ? "steps of " + checked : checked + " digits");
  }
  if (reference.step) {
    return text + fmt::format("; reference error ({} against {}): {}\n", step_text(*reference.step),
                              checked, error_text(reference.difference));
  }
  return text + fmt::format("; reference error ({} against {} digits): {}\n", reference.digits,
                            checked, error_text(reference.difference));
}

/// The resolution of the horizons that were looked at closely, and of those that steps keep coarse.
std::string resolution_text(const AccuracyStudy& study) {
  double finest = 0;
  double coarsest = 0;
  for (const AccuracyRow& row : study.rows) {
    if (!row.horizon || !row.failure.empty()) continue;
    finest = finest == 0 ? row.horizon_resolution : std::min(finest, row.horizon_resolution);
    coarsest = std::max(coarsest, row.horizon_resolution);
  }
  if (coarsest == 0) return "";
  const std::string range =
      finest == coarsest ? duration_text(finest)
                         : fmt::format("{} to {}", duration_text(finest), duration_text(coarsest));
  return fmt::format(
      "  horizon (predictability horizon): when a ball is first seen more than {:.3g} away from "
      "the "
      "reference; compared every {}\n",
      study.smallest_radius / kToPercent, range);
}

std::vector<Line> headings(bool rest) {
  if (rest) {
    return {{"", "", "time", "", "CPU time", "residual of", "deepest", "creep", "kinetic",
             "unexplained", "impacts", "of", ""},
            {"", "run", "per s", "spread", "per s", "equilibrium", "overlap", "in radii", "energy",
             "energy", "of balls", "walls", "at rest"}};
  }
  return {{"", "", "time", "", "CPU time", "error of", "error of", "deepest", "impacts", "of"},
          {"", "run", "per s", "spread", "per s", "position", "energy", "overlap", "of balls",
           "walls", "horizon"}};
}

}  // namespace

std::string duration_text(double seconds) {
  struct Unit {
    double size;
    const char* name;
  };
  for (const Unit unit : {Unit{1, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "us"}}) {
    if (seconds >= unit.size) return fmt::format("{:.3g} {}", seconds / unit.size, unit.name);
  }
  return seconds == 0 ? "0 s" : fmt::format("{:.3g} ns", seconds / 1e-9);
}

std::string step_text(double step) {
  const double parts = 1 / step;
  if (parts > 1 && std::abs(parts - std::rint(parts)) < kWholeEnough * parts) {
    return fmt::format("1/{:.0f} s", std::rint(parts));
  }
  return fmt::format("{:.4g} s", step);
}

std::string error_text(double error) {
  return error == 0 ? "0" : fmt::format("{:.1e}", error);
}

std::string run_name(const AccuracyRow& row) {
  std::string name = method_name(row.method);
  if (row.method == Method::event && !row.step) name += fmt::format(", {} digits", row.digits);
  if (row.step) name += ", " + step_text(*row.step);
  return name;
}

std::string to_table(const AccuracyStudy& study) {
  const bool crews = std::any_of(study.rows.begin(), study.rows.end(), [&](const AccuracyRow& row) {
    return row.workers != study.rows.front().workers || row.per_ball != study.rows.front().per_ball;
  });
  std::string text = study.scene.empty() ? "a scene without a name" : study.scene;
  text += fmt::format(": {} {}, {:.6g} s simulated", study.balls,
                      study.balls == 1 ? "ball" : "balls", study.time);
  if (!crews && !study.rows.empty()) {
    const AccuracyRow& row = study.rows.front();
    text += fmt::format(", on {} {}{}", row.workers, row.workers == 1 ? "worker" : "workers",
                        row.per_ball ? ", one per ball" : "");
  }
  text += '\n' + reference_text(study);
  if (!study.reference.equilibrium && study.reference.absent.empty()) {
    text += fmt::format("collisions of the reference{}: {} of balls, {} with walls\n\n",
                        study.reference.holds_until ? " until then" : "", study.reference.ball_ball,
                        study.reference.ball_wall);
  }

  std::vector<Line> lines = headings(study.reference.equilibrium);
  if (crews) {
    lines[0].insert(lines[0].begin() + 2, "");
    lines[1].insert(lines[1].begin() + 2, "workers");
  }
  const std::size_t columns = lines[1].size();
  const std::vector<bool> best = best_choices(study);
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    lines.push_back(line_of(study, study.rows[i], best[i], crews));
  }
  std::vector<std::size_t> width(columns);
  for (const Line& line : lines) {
    if (line.size() + 1 < columns) continue;  // a failure is as long as it is
    for (std::size_t c = 0; c < line.size(); ++c) width[c] = std::max(width[c], line[c].size());
  }
  for (const Line& line : lines) width[1] = std::max(width[1], line[1].size());
  for (const Line& line : lines) {
    std::string row;
    const bool failed = line.size() + 1 < columns;
    for (std::size_t c = 0; c < line.size(); ++c) {
      const bool left = c <= 1 || (failed && c + 1 == line.size());
      row += "  " + (left ? fmt::format("{:<{}}", line[c], failed && c > 1 ? 0 : width[c])
                          : fmt::format("{:>{}}", line[c], width[c]));
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row.substr(1) + '\n';
  }
  text += "\n  * on the Pareto front: no other run is both cheaper and better\n" +
          resolution_text(study);
  if (!study.sequence_end.empty()) {
    text += "  the sequence of steps ends early: " + study.sequence_end + '\n';
  }
  if (const std::optional<double> share = study.processor_share()) {
    text += fmt::format(
        "  busy machine: the runs got {:.0f} % of the processor; compare the CPU times\n",
        *share * kToPercent);
  }
  return text;
}

}  // namespace carom
