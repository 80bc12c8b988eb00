#include "accuracy_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

/// The run that is right for longest.
/// REQUIRES: one ran.
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

constexpr double kRestTarget = 1e-3;  // of residual and overlap, where none is given

/// The run of a method that comes nearest to an equilibrium.
const AccuracyRow* best_at_rest(const AccuracyStudy& study, Method method) {
  const AccuracyRow* best = nullptr;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || row.method != method) continue;
    if (best == nullptr || AccuracyStudy::rest_error(row) < AccuracyStudy::rest_error(*best)) {
      best = &row;
    }
  }
  return best;
}

/// What a method has to say: the cheapest of its runs that ends well, or how near it comes.
std::string ends_of(const AccuracyStudy& study, Method method, double target) {
  const AccuracyRow* cheapest = nullptr;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row) || row.method != method || !row.rest->rest_time) continue;
    if (AccuracyStudy::rest_error(row) > target) continue;
    if (cheapest == nullptr || row.seconds < cheapest->seconds) cheapest = &row;
  }
  if (cheapest != nullptr) {
    const std::string cost = duration_text(study.seconds_per_simulated_second(*cheapest));
    return cheapest->step ? fmt::format("{} needs {} for that, {} per simulated second",
                                        method_name(method), step_text(*cheapest->step), cost)
                          : fmt::format("{}, {} per simulated second", method_name(method), cost);
  }
  const AccuracyRow* const best = best_at_rest(study, method);
  if (best == nullptr) return fmt::format("{} did not run", method_name(method));
  return fmt::format(
      "{} does not get there: with {} the residual is {}, the overlap {}{}", method_name(method),
      run_name(*best), error_text(best->rest->equilibrium_residual.median),
      error_text(best->max_overlap), best->rest->rest_time ? "" : ", and the balls still move");
}

/// Where all starts end at one height, what it tends to with the step.
std::string height_text(const AccuracyStudy& study) {
  constexpr double kUnique = 1e-6;                  // of the smallest radius
  if (study.drawn && study.starts == 1) return "";  // other starts may end elsewhere
  std::vector<const AccuracyRow*> steps;
  for (const AccuracyRow& row : study.rows) {
    if (!ran(row)) continue;
    if (row.method == Method::event &&
        (!row.rest->rest_time || row.rest->height.spread > kUnique * study.smallest_radius)) {
      return "";
    }
    if (row.step && row.rest->rest_time) steps.push_back(&row);
  }
  if (steps.size() < 2) return "";
  const AccuracyRow& coarse = *steps[steps.size() - 2];
  const AccuracyRow& fine = *steps.back();
  const double limit = 2 * fine.rest->height.median - coarse.rest->height.median;
  std::string text = fmt::format(
      "Height of the centre of mass: {:.6g} with {}, {:.6g} with {}; extrapolated to no step, as "
      "errors of first order go (Richardson): {:.6g}",
      coarse.rest->height.median, run_name(coarse), fine.rest->height.median, run_name(fine),
      limit);
  const AccuracyRow* const event = best_at_rest(study, Method::event);
  if (event != nullptr) text += fmt::format("; event: {:.6g}", event->rest->height.median);
  return text + ".\n";
}

std::string by_rest(const AccuracyStudy& study) {
  const double target = study.target.value_or(kRestTarget);
  const bool any = std::any_of(study.rows.begin(), study.rows.end(), [](const AccuracyRow& row) {
    return ran(row) && row.rest->rest_time;
  });
  if (!any) {
    return fmt::format("No run comes to rest within {:.4g} s; --time gives it longer.\n",
                       study.time);
  }
  return fmt::format("At rest and in equilibrium, residual and overlap below {:.3g}: {}; {}.\n",
                     target, ends_of(study, Method::event, target),
                     ends_of(study, Method::overlap, target)) +
         height_text(study);
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
  if (!study.reference.absent.empty()) return crew_text(study);
  if (study.reference.equilibrium) {
    text += by_rest(study);
  } else if (study.judged_by_horizon()) {
    text += by_horizon(study);
  }
  if (!study.reference.equilibrium && (!study.judged_by_horizon() || study.target)) {
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
