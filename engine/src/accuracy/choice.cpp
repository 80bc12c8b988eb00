#include <algorithm>
#include <limits>

#include "carom/accuracy.hpp"

namespace carom {
namespace {

/// Less is better.
double badness(const AccuracyStudy& study, const AccuracyRow& row) {
  if (study.judged_by_horizon()) return -*row.horizon;
  return row.position_error.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

bool AccuracyStudy::judged_by_horizon() const {
  bool any = false;
  for (const AccuracyRow& row : rows) {
    if (!row.failure.empty()) continue;
    if (!row.horizon) return false;
    any = true;
  }
  return any;
}

double AccuracyStudy::seconds_per_simulated_second(const AccuracyRow& row) const {
  return time > 0 ? row.seconds / time : 0;
}

std::optional<std::size_t> cheapest_within(const AccuracyStudy& study, double target) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    if (!row.failure.empty() || !row.position_error || *row.position_error > target) continue;
    if (!best || row.seconds < study.rows[*best].seconds) best = i;
  }
  return best;
}

std::vector<bool> best_choices(const AccuracyStudy& study) {
  std::vector<bool> best(study.rows.size());
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    if (!row.failure.empty()) continue;
    const double bad = badness(study, row);
    best[i] = std::none_of(study.rows.begin(), study.rows.end(), [&](const AccuracyRow& other) {
      if (!other.failure.empty()) return false;
      const double other_bad = badness(study, other);
      return other.seconds <= row.seconds && other_bad <= bad &&
             (other.seconds < row.seconds || other_bad < bad);
    });
  }
  return best;
}

}  // namespace carom
