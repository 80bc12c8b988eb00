#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace carom::json {

/// Where and why a text is none in UTF-8, or has a zero byte; nothing: it is one.
struct NoText {
  std::size_t offset = 0;
  std::string message;
};
std::optional<NoText> find_text_problem(std::string_view text);

/// The place of a byte, as in "line 3, column 5"; both count from 1, columns in characters.
std::string line_and_column(std::string_view text, std::size_t offset);

/// A text with its control characters written out, so that it stays on one line of a terminal.
std::string printable(std::string_view text);

/// A text in quotes on one line, cut where it is long.
std::string in_quotes(std::string_view text);

/// The bytes of its first character.
/// REQUIRES: UTF-8 that is not empty.
std::string_view first_character(std::string_view text);

}  // namespace carom::json
