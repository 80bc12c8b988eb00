#include "accuracy_averages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "accuracy_table.hpp"
#include "carom/report.hpp"

namespace carom {
namespace {

constexpr double kWanted = 0.01;  // of the reference's mean
constexpr double kPercent = 100;

std::string mean_text(const std::optional<MeanAndError>& mean) {
  if (!mean) return "-";
  if (!mean->standard_error) return fmt::format("{:.5g}", mean->mean);
  return fmt::format("{:.5g} +- {:.1g}", mean->mean, *mean->standard_error);
}

const MeanAndError* average_of(const AccuracyRow& row, std::size_t observable) {
  if (!row.failure.empty() || observable >= row.averages.size()) return nullptr;
  const auto& mean = row.averages[observable];
  return mean ? &*mean : nullptr;
}

/// The cheapest run of a method whose mean is near that of the reference.
const AccuracyRow* cheapest(const AccuracyStudy& study, std::size_t observable, Method method) {
  const AccuracyRow* best = nullptr;
  const double right = study.averages[observable]->mean;
  for (const AccuracyRow& row : study.rows) {
    const MeanAndError* const mean = average_of(row, observable);
    if (mean == nullptr || row.method != method) continue;
    if (std::abs(mean->mean - right) > kWanted * std::abs(right)) continue;
    if (best == nullptr || row.seconds < best->seconds) best = &row;
  }
  return best;
}

std::string cost_of(const AccuracyStudy& study, std::size_t observable, Method method) {
  const AccuracyRow* const row = cheapest(study, observable, method);
  if (row == nullptr) return fmt::format("{} does not reach it", method_name(method));
  const std::string name = row->step
                               ? fmt::format("{} at {}", method_name(method), step_text(*row->step))
                               : std::string(method_name(method));
  return fmt::format("{}, {} per simulated second", name,
                     duration_text(study.seconds_per_simulated_second(*row)));
}

/// The largest standard error of a difference from the reference, in parts of its mean.
double uncertainty(const AccuracyStudy& study, std::size_t observable) {
  const MeanAndError& right = *study.averages[observable];
  double largest = 0;
  for (const AccuracyRow& row : study.rows) {
    const MeanAndError* const mean = average_of(row, observable);
    if (mean == nullptr) continue;
    const double error =
        std::hypot(mean->standard_error.value_or(0), right.standard_error.value_or(0));
    largest = std::max(largest, error / std::abs(right.mean));
  }
  return largest;
}

}  // namespace

std::string to_average_table(const AccuracyStudy& study) {
  if (study.observables.empty() || study.averages.empty()) return "";
  std::string text = fmt::format(
      "\naverages after the first fifth of the time, over {} {}; reference: method event with {} "
      "digits\n\n",
      study.starts, study.starts == 1 ? "start" : "starts", study.average_digits);
  std::vector<std::vector<std::string>> lines{{"run", "time per s"}};
  for (const Observable each : study.observables) {
    lines[0].push_back(observable_name(each));
    lines[0].emplace_back("off by");
  }
  std::vector<std::string> reference{"reference", ""};
  for (const auto& mean : study.averages) {
    reference.push_back(mean_text(mean));
    reference.emplace_back("");
  }
  lines.push_back(reference);
  for (const AccuracyRow& row : study.rows) {
    if (!row.failure.empty()) continue;
    std::vector<std::string> line{run_name(row),
                                  duration_text(study.seconds_per_simulated_second(row))};
    for (std::size_t i = 0; i < study.observables.size(); ++i) {
      const MeanAndError* const mean = average_of(row, i);
      line.push_back(mean == nullptr ? "-" : mean_text(*mean));
      const auto& right = study.averages[i];
      line.push_back(
          mean == nullptr || !right || right->mean == 0
              ? "-"
              : fmt::format("{:+.2g} %", (mean->mean - right->mean) / right->mean * kPercent));
    }
    lines.push_back(line);
  }
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t c = 0; c < line.size(); ++c) {
      std::size_t width = 0;
      for (const auto& each : lines) width = std::max(width, each[c].size());
      row += "  " + (c == 0 ? fmt::format("{:<{}}", line[c], width)
                            : fmt::format("{:>{}}", line[c], width));
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + '\n';
  }
  return text;
}

std::string to_average_sentences(const AccuracyStudy& study) {
  std::string text;
  for (std::size_t i = 0; i < study.averages.size(); ++i) {
    if (!study.averages[i] || study.averages[i]->mean == 0) continue;
    text += fmt::format("For {} to 1 %: {}; {}.", observable_name(study.observables[i]),
                        cost_of(study, i, Method::overlap), cost_of(study, i, Method::event));
    const double unknown = uncertainty(study, i);
    if (unknown > kWanted) {
      text += fmt::format(
          " The standard errors reach {:.1g} %: more --seeds or a longer --time would tell better.",
          unknown * kPercent);
    }
    text += '\n';
  }
  return text;
}

}  // namespace carom
