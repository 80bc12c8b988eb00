#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace carom {

/// As in "1 ball" and "2 balls".
inline std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace carom
