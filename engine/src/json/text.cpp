#include "json/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace carom::json {

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

std::optional<NoText> find_text_problem(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    // Eight bytes at a time, as long as all are ASCII and none is zero.
    std::uint64_t word = 0;
    if (i + sizeof word <= text.size()) {
      std::memcpy(&word, text.data() + i, sizeof word);
      constexpr std::uint64_t kHigh = 0x8080808080808080U;
      constexpr std::uint64_t kOnes = 0x0101010101010101U;
      if (((word | (word - kOnes)) & kHigh) == 0) {
        i += sizeof word;
        continue;
      }
    }
    const std::size_t length = sequence_length(text.substr(i));
    if (length == 0 || text[i] == '\0') {
      return NoText{i,
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

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return fmt::format("\"{}\"", printable(text));
  std::size_t cut = kLongest;
  while (cut > 0 && is_continuation(static_cast<unsigned char>(text[cut]))) --cut;
  return fmt::format("\"{}...\"", printable(text.substr(0, cut)));
}

std::string_view first_character(std::string_view text) {
  return text.substr(0, std::max<std::size_t>(1, sequence_length(text)));
}

}  // namespace carom::json
