#pragma once

#include <optional>
#include <string_view>

namespace carom {

/// What pictures are made of.
enum class Glyphs {
  ascii,   ///< letters and signs whose ink lies like the balls
  blocks,  ///< half-blocks: two square pixels a cell, each with its colour
  braille  ///< eight dots a cell
};

inline const char* name_of(Glyphs glyphs) {
  return glyphs == Glyphs::ascii ? "ascii" : glyphs == Glyphs::blocks ? "blocks" : "braille";
}

inline std::optional<Glyphs> glyphs_named(std::string_view name) {
  for (const Glyphs glyphs : {Glyphs::ascii, Glyphs::blocks, Glyphs::braille}) {
    if (name == name_of(glyphs)) return glyphs;
  }
  return std::nullopt;
}

}  // namespace carom
