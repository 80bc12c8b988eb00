#include "sweep/axis.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "options.hpp"

namespace carom::sweeps {
namespace {

constexpr std::size_t kMostPoints = 1000000;  // six digits name a point

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw UsageError(fmt::format("--over {}: {}", text, why));
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<std::string> evenly(const std::string& text, const std::vector<std::string>& parts) {
  const auto from = number<double>(parts[0]);
  const auto to = number<double>(parts[1]);
  const auto count = number<std::uint64_t>(parts[2]);
  if (!from || !to || !std::isfinite(*from) || !std::isfinite(*to)) {
    refuse(text, "FROM:TO:COUNT needs two numbers, as in 0.8:1:5");
  }
  if (!count || *count == 0) refuse(text, "COUNT must be a whole number from 1");
  if (*count > kMostPoints) refuse(text, fmt::format("COUNT must be at most {}", kMostPoints));
  std::vector<std::string> values;
  for (std::uint64_t k = 0; k < *count; ++k) {
    const double part = *count == 1 ? 0 : static_cast<double>(k) / static_cast<double>(*count - 1);
    const bool last = k > 0 && k + 1 == *count;
    // Fifteen digits: as people write it, where rounding has not gone farther.
    values.push_back(last ? fmt::format("{}", *to)
                          : fmt::format("{:.15g}", *from + (*to - *from) * part));
  }
  return values;
}

std::vector<std::string> one_by_one(const std::string& text, const std::string& spec) {
  const std::size_t dots = spec.find("..");
  const auto first = number<std::int64_t>(std::string_view(spec).substr(0, dots));
  const auto last = number<std::int64_t>(std::string_view(spec).substr(dots + 2));
  if (!first || !last) refuse(text, "FIRST..LAST needs two whole numbers, as in 1..64");
  if (*last < *first) refuse(text, "the range is empty: LAST is less than FIRST");
  if (*last - *first >= static_cast<std::int64_t>(kMostPoints)) {
    refuse(text, fmt::format("a range has at most {} values", kMostPoints));
  }
  std::vector<std::string> values;
  for (std::int64_t k = *first; k <= *last; ++k) values.push_back(fmt::format("{}", k));
  return values;
}

}  // namespace

Axis parse_axis(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (!text.starts_with('/') || equals == std::string::npos) {
    refuse(text, "must be /POINTER=VALUES, as in /effects/drag/rate=0:1:5");
  }
  Axis axis{text.substr(0, equals), {}};
  const std::string spec = text.substr(equals + 1);
  if (spec.empty()) refuse(text, "has no values");
  const std::vector<std::string> parts = split(spec, ':');
  if (parts.size() == 3 && spec.find_first_of("\"{[") == std::string::npos) {
    axis.values = evenly(text, parts);
  } else if (spec.find("..") != std::string::npos && spec.find('"') == std::string::npos) {
    axis.values = one_by_one(text, spec);
  } else {
    axis.values = split(spec, ',');
    for (const std::string& value : axis.values) {
      if (value.empty()) refuse(text, "a value is missing beside a comma");
    }
  }
  return axis;
}

std::size_t count_points(const std::vector<Axis>& axes) {
  std::size_t points = 1;
  for (const Axis& axis : axes) {
    points *= axis.values.size();
    if (points > kMostPoints) {
      throw UsageError(fmt::format("--over: a sweep has at most {} points", kMostPoints));
    }
  }
  return points;
}

std::vector<std::string> values_of(const std::vector<Axis>& axes, std::size_t point) {
  std::vector<std::string> values(axes.size());
  for (std::size_t k = axes.size(); k-- > 0;) {
    values[k] = axes[k].values[point % axes[k].values.size()];
    point /= axes[k].values.size();
  }
  return values;
}

}  // namespace carom::sweeps
