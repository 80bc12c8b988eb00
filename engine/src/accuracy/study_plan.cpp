#include "accuracy/study_plan.hpp"

#include <algorithm>
#include <utility>

#include "accuracy/samples.hpp"

namespace carom::accuracy {

StudyPlan::StudyPlan(const Scenario& scenario, std::vector<AccuracyCrew> crews)
    : crews_(std::move(crews)), unplanned_(2 * (crews_.size() - 1)) {
  if (scenario.start.effects.attraction) {
    add_steps(Method::event);
  } else {
    runs_.push_back({{Method::event, std::nullopt, 16}, crews_.front(), {}});
  }
  for (const int digits : {34, 50}) {
    runs_.push_back({{Method::event, std::nullopt, digits}, crews_.front(), {}});
  }
  add_steps(Method::overlap);
}

void StudyPlan::add_steps(Method method) {
  double step = kLongestStep;
  for (int count = 0; count < kSteps; ++count, step /= 2) {
    runs_.push_back({{method, step, 16}, crews_.front(), {}});
  }
}

double StudyPlan::seconds(std::size_t next, const Forecast& forecast, double limit) const {
  double left = 0;
  for (std::size_t i = next; i < runs_.size(); ++i) {
    const double run = forecast.run(runs_[i].way);
    if (runs_[i].way.step && run > 2 * limit) continue;
    left += runs_[i].same ? forecast.with_repeats(run) - run : forecast.with_repeats(run);
  }
  return left;
}

bool StudyPlan::is_shorter(const Planned& run, std::size_t at) const {
  const Way& way = runs_[at].way;
  return run.way.method == way.method && run.way.step && *run.way.step < *way.step;
}

bool StudyPlan::goes_on_with_shorter_steps(std::size_t at) const {
  if (!runs_[at].way.step) return false;
  return std::any_of(runs_.begin() + static_cast<std::ptrdiff_t>(at) + 1, runs_.end(),
                     [&](const Planned& run) { return is_shorter(run, at); });
}

void StudyPlan::leave_out_shorter_steps(std::size_t at) {
  runs_.erase(std::remove_if(runs_.begin() + static_cast<std::ptrdiff_t>(at) + 1, runs_.end(),
                             [&](const Planned& run) { return is_shorter(run, at); }),
              runs_.end());
}

void StudyPlan::add_other_crews(const std::vector<AccuracyRow>& rows, double step) {
  unplanned_ = 0;
  for (std::size_t crew = 1; crew < crews_.size(); ++crew) {
    for (const Method method : {Method::event, Method::overlap}) {
      std::optional<std::size_t> chosen;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].method != method || !rows[i].failure.empty()) continue;
        const bool too_long = chosen && rows[*chosen].step.value_or(0) > step;
        if (!chosen || too_long) chosen = i;
      }
      if (!chosen) continue;
      const AccuracyRow& row = rows[*chosen];
      runs_.push_back({{row.method, row.step, row.digits}, crews_[crew], chosen});
    }
  }
}

}  // namespace carom::accuracy
