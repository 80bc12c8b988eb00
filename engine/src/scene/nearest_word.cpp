#include <algorithm>
#include <numeric>
#include <vector>

#include "carom/names.hpp"

namespace carom {

namespace {

constexpr std::size_t kLongest = 64;  // of a longer word only the beginning is compared

/// Letters to insert, remove, replace or swap to get from one word to the other.
/// Source: Damerau 1964, in the restricted form with three rows.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before(to.size() + 1);
  std::vector<std::size_t> last(to.size() + 1);
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[to.size()];
}

}  // namespace

std::string_view nearest_word(std::string_view unknown, std::span<const std::string_view> known,
                              std::size_t most) {
  std::string_view nearest;
  auto least = static_cast<std::size_t>(-1);
  for (const std::string_view word : known) {
    const std::size_t distance = edit_distance(unknown.substr(0, kLongest), word);
    if (distance < least) {
      least = distance;
      nearest = word;
    }
  }
  return least <= most ? nearest : std::string_view{};
}

}  // namespace carom
