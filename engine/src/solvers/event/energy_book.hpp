#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "numbers/exact_sum.hpp"

namespace carom::event {

/// What impacts and drag have taken from the energy of an event loop's balls.
///
/// Holds: sums are rounded once, so that the order of impacts of one instant does not show.
class EnergyBook {
 public:
  /// Of the impact that is being worked out; impacts never give energy.
  void note(double lost) {
    if (lost > 0) noted_ += lost;
  }
  /// The same where a step of contacts may give back what an earlier one took too much.
  void correct(double lost) { noted_ += lost; }
  /// The impact stays; gives what it took.
  double keep() {
    if (noted_ != 0) {
      sum_.add(noted_);
      kept_.push_back(noted_);
    }
    return std::exchange(noted_, 0);
  }
  void forget() { noted_ = 0; }
  /// From here on what is kept can be taken back.
  void begin_simultaneous() { kept_.clear(); }
  /// How often something was kept since then.
  [[nodiscard]] std::size_t kept() const { return kept_.size(); }
  /// Takes back what was kept from number `first` on, up to `last`.
  void take_back(std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) sum_.add(-std::exchange(kept_[k], 0));
  }
  /// Of a flight that has ended; a part of it that was counted too much is taken off.
  void add_drag(double lost) {
    if (lost != 0) sum_.add(lost);
  }
  /// Exact: terms of which it is the sum.
  [[nodiscard]] const std::vector<double>& parts() const { return sum_.parts(); }

 private:
  double noted_ = 0;
  std::vector<double> kept_;  ///< at the present instant
  ExactSum<double> sum_;
};

}  // namespace carom::event
