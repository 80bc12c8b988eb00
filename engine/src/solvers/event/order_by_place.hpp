#pragma once

#include "numbers/scalar.hpp"

namespace carom::event {

/// An order that no numbering of the balls changes.
template <class S>
bool precedes_by_place(const Vec<S>& one, const Vec<S>& other) {
  return one.x < other.x || (one.x == other.x && one.y < other.y);
}

}  // namespace carom::event
