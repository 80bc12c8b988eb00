#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "json/reader.hpp"

namespace carom::json {

// Numbers and texts as JSON writes them.
// Errors: throws Malformed.
// Source: RFC 8259, sections 6 and 7.

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The number that begins at `at`, which is then behind it; infinite beyond double precision.
/// REQUIRES: a digit or a sign is there.
Number scan_number(std::string_view text, std::size_t& at);

/// What a text between quotes means; `offset`: where it begins, for messages.
std::string unescaped(std::string_view written, std::size_t offset);

/// Tells that the text is no JSON from there on.
[[noreturn]] void malformed(std::size_t offset, std::string message);

}  // namespace carom::json
