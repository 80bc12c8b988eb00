#pragma once

#include <cstddef>

namespace carom {

/// The number of a body, block or place, which may be less than 0 for none, as what indexes
/// vectors.
inline std::size_t index(int number) {
  return static_cast<std::size_t>(number);
}

}  // namespace carom
