#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "view/canvas.hpp"

namespace carom {

/// How many colours a terminal shows.
enum class Colors { none, sixteen, many, true_color };

/// What the terminal's background is: the colours of balls are chosen to stand out from it.
enum class Background { any, dark, light };

std::optional<Background> background_named(std::string_view name);

/// A colour, as a terminal of the palette's depth is told it: an index, or 0xRRGGBB.
using Color = std::uint32_t;
inline constexpr Color kDefaultColor = 0xFFFFFFFF;

/// How a cell looks.
struct Look {
  Color fore = kDefaultColor;
  Color back = kDefaultColor;
  bool bold = false;
  bool dim = false;
  bool reverse = false;

  bool operator==(const Look&) const = default;
};

/// The look of each cell.  Speeds run from violet over blue and green to yellow, ordered in
/// lightness, each with a contrast of at least 3 to 1 to its background; `any` holds that on black,
/// dark grey and white at once.
///
/// Source: the hues of viridis (Smith and van der Walt, 2015), at lightnesses computed in OKLab.
class Palette {
 public:
  Palette(Colors colors, Background background) : colors_(colors), background_(background) {}

  [[nodiscard]] Look look(const Cell& cell) const;
  [[nodiscard]] Color heat(float heat) const;  ///< the colour of a ball
  [[nodiscard]] Colors colors() const { return colors_; }

  /// Adds to `bytes` the escape sequence from one look to another; nothing where they are the same.
  void change(const Look& from, const Look& to, std::string& bytes) const;

 private:
  [[nodiscard]] Color ink_color(Ink ink, float heat) const;

  Colors colors_;
  Background background_;
};

}  // namespace carom
