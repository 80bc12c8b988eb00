#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace carom::sweeps {

/// A value of the scene that a sweep changes, and what it takes in turn.
struct Axis {
  std::string pointer;              ///< JSON pointer, as in "/effects/drag/rate"
  std::vector<std::string> values;  ///< each as --set takes it

  bool operator==(const Axis&) const = default;
};

/// Reads "/POINTER=SPEC": FROM:TO:COUNT numbers, FIRST..LAST whole numbers, or A,B,C values.
/// Errors: UsageError that quotes the option.
Axis parse_axis(const std::string& text);

/// How many points the product of the axes has.
std::size_t count_points(const std::vector<Axis>& axes);

/// The value of each axis at a point; the last axis changes fastest.
std::vector<std::string> values_of(const std::vector<Axis>& axes, std::size_t point);

}  // namespace carom::sweeps
