#include "export/accuracy_csv.hpp"

#include <fmt/format.h>

#include "carom/report.hpp"
#include "text/csv_cell.hpp"

namespace carom {
namespace {

std::string or_empty(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
}

std::string measured(const AccuracyStudy& study, const AccuracyRow& row) {
  if (!row.failure.empty()) return ",,,,,,,,,,,";
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", row.seconds, row.fastest, row.slowest,
                     row.cpu_seconds, row.repeats, study.seconds_per_simulated_second(row),
                     or_empty(row.position_error), or_empty(row.energy_error), row.max_overlap,
                     row.ball_ball, row.ball_wall, or_empty(row.horizon));
}

constexpr const char* kRestNames =
    ",starts,equilibrium_residual,equilibrium_residual_spread,creep,creep_spread,kinetic_energy,"
    "kinetic_energy_spread,rest_time,rest_time_spread,dissipation_error,dissipation_error_spread";

std::string rest_fields(const AccuracyStudy& study, const AccuracyRow& row) {
  std::string text = fmt::format(",{}", study.starts);
  if (!row.rest) return text + ",,,,,,,,,,";
  const AccuracyRest& rest = *row.rest;
  for (const std::optional<MedianAndSpread>& each :
       {std::optional(rest.equilibrium_residual), std::optional(rest.creep),
        std::optional(rest.kinetic_energy), rest.rest_time,
        std::optional(rest.dissipation_error)}) {
    text += each ? fmt::format(",{},{}", each->median, each->spread) : ",,";
  }
  return text;
}

std::string average_names(const AccuracyStudy& study) {
  std::string text;
  for (const Observable each : study.observables) {
    text += fmt::format(",{0},{0}_standard_error,{0}_difference", observable_name(each));
  }
  return text;
}

std::string average_fields(const AccuracyStudy& study, const AccuracyRow& row) {
  std::string text;
  for (std::size_t i = 0; i < study.observables.size(); ++i) {
    const bool known = i < row.averages.size() && row.averages[i];
    if (!known) {
      text += ",,,";
      continue;
    }
    const MeanAndError& mean = *row.averages[i];
    text += fmt::format(",{},{},", mean.mean, or_empty(mean.standard_error));
    if (study.averages[i]) text += fmt::format("{}", mean.mean - study.averages[i]->mean);
  }
  return text;
}

}  // namespace

std::string to_csv(const AccuracyStudy& study) {
  const AccuracyReference& reference = study.reference;
  std::string text =
      "method,step,digits,workers,per_ball,seconds,seconds_fastest,seconds_slowest,cpu_seconds,"
      "repeats,"
      "seconds_per_simulated_second,position_error,energy_error,max_overlap,ball_ball,ball_wall,"
      "horizon,horizon_resolution,failed,scene,time,seed,reference_digits,true_ball_ball,"
      "true_ball_wall,version,compiler,processor,cores,system";
  if (reference.equilibrium) text += kRestNames;
  text += average_names(study) + '\n';
  for (const AccuracyRow& row : study.rows) {
    const bool lost = row.failure.empty() && row.horizon;
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", method_name(row.method),
        or_empty(row.step), row.digits, row.workers, row.per_ball, measured(study, row),
        lost ? fmt::format("{}", row.horizon_resolution) : "", csv_cell(row.failure),
        csv_cell(study.scene), study.time, study.seed, reference.digits, reference.ball_ball,
        reference.ball_wall, version(), csv_cell(study.machine.compiler),
        csv_cell(study.machine.processor), study.machine.cores, csv_cell(study.machine.system));
    if (reference.equilibrium) text += rest_fields(study, row);
    text += average_fields(study, row) + '\n';
  }
  return text;
}

}  // namespace carom
