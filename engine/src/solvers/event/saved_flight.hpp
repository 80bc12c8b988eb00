#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <type_traits>

#include "carom/scene.hpp"

namespace carom::event {

/// A decimal number that is read back to the same bits.
template <class T>
std::string text_of(const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return fmt::format("{}", value);
  } else {
    return value.text();
  }
}

/// REQUIRES: a decimal number; what is beyond a whole number's range is its nearest end.
template <class T>
T number_of(const std::string& text) {
  if constexpr (std::is_arithmetic_v<T>) {
    const char* const end = text.data() + text.size();
    T value = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stop == end) return value;
    double rounded = 0;
    std::from_chars(text.data(), end, rounded);
    return static_cast<T>(std::clamp(rounded, -0x1p62, 0x1p62));
  } else {
    return T(text);
  }
}

/// `spin`: null where balls have none.
template <class P>
SavedFlight saved(const typename P::Disk& disk, const typename P::Scalar* spin) {
  SavedFlight flight;
  flight.start = text_of(disk.start);
  flight.position = {text_of(disk.x), text_of(disk.y)};
  flight.velocity = {text_of(disk.vx), text_of(disk.vy)};
  if (spin != nullptr) flight.spin = text_of(*spin);
  return flight;
}

template <class P>
typename P::Disk restored(const SavedFlight& flight) {
  using S = typename P::Scalar;
  typename P::Disk disk;
  disk.start = number_of<typename P::Time>(flight.start);
  disk.x = number_of<S>(flight.position[0]);
  disk.y = number_of<S>(flight.position[1]);
  disk.vx = number_of<S>(flight.velocity[0]);
  disk.vy = number_of<S>(flight.velocity[1]);
  return disk;
}

}  // namespace carom::event
