#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "option_table.hpp"

namespace carom {

// The rules that options have for their values; the member of Options is where the value goes.

inline constexpr std::uint64_t kAnyWholeNumber = std::numeric_limits<std::uint64_t>::max();

Rule flag(bool Options::*member);
Rule text(std::string Options::*member);
/// A text each time that the option is given.
Rule texts(std::vector<std::string> Options::*member);
/// One of some words.
Rule choice(std::string Options::*member, std::vector<std::string> words);
/// One of some words, each time that the option is given.
Rule choices(std::vector<std::string> Options::*member, std::vector<std::string> words);

Rule whole_number(std::uint64_t Options::*member, std::uint64_t least,
                  std::uint64_t most = kAnyWholeNumber);
Rule whole_number(std::optional<std::uint64_t> Options::*member, std::uint64_t least,
                  std::uint64_t most = kAnyWholeNumber);
/// A finite number greater than 0.
Rule positive(std::optional<double> Options::*member);
/// A finite number of seconds, from 0 or, where `zero` is false, greater than 0.
Rule seconds(std::optional<double> Options::*member, bool zero);
Rule seconds(double Options::*member, bool zero);

Rule method();
Rule digits();
Rule workers();
/// Several of `workers`, separated by commas; the first is `workers` too.
Rule list_of_workers();
/// A size in character cells, as in "80x24".
Rule cell_size();
/// A file that gnuplot can draw.
Rule picture(std::string Options::*member);
/// "/POINTER=VALUE", each time that the option is given.
Rule changes();

}  // namespace carom
