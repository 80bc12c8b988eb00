#include "scene/text_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace carom::scene {

namespace {

constexpr bool is_continuation(unsigned char byte) {
  return (byte & 0xC0U) == 0x80U;
}

/// Bytes of the well-formed UTF-8 sequence that starts here; 0 if there is none.
/// Source: The Unicode Standard, table 3-7.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
  };
  const unsigned char first = byte(0);
  const unsigned char second = byte(1);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4 || !is_continuation(second)) return 0;
  if (first < 0xE0) return 2;
  if (!is_continuation(byte(2))) return 0;
  if (first < 0xF0) {
    const bool overlong = first == 0xE0 && second < 0xA0;
    const bool surrogate = first == 0xED && second > 0x9F;
    return overlong || surrogate ? 0 : 3;
  }
  const bool overlong = first == 0xF0 && second < 0x90;
  const bool beyond = first == 0xF4 && second > 0x8F;
  return overlong || beyond || !is_continuation(byte(3)) ? 0 : 4;
}

}  // namespace

std::optional<Problem> find_text_problem(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Problem{
        "", R"(is empty: a scene is a JSON object, as in {"box": {"width": 20, "height": 10}})"};
  }
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text.substr(i));
    if (length == 0 || text[i] == '\0') {
      return Problem{line_and_column(text, i),
                     fmt::format("is not text in UTF-8: found the byte 0x{:02X}, save it as UTF-8",
                                 static_cast<unsigned char>(text[i]))};
    }
    i += length;
  }
  return std::nullopt;
}

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last = before.rfind('\n');
  const std::string_view row = before.substr(last == std::string_view::npos ? 0 : last + 1);
  const auto column =
      std::count_if(row.begin(), row.end(),
                    [](char c) { return !is_continuation(static_cast<unsigned char>(c)); }) +
      1;
  return fmt::format("line {}, column {}", line, column);
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (byte < 0x20 || byte == 0x7F) {
      shown += fmt::format("\\u{:04X}", byte);
    } else if (byte == 0xC2 && is_continuation(next) && next < 0xA0) {
      shown += fmt::format("\\u{:04X}", next);
      ++i;
    } else {
      shown += text[i];
    }
  }
  return shown;
}

}  // namespace carom::scene
