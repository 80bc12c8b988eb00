#pragma once

#include <array>
#include <cstdint>

namespace carom {

/// The bit of the dot in each column and row of a cell, and the character without dots.
/// Source: Unicode, "Braille Patterns".
inline constexpr std::array<std::array<std::uint8_t, 4>, 2> kBrailleDot{
    {{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}}};
inline constexpr char32_t kNoDots = 0x2800;

}  // namespace carom
