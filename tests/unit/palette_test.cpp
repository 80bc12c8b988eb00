// The colours of balls stand out from their background: contrasts as the Web Content Accessibility
// Guidelines 2.1 define them (relative luminance of sRGB).
#include "view/palette.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace carom::palette_test {
namespace {

double linear(unsigned value) {
  const double part = value / 255.0;
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}

double luminance(Color rgb) {
  return 0.2126 * linear(rgb >> 16U) + 0.7152 * linear((rgb >> 8U) & 0xFFU) +
         0.0722 * linear(rgb & 0xFFU);
}

double contrast(Color a, Color b) {
  const double one = luminance(a) + 0.05;
  const double other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

/// The colour cube of terminals with 256 colours, as xterm has it.
Color rgb_of(Color color, Colors colors) {
  if (colors == Colors::true_color) return color;
  constexpr std::array<Color, 6> kLevels{0, 95, 135, 175, 215, 255};
  const Color index = color - 16;
  return (kLevels[index / 36] << 16U) | (kLevels[index / 6 % 6] << 8U) | kLevels[index % 6];
}

std::vector<Color> speeds(const Palette& palette) {
  std::vector<Color> result;
  for (int i = 0; i <= 1000; ++i) {
    const Color color = rgb_of(palette.heat(static_cast<float>(i) / 1000), palette.colors());
    if (result.empty() || result.back() != color) result.push_back(color);
  }
  return result;
}

TEST(Palette, BallsHaveAContrastOfThreeToTheirBackground) {
  struct Case {
    Background background;
    std::vector<Color> behind;
  };
  const std::vector<Case> cases{{Background::any, {0x000000, 0x1E1E1E, 0xFFFFFF}},
                                {Background::dark, {0x000000, 0x1E1E1E}},
                                {Background::light, {0xFFFFFF, 0xF5F5F5}}};
  for (const Colors colors : {Colors::many, Colors::true_color}) {
    for (const Case& each : cases) {
      for (const Color color : speeds({colors, each.background})) {
        for (const Color behind : each.behind)
          EXPECT_GE(contrast(color, behind), 3) << std::hex << color << " on " << behind;
      }
    }
  }
}

TEST(Palette, FasterIsLighterAndEachColourIsThereOnce) {
  for (const Colors colors : {Colors::many, Colors::true_color}) {
    for (const Background background : {Background::any, Background::dark, Background::light}) {
      const std::vector<Color> all = speeds({colors, background});
      EXPECT_GE(all.size(), 5U);
      EXPECT_EQ(std::set<Color>(all.begin(), all.end()).size(), all.size());
      for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_GT(luminance(all[i]), luminance(all[i - 1])) << std::hex << all[i];
    }
  }
}

TEST(Palette, TextStandsOutOnBlackAndOnWhite) {
  for (const Colors colors : {Colors::many, Colors::true_color}) {
    const Palette palette(colors, Background::any);
    for (const Ink ink : {Ink::periodic, Ink::computes, Ink::waits}) {
      Cell cell;
      cell.character = U'x';
      cell.ink = ink;
      const Color color = rgb_of(palette.look(cell).fore, colors);
      const double least = colors == Colors::many ? 4.3 : 4.5;  // the cube has none in between
      EXPECT_GE(contrast(color, 0x000000), least) << std::hex << color;
      EXPECT_GE(contrast(color, 0xFFFFFF), least) << std::hex << color;
    }
    for (const Ink ink : {Ink::status, Ink::notice, Ink::wall, Ink::fixed}) {
      Cell cell;
      cell.character = U'x';
      cell.ink = ink;
      EXPECT_EQ(palette.look(cell).fore, kDefaultColor);
    }
  }
}

}  // namespace
}  // namespace carom::palette_test
