#include "accuracy_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "accuracy_table.hpp"
#include "carom/report.hpp"

namespace carom {
namespace {

constexpr double kOwnTarget = 2e-6;  // of the smallest radius, where none is given

bool ran(const AccuracyRow& row) {
  return row.failure.empty();
}

std::string times_text(double factor) {
  return factor >= 10 ? fmt::format("{:.0f}", factor) : fmt::format("{:.2g}", factor);
}

/// The nearest to the truth of a method's runs, on the crew of the first row.
const AccuracyRow* nearest(const AccuracyStudy& study, Method method) {
  const AccuracyRow* best = nullptr;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || row.method != method || !row.position_error) continue;
    if (best == nullptr || *row.position_error < *best->position_error) best = &row;
  }
  return best;
}

/// The run that is right for longest.  REQUIRES: one ran.
const AccuracyRow& longest(const AccuracyStudy& study) {
  const AccuracyRow* best = nullptr;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row)) continue;
    if (best == nullptr || study.right_until(row) > study.right_until(*best)) best = &row;
  }
  return *best;
}

/// The run of a method that is lost last; none where one is not lost at all.
const AccuracyRow* lost_last(const AccuracyStudy& study, Method method) {
  const AccuracyRow* best = nullptr;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || row.method != method) continue;
    if (!row.horizon) return nullptr;
    if (best == nullptr || *row.horizon > *best->horizon) best = &row;
  }
  return best;
}

/// The worst that the runs of a method do to what cannot change.
std::string invariants(const AccuracyStudy& study, Method method) {
  double energy = 0;
  double overlap = 0;
  bool known = false;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || row.method != method) continue;
    if (row.energy_error) {
      energy = std::max(energy, *row.energy_error);
      known = true;
    }
    overlap = std::max(overlap, row.max_overlap);
  }
  return fmt::format("{}: {}overlaps up to {:.1g} of a radius", method_name(method),
                     known ? fmt::format("energy off by up to {:.1e}, ", energy) : "", overlap);
}

std::string by_horizon(const AccuracyStudy& study) {
  std::string text = fmt::format(
      "Chaotic: no run is known to be right until {:.4g} s, so errors at the end say nothing. "
      "Compare the predictability horizons and the conserved quantities.\n",
      study.time);
  const AccuracyRow& best = longest(study);
  text += fmt::format("Right for longest: {}, {:.4g} s, at {} per simulated second. {}; {}.\n",
                      run_name(best), study.right_until(best),
                      duration_text(study.seconds_per_simulated_second(best)),
                      invariants(study, Method::event), invariants(study, Method::overlap));
  return text;
}

std::string by_error(const AccuracyStudy& study, double target,
                     std::optional<std::size_t> cheapest) {
  if (!cheapest) {
    std::string text = fmt::format("No run reaches {:.3g}.", target);
    for (const Method method : {Method::event, Method::overlap}) {
      const AccuracyRow* const row = nearest(study, method);
      if (row == nullptr) continue;
      text += fmt::format(" Nearest with {}: {}, {}.", method_name(method), run_name(*row),
                          error_text(*row->position_error));
    }
    return text + '\n';
  }
  const AccuracyRow& best = study.rows[*cheapest];
  std::string text = fmt::format("For {:.3g}: {}, {} per simulated second", target, run_name(best),
                                 duration_text(study.seconds_per_simulated_second(best)));
  const Method other = best.method == Method::event ? Method::overlap : Method::event;
  const AccuracyRow* rival = nullptr;  // the cheapest of the other method that reaches it too
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || row.method != other || !row.position_error) continue;
    if (*row.position_error > target) continue;
    if (rival == nullptr || row.seconds < rival->seconds) rival = &row;
  }
  if (rival != nullptr) {
    return text + fmt::format("; {} reaches it too, at {} times the cost ({}).\n",
                              method_name(other), times_text(rival->seconds / best.seconds),
                              run_name(*rival));
  }
  rival = nearest(study, other);
  if (rival == nullptr) return text + ".\n";
  const AccuracyRow* const last = lost_last(study, other);
  if (last != nullptr) {
    return text + fmt::format(
                      "; {} is lost whatever the step: at {:.4g} s with {}, which costs {} "
                      "times as much.\n",
                      method_name(other), *last->horizon, run_name(*last),
                      times_text(last->seconds / best.seconds));
  }
  const double factor = rival->seconds / best.seconds;
  const std::string cost = factor >= 1 ? fmt::format("costs {} times as much", times_text(factor))
                                       : fmt::format("costs {:.2g} of that", factor);
  return text + fmt::format("; {} does not reach it: {}its error is {} and it {}.\n",
                            method_name(other),
                            rival->step ? fmt::format("at {} ", step_text(*rival->step)) : "",
                            error_text(*rival->position_error), cost);
}

/// What a thread for each ball costs, beside the same run on the first crew.
std::string crew_text(const AccuracyStudy& study) {
  std::string text;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || !row.per_ball) continue;
    const auto base =
        std::find_if(study.rows.begin(), study.rows.end(), [&](const AccuracyRow& other) {
          return ran(other) && !other.per_ball && other.method == row.method &&
                 other.step == row.step && other.digits == row.digits;
        });
    if (base == study.rows.end() || base->seconds <= 0) continue;
    text +=
        fmt::format("{} {}: {} times the time of {} {}.", text.empty() ? "A thread per ball," : "",
                    run_name(row), times_text(row.seconds / base->seconds), base->workers,
                    base->workers == 1 ? "worker" : "workers");
  }
  return text.empty() ? text : text + '\n';
}

std::string solver_lines(const AccuracyRow& row) {
  std::string text = fmt::format("\"solver\": {{\"method\": \"{}\"", method_name(row.method));
  if (row.step) text += fmt::format(", \"step\": {}", *row.step);
  if (row.method == Method::event) text += fmt::format(", \"digits\": {}", row.digits);
  text += "},\n";
  text += row.per_ball ? "\"workers\": \"per-ball\",\n"
                       : fmt::format("\"workers\": {},\n", row.workers);
  return text;
}

}  // namespace

std::string to_sentences(const AccuracyStudy& study) {
  std::string text;
  if (study.judged_by_horizon()) text += by_horizon(study);
  if (!study.judged_by_horizon() || study.target) {
    const double radius = study.smallest_radius;
    const double own = radius > 0 ? std::pow(10, std::rint(std::log10(kOwnTarget * radius))) : 1;
    const double target = study.target.value_or(own);
    text += by_error(study, target, cheapest_within(study, target));
  }
  text += crew_text(study);
  if (study.target && study.recommended) {
    text += "\nPut into the scene:\n\n" + solver_lines(study.rows[*study.recommended]);
  }
  return text;
}

}  // namespace carom
