#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

namespace carom::test {

/// Which seeds a test takes: [first, last].  The environment variable CAROM_SEEDS, as in 17 or
/// 1..300, replaces them.
inline std::pair<std::uint64_t, std::uint64_t> seeds(std::uint64_t first, std::uint64_t last) {
  const char* const text = std::getenv("CAROM_SEEDS");
  if (text == nullptr) return {first, last};
  const std::string range = text;
  const std::size_t dots = range.find("..");
  if (dots == std::string::npos) return {std::stoull(range), std::stoull(range)};
  return {std::stoull(range.substr(0, dots)), std::stoull(range.substr(dots + 2))};
}

}  // namespace carom::test
