#include "values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "options.hpp"

namespace carom {
namespace {

constexpr std::uint64_t kMostCells = 1000;  // of a side of a dumped frame

template <class Number>
std::optional<Number> number(const std::string& text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

}  // namespace

std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t least,
                           std::uint64_t most) {
  const auto value = number<std::uint64_t>(text);
  if (value && *value >= least && *value <= most) return *value;
  const std::string range = most == std::numeric_limits<std::uint64_t>::max()
                                ? fmt::format("from {}", least)
                                : fmt::format("from {} to {}", least, most);
  throw UsageError(fmt::format("{}: must be a whole number {}, got '{}'", option, range, text));
}

double finite_number(const std::string& option, const std::string& text, bool zero) {
  const auto value = number<double>(text);
  if (value && std::isfinite(*value) && (zero ? *value >= 0 : *value > 0)) return *value;
  throw UsageError(fmt::format("{}: must be a number of seconds, {}, got '{}'", option,
                               zero ? "0 or more" : "greater than 0", text));
}

double positive_number(const std::string& option, const std::string& text) {
  const auto value = number<double>(text);
  if (value && std::isfinite(*value) && *value > 0) return *value;
  throw UsageError(fmt::format("{}: must be a number greater than 0, got '{}'", option, text));
}

std::pair<int, int> cell_size(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto columns = number<std::uint64_t>(text.substr(0, cross));
    const auto rows = number<std::uint64_t>(text.substr(cross + 1));
    const auto good = [](const auto& side) { return side && *side >= 1 && *side <= kMostCells; };
    if (good(columns) && good(rows)) return {static_cast<int>(*columns), static_cast<int>(*rows)};
  }
  throw UsageError(
      fmt::format("{}: must be columns x rows, each from 1 to {}, as in 80x24, got '{}'", option,
                  kMostCells, text));
}

}  // namespace carom
