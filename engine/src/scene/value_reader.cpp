#include "scene/value_reader.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "json/text.hpp"

namespace carom::scene {

using json::Kind;

namespace {

constexpr double kLargestExact = 0x1p53;  // whole numbers written as 2e2 are taken up to here

/// As JSON writes numbers, with at most as many digits as any scalar has, and no absurd exponent.
bool is_decimal(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return text.size() <= kLongest && error == std::errc() && stop == end && std::isfinite(value);
}

std::string one_of(std::span<const std::string_view> words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view join = i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    list += fmt::format("{}\"{}\"", join, words[i]);
  }
  return "must be " + list;
}

}  // namespace

std::vector<Finding> ValueReader::take_findings() {
  for (json::Complaint& complaint : in_.complaints()) {
    findings_.push_back(
        {complaint.offset, {std::move(complaint.pointer), std::move(complaint.message)}});
  }
  return std::move(findings_);
}

std::vector<Finding> ValueReader::take_complaints() {
  findings_.clear();
  return take_findings();
}

void ValueReader::find(std::size_t offset, std::string place, std::string message) {
  findings_.push_back({offset, {std::move(place), std::move(message)}});
}

void ValueReader::wrong(std::string_view demand) {
  const std::size_t offset = in_.offset();
  if (in_.peek() == Kind::not_finite) return in_.not_finite();  // that is a complaint
  std::string place = in_.pointer();
  std::string got = in_.describe_and_skip();
  if (got == "no number") return;
  find(offset, std::move(place), fmt::format("{}, got {}", demand, got));
}

void ValueReader::read(double& number) {
  if (in_.peek() == Kind::number) {
    number = in_.number().value;
  } else {
    number = kUnknown;
    wrong("must be a number");
  }
}

void ValueReader::read(bool& flag) {
  if (in_.peek() == Kind::flag) {
    flag = in_.flag();
  } else {
    wrong("must be true or false");
  }
}

void ValueReader::read(char& glyph) {
  const std::size_t offset = in_.offset();
  constexpr std::string_view kDemand =
      "must be one printable ASCII character in quotes, as in \"8\"";
  if (in_.peek() != Kind::text) return wrong(kDemand);
  std::string place = in_.pointer();
  const std::string text = in_.text();
  if (text.size() == 1 && text[0] > ' ' && text[0] <= '~') {
    glyph = text[0];
  } else {
    find(offset, std::move(place), fmt::format("{}, got {}", kDemand, json::in_quotes(text)));
  }
}

std::optional<std::uint64_t> ValueReader::whole(std::string_view demand) {
  const std::size_t offset = in_.offset();
  if (in_.peek() != Kind::number) {
    wrong(demand);
    return std::nullopt;
  }
  const json::Number number = in_.number();
  if (number.is_whole && !number.is_negative) return number.magnitude;
  if (!number.is_whole && number.value >= 0 && number.value <= kLargestExact &&
      std::trunc(number.value) == number.value) {
    return static_cast<std::uint64_t>(number.value);
  }
  if (std::isnan(number.value)) return std::nullopt;  // that is a complaint
  find(offset, in_.pointer(),
       number.is_whole
           ? fmt::format("{}, got {}{}", demand, number.is_negative ? "-" : "", number.magnitude)
           : fmt::format("{}, got {}", demand, number.value));
  return std::nullopt;
}

template <class ReadItem>
bool ValueReader::read_two(std::string_view demand, ReadItem&& read_item) {
  if (in_.peek() != Kind::list) {
    wrong(demand);
    return false;
  }
  const std::size_t offset = in_.offset();
  const std::size_t before = findings_.size();
  std::size_t count = 0;
  in_.begin_list();
  for (; in_.next_item(); ++count) {
    if (count < 2) {
      read_item(count);
    } else {
      in_.skip();
    }
  }
  if (count == 2) return true;
  findings_.resize(before);  // one fault is told once
  find(offset, in_.pointer(),
       fmt::format("{}, got {}", demand, count == 0 ? "an empty list" : "a list"));
  return false;
}

void ValueReader::read(Vec2& pair) {
  const bool two =
      read_two("must be two numbers, [x, y]", [&](std::size_t axis) { read(pair[axis]); });
  if (!two) pair = {kUnknown, kUnknown};
}

void ValueReader::read(std::array<Vec2, 2>& corners) {
  const bool two = read_two("must be two corners, [[left, bottom], [right, top]]",
                            [&](std::size_t corner) { read(corners[corner]); });
  if (!two) corners = {Vec2{kUnknown, kUnknown}, Vec2{kUnknown, kUnknown}};
}

void ValueReader::read(std::array<bool, 2>& axes) {
  if (in_.peek() != Kind::list) return wrong(R"(must be a list of "x" and "y", as in ["x"])");
  axes = {false, false};
  in_.begin_list();
  while (in_.next_item()) {
    constexpr std::string_view kDemand = R"(must be "x" or "y")";
    const std::size_t offset = in_.offset();
    if (in_.peek() != Kind::text) {
      wrong(kDemand);
      continue;
    }
    const std::string axis = in_.text();
    if (axis != "x" && axis != "y") {
      find(offset, in_.pointer(), fmt::format("{}, got {}", kDemand, json::in_quotes(axis)));
    } else if (bool& is_periodic = axes[axis == "x" ? 0 : 1]; is_periodic) {
      find(offset, in_.pointer(), fmt::format("names \"{}\" a second time", axis));
    } else {
      is_periodic = true;
    }
  }
}

std::optional<std::size_t> ValueReader::read_word(std::span<const std::string_view> words) {
  const std::size_t offset = in_.offset();
  if (in_.peek() != Kind::text) {
    wrong(one_of(words));
    return std::nullopt;
  }
  const std::string word = in_.text();
  const auto at = std::find(words.begin(), words.end(), word);
  if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
  find(offset, in_.pointer(), fmt::format("{}, got {}", one_of(words), json::in_quotes(word)));
  return std::nullopt;
}

bool ValueReader::read_text(std::string& text) {
  if (in_.peek() != Kind::text) {
    wrong("must be a text in quotes");
    return false;
  }
  text = in_.text();
  return true;
}

void ValueReader::read_line(std::string& line) {
  const std::size_t offset = in_.offset();
  if (!read_text(line) || json::printable(line) == line) return;
  find(offset, in_.pointer(),
       fmt::format("must be one line of text without control characters, got {}",
                   json::in_quotes(line)));
}

void ValueReader::read_decimal(std::string& decimal) {
  constexpr std::string_view kDemand = "must be a decimal number in quotes";
  const std::size_t offset = in_.offset();
  if (in_.peek() != Kind::text) return wrong(kDemand);
  decimal = in_.text();
  if (is_decimal(decimal)) return;
  find(offset, in_.pointer(), fmt::format("{}, got {}", kDemand, json::in_quotes(decimal)));
}

void ValueReader::read_decimal(std::array<std::string, 2>& pair) {
  read_two(R"(must be two decimal numbers in quotes, ["x", "y"])",
           [&](std::size_t axis) { read_decimal(pair[axis]); });
}

void ValueReader::read_workers(Scene& scene) {
  constexpr std::string_view kDemand = "must be \"per-ball\" or a whole number from 1 on";
  scene.per_ball = in_.peek() == Kind::text;
  if (!scene.per_ball) {
    scene.workers = whole(kDemand);
    return;
  }
  const std::size_t offset = in_.offset();
  const std::string word = in_.text();
  if (word == kPerBall) return;
  find(offset, in_.pointer(), fmt::format("{}, got {}", kDemand, json::in_quotes(word)));
}

}  // namespace carom::scene
