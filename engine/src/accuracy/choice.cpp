#include <algorithm>
#include <limits>

#include "carom/accuracy.hpp"

namespace carom {
namespace {

constexpr double kQuiet = 0.9;  // of the time that a quiet machine leaves to a run

/// Less is better.
double badness(const AccuracyStudy& study, const AccuracyRow& row) {
  if (study.reference.equilibrium) return AccuracyStudy::rest_error(row);
  if (study.judged_by_horizon()) return -study.right_until(row);
  return row.position_error.value_or(std::numeric_limits<double>::infinity());
}

/// The middle halves of their repeats overlap.
bool takes_as_long(const AccuracyRow& one, const AccuracyRow& other) {
  return one.quartiles[0] <= other.quartiles[1] && other.quartiles[0] <= one.quartiles[1];
}

/// Of runs that take equally long, within the spread, the one with fewer digits is cheaper.
bool is_cheaper(const AccuracyRow& one, const AccuracyRow& other) {
  if (one.digits != other.digits && takes_as_long(one, other)) return one.digits < other.digits;
  return one.seconds < other.seconds;
}

bool meets(const AccuracyRow& row, double target) {
  if (!row.failure.empty()) return false;
  if (row.rest) return row.rest->rest_time && AccuracyStudy::rest_error(row) <= target;
  return row.position_error && *row.position_error <= target;
}

}  // namespace

bool comes_to_rest(const Scene& scene) {
  return scene.effects.gravity && scene.effects.gravity->acceleration.squaredNorm() > 0 &&
         loses_energy(scene) && !scene.effects.attraction;
}

const char* observable_name(Observable observable) {
  constexpr std::array kNames{"Z", "pressure", "temperature", "collision_rate", "mean_free_path"};
  return kNames.at(static_cast<std::size_t>(observable));
}

double AccuracyStudy::rest_error(const AccuracyRow& row) {
  return row.rest ? std::max(row.rest->equilibrium_residual.median, row.max_overlap) : 0;
}

bool AccuracyStudy::judged_by_horizon() const {
  if (reference.equilibrium || !reference.absent.empty()) return false;
  bool any = false;
  for (const AccuracyRow& row : rows) {
    if (!row.failure.empty()) continue;
    if (!row.horizon && row.position_error) return false;
    any = true;
  }
  return any;
}

double AccuracyStudy::right_until(const AccuracyRow& row) const {
  return row.horizon.value_or(reference.holds_until.value_or(time));
}

double AccuracyStudy::seconds_per_simulated_second(const AccuracyRow& row) const {
  return time > 0 ? row.seconds / time : 0;
}

std::optional<double> AccuracyStudy::processor_share() const {
  double wall = 0;
  double cpu = 0;
  for (const AccuracyRow& row : rows) {
    if (!row.failure.empty()) continue;
    wall += row.seconds;
    cpu += std::min(row.cpu_seconds, row.seconds);
  }
  if (!(wall > 0) || cpu >= kQuiet * wall) return std::nullopt;
  return cpu / wall;
}

std::optional<std::size_t> cheapest_within(const AccuracyStudy& study, double target) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    if (!meets(row, target)) continue;
    if (!best || row.seconds < study.rows[*best].seconds) best = i;
  }
  if (!best) return best;
  const AccuracyRow& cheapest = study.rows[*best];
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    if (!meets(row, target)) continue;
    const bool fewer = row.digits < study.rows[*best].digits;
    if (fewer && takes_as_long(row, cheapest)) best = i;
  }
  // The cheapest with so many digits, though its time may be told apart from that of the cheapest.
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const AccuracyRow& row = study.rows[i];
    const AccuracyRow& known = study.rows[*best];
    if (meets(row, target) && row.digits == known.digits && row.seconds < known.seconds) best = i;
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
      return !is_cheaper(row, other) && other_bad <= bad &&
             (other_bad < bad || is_cheaper(other, row));
    });
  }
  return best;
}

}  // namespace carom
