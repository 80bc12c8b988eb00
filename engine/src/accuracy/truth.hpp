#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "accuracy/places.hpp"
#include "accuracy/runner.hpp"
#include "accuracy/samples.hpp"
#include "carom/accuracy.hpp"

namespace carom::accuracy {

/// Where the balls really are, whenever runs are compared.
struct Truth {
  AccuracyReference reference;
  std::vector<Places> at_sample;            ///< of sample s at s - 1, as far as it is known
  std::map<std::uint64_t, Places> at_fine;  ///< of a fine number, where one was asked for

  /// The last sample of which it is known; where runs are not lost by then, it is the end.
  [[nodiscard]] std::size_t known() const { return at_sample.size(); }
};

/// Told often: the seconds that were spent, and those that the whole work is foreseen to take.
using Told = std::function<void(double spent, double whole)>;

/// Balls farther from the truth than this part of the smallest radius are lost.
inline constexpr double kLost = 0.01;

/// Computes the scene in two precisions side by side.  As long as they part by less than kLost,
/// what the narrow one is wrong by is seen, and what the wide one is wrong by is less by as many
/// powers of ten as it has more digits: it does not show.  Where they part, the truth ends.
///
/// Where method event takes steps, two steps of 2 : 1 take the place of two precisions, halved
/// until rounding keeps the two from coming nearer to each other.
///
/// `allowance`: wall-clock seconds that the two may take; where they take more, fewer digits are
/// tried, or no shorter steps.
/// Errors: NoReference.
Truth find_truth(const Scenario& scenario, const Samples& samples, double smallest_radius,
                 double allowance, const Told& told);

/// Runs the reference again for `truth.at_fine`, whose keys are filled in.
void refine_truth(Truth& truth, const Scenario& scenario, const Samples& samples, const Told& told);

}  // namespace carom::accuracy
