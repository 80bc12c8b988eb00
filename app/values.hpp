#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace carom {

/// The value of an option as a number.  Errors: UsageError that quotes the option and the value.
std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t least,
                           std::uint64_t most);

/// A finite number, from 0 or, where `zero` is false, above 0.
double finite_number(const std::string& option, const std::string& text, bool zero);

/// A finite number above 0 of no particular unit.
double positive_number(const std::string& option, const std::string& text);

/// A size in character cells, as in "80x24".
std::pair<int, int> cell_size(const std::string& option, const std::string& text);

}  // namespace carom
