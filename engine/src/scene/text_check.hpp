#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "carom/scene_file.hpp"

namespace carom::scene {

/// What keeps a text from being JSON at all: it is empty, or not UTF-8.
std::optional<Problem> find_text_problem(std::string_view text);

/// The place of a byte, as in "line 3, column 5"; both count from 1, columns in characters.
std::string line_and_column(std::string_view text, std::size_t offset);

/// A text with its control characters written out, so that it stays on one line of a terminal.
std::string printable(std::string_view text);

}  // namespace carom::scene
