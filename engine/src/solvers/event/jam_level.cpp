#include "solvers/event/jam_level.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/rest_rules.hpp"

namespace carom::event {

void JamLevel::widen() {
  if (times_ == 0) lasts_ = spans_ > 1 ? 1 : std::min(2 * lasts_, kLongestJam);
  spans_ = 0;
  times_ = times_ > 0 ? times_ + 1 : std::clamp(last_times_, 1, kMostDoublings);
  last_times_ = times_;
  if (times_ > kMostJams) {
    throw std::runtime_error(
        "impacts follow each other without end: such contacts are for method \"overlap\"");
  }
}

void JamLevel::end_span() {
  ++spans_;
  times_ = std::min(times_, kMostDoublings);  // it gives up for no longer
  if (times_ > 0 && spans_ >= lasts_) times_ = spans_ = 0;
}

void JamLevel::save(SavedJam& jam) const {
  jam.found = static_cast<unsigned>(times_);
  jam.found_before = static_cast<unsigned>(last_times_);
  jam.lasts = static_cast<unsigned>(lasts_);
  jam.spans = static_cast<unsigned>(std::min(spans_, kLongestJam));
}

void JamLevel::restore(const SavedJam& jam) {
  times_ = static_cast<int>(jam.found);
  last_times_ = static_cast<int>(jam.found_before);
  lasts_ = static_cast<int>(jam.lasts);
  spans_ = static_cast<int>(jam.spans);
}

double JamLevel::gap() const {
  return kTouching * std::ldexp(1.0, std::min(times_ - 1, kMostDoublings));
}

}  // namespace carom::event
