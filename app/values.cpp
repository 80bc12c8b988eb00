#include "values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "carom/names.hpp"

namespace carom {
namespace {

constexpr std::uint64_t kMostCells = 1000;  // of a side of a dumped frame

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

std::string one_of(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  return fmt::format("{} or {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

Rule word(std::vector<std::string> words, std::function<void(Options&, std::size_t)> take) {
  Rule rule;
  rule.words = std::move(words);
  rule.demand = [list = rule.words](const std::string& value) -> std::string {
    const bool known = std::find(list.begin(), list.end(), value) != list.end();
    return known ? "" : "must be " + one_of(list);
  };
  rule.take = [list = rule.words, take = std::move(take)](Options& options,
                                                          const std::string& value) {
    take(options,
         static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin()));
  };
  return rule;
}

template <class Member>
Rule whole(Member member, std::uint64_t least, std::uint64_t most) {
  Rule rule;
  rule.demand = [=](const std::string& value) -> std::string {
    const auto given = number<std::uint64_t>(value);
    if (given && *given >= least && *given <= most) return "";
    return most == kAnyWholeNumber
               ? fmt::format("must be a whole number from {}", least)
               : fmt::format("must be a whole number from {} to {}", least, most);
  };
  rule.take = [=](Options& options, const std::string& value) {
    options.*member = *number<std::uint64_t>(value);
  };
  return rule;
}

template <class Member>
Rule real(Member member, bool zero, std::string demand) {
  Rule rule;
  rule.demand = [zero, demand = std::move(demand)](const std::string& value) -> std::string {
    const auto given = number<double>(value);
    const bool good = given && std::isfinite(*given) && (zero ? *given >= 0 : *given > 0);
    return good ? "" : demand;
  };
  rule.take = [=](Options& options, const std::string& value) {
    options.*member = *number<double>(value);
  };
  return rule;
}

template <class Member>
Rule real_seconds(Member member, bool zero) {
  return real(
      member, zero,
      fmt::format("must be a number of seconds, {}", zero ? "0 or more" : "greater than 0"));
}

std::string workers_demand(const std::string& value) {
  const auto given = number<std::uint64_t>(value);
  if (value == kPerBall || (given && *given >= 1)) return "";
  return fmt::format("must be {} or a whole number from 1", kPerBall);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::optional<std::pair<int, int>> cells(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto columns = number<std::uint64_t>(std::string_view(text).substr(0, cross));
  const auto rows = number<std::uint64_t>(std::string_view(text).substr(cross + 1));
  const auto good = [](const auto& side) { return side && *side >= 1 && *side <= kMostCells; };
  if (!good(columns) || !good(rows)) return std::nullopt;
  return std::pair{static_cast<int>(*columns), static_cast<int>(*rows)};
}

}  // namespace

Rule flag(bool Options::*member) {
  Rule rule;
  rule.flag = member;
  return rule;
}

Rule text(std::string Options::*member) {
  Rule rule;
  rule.demand = [](const std::string&) { return std::string(); };
  rule.take = [=](Options& options, const std::string& value) { options.*member = value; };
  return rule;
}

Rule texts(std::vector<std::string> Options::*member) {
  Rule rule;
  rule.repeats = true;
  rule.demand = [](const std::string&) { return std::string(); };
  rule.take = [=](Options& options, const std::string& value) {
    (options.*member).push_back(value);
  };
  return rule;
}

Rule choice(std::string Options::*member, std::vector<std::string> words) {
  const std::vector<std::string> list = words;
  return word(std::move(words),
              [=](Options& options, std::size_t i) { options.*member = list[i]; });
}

Rule choices(std::vector<std::string> Options::*member, std::vector<std::string> words) {
  const std::vector<std::string> list = words;
  Rule rule = word(std::move(words),
                   [=](Options& options, std::size_t i) { (options.*member).push_back(list[i]); });
  rule.repeats = true;
  return rule;
}

Rule whole_number(std::uint64_t Options::*member, std::uint64_t least, std::uint64_t most) {
  return whole(member, least, most);
}

Rule whole_number(std::optional<std::uint64_t> Options::*member, std::uint64_t least,
                  std::uint64_t most) {
  return whole(member, least, most);
}

Rule positive(std::optional<double> Options::*member) {
  return real(member, false, "must be a number greater than 0");
}

Rule seconds(std::optional<double> Options::*member, bool zero) {
  return real_seconds(member, zero);
}

Rule seconds(double Options::*member, bool zero) {
  return real_seconds(member, zero);
}

Rule method() {
  std::vector<std::string> names;
  for (const auto& name : kMethodNames) names.emplace_back(name.word);
  return word(std::move(names),
              [](Options& options, std::size_t i) { options.method = kMethodNames[i].value; });
}

Rule digits() {
  std::vector<std::string> numbers;
  numbers.reserve(std::size(kDigits));
  for (const int number : kDigits) numbers.push_back(fmt::format("{}", number));
  return word(std::move(numbers),
              [](Options& options, std::size_t i) { options.digits = kDigits[i]; });
}

Rule workers() {
  Rule rule;
  rule.demand = workers_demand;
  rule.take = [](Options& options, const std::string& value) { options.workers = value; };
  return rule;
}

Rule list_of_workers() {
  Rule rule;
  rule.demand = [](const std::string& value) -> std::string {
    for (const std::string& part : split(value, ',')) {
      if (!workers_demand(part).empty()) {
        return fmt::format("must be {} or whole numbers from 1, separated by commas", kPerBall);
      }
    }
    return "";
  };
  rule.take = [](Options& options, const std::string& value) {
    options.crews = split(value, ',');
    options.workers = options.crews.front();
  };
  return rule;
}

Rule cell_size() {
  Rule rule;
  rule.demand = [](const std::string& value) -> std::string {
    if (cells(value)) return "";
    return fmt::format("must be columns x rows, each from 1 to {}, as in 80x24", kMostCells);
  };
  rule.take = [](Options& options, const std::string& value) {
    std::tie(options.columns, options.rows) = *cells(value);
  };
  return rule;
}

Rule picture(std::string Options::*member) {
  Rule rule = text(member);
  rule.demand = [](const std::string& value) -> std::string {
    return value.ends_with(".svg") || value.ends_with(".png") ? "" : "must end in .svg or .png";
  };
  return rule;
}

Rule changes() {
  Rule rule = texts(&Options::set);
  rule.demand = [](const std::string& value) -> std::string {
    const bool good = value.starts_with('/') && value.find('=') != std::string::npos;
    return good ? "" : "must be /POINTER=VALUE, as in /effects/drag/rate=0.1";
  };
  return rule;
}

}  // namespace carom
