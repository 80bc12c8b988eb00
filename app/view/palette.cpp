#include "view/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace carom {
namespace {

constexpr Color kTrueAny[] = {0x834BCB, 0x5063DF, 0x027ABE, 0x00869F,
                              0x029089, 0x099A67, 0x5D9E0C, 0xA0970C};
constexpr Color kTrueDark[] = {0x854ECE, 0x5A6FED, 0x0990DE, 0x10A8C5,
                               0x00BFB6, 0x02D891, 0x9AE658, 0xF9EB24};
constexpr Color kTrueLight[] = {0x520791, 0x2D33AD, 0x035586, 0x086679,
                                0x0E7771, 0x09885B, 0x57950C, 0x998F0B};
constexpr Color kManyAny[] = {62, 30, 64, 100, 136};
constexpr Color kManyDark[] = {98, 32, 37, 43, 113, 220};
constexpr Color kManyLight[] = {54, 25, 30, 64, 100, 136};
// Terminals of sixteen colours have chosen readable ones: bright blue, cyan, green, yellow.
constexpr Color kSixteen[] = {12, 6, 2, 3};

std::span<const Color> speeds(Colors colors, Background background) {
  const bool dark = background == Background::dark;
  const bool light = background == Background::light;
  if (colors == Colors::sixteen) return kSixteen;
  if (colors == Colors::many) {
    if (dark) return kManyDark;
    if (light) return kManyLight;
    return kManyAny;
  }
  if (dark) return kTrueDark;
  if (light) return kTrueLight;
  return kTrueAny;
}

/// Text and sides that are not the terminal's own colour: 4.5 to 1 on black and on white.
Color teal(Colors colors) {
  if (colors == Colors::true_color) return 0x008282;
  return colors == Colors::many ? 30 : 6;
}
Color orange(Colors colors) {
  if (colors == Colors::true_color) return 0xB85C00;
  return colors == Colors::many ? 130 : 3;
}

void add_color(Color color, Colors colors, bool back, std::string& codes) {
  if (!codes.empty()) codes += ';';
  const int base = back ? 40 : 30;
  if (color == kDefaultColor) {
    codes += fmt::format("{}", base + 9);
  } else if (colors == Colors::true_color) {
    codes +=
        fmt::format("{};2;{};{};{}", base + 8, color >> 16U, (color >> 8U) & 0xFFU, color & 0xFFU);
  } else if (color < 8) {
    codes += fmt::format("{}", base + static_cast<int>(color));
  } else if (colors == Colors::sixteen) {
    codes += fmt::format("{}", base + 60 + static_cast<int>(color) - 8);
  } else {
    codes += fmt::format("{};5;{}", base + 8, color);
  }
}

}  // namespace

std::optional<Background> background_named(std::string_view name) {
  if (name == "any") return Background::any;
  if (name == "dark") return Background::dark;
  if (name == "light") return Background::light;
  return std::nullopt;
}

Color Palette::heat(float heat) const {
  const auto colors = speeds(colors_, background_);
  const auto level =
      static_cast<std::size_t>(std::max(0.F, heat) * static_cast<float>(colors.size()));
  return colors[std::min(level, colors.size() - 1)];
}

Color Palette::ink_color(Ink ink, float heat) const {
  switch (ink) {
    case Ink::ball:
    case Ink::trail:
      return this->heat(heat);
    case Ink::periodic:
    case Ink::computes:
      return teal(colors_);
    case Ink::waits:
      return orange(colors_);
    default:
      return kDefaultColor;
  }
}

Look Palette::look(const Cell& cell) const {
  Look look;
  const bool blank = cell.character == U' ';
  if (!blank) {
    look.bold = cell.ink == Ink::notice || cell.ink == Ink::fixed;
    look.dim = cell.ink == Ink::open || cell.ink == Ink::ghost || cell.ink == Ink::trail;
  }
  look.reverse = cell.ink == Ink::chosen;
  if (colors_ == Colors::none) return look;
  if (!blank) look.fore = ink_color(cell.ink, cell.heat);
  if (cell.back != Ink::none) look.back = ink_color(cell.back, cell.back_heat);
  return look;
}

void Palette::change(const Look& from, const Look& to, std::string& bytes) const {
  if (from == to) return;
  if (to == Look{}) {
    bytes += "\x1B[m";
    return;
  }
  Look now = from;
  std::string codes;
  if ((from.bold && !to.bold) || (from.dim && !to.dim) || (from.reverse && !to.reverse)) {
    codes += '0';
    now = {};
  }
  const auto add = [&codes](const char* code) {
    if (!codes.empty()) codes += ';';
    codes += code;
  };
  if (to.bold && !now.bold) add("1");
  if (to.dim && !now.dim) add("2");
  if (to.reverse && !now.reverse) add("7");
  if (to.fore != now.fore) add_color(to.fore, colors_, false, codes);
  if (to.back != now.back) add_color(to.back, colors_, true, codes);
  bytes += "\x1B[" + codes + 'm';
}

}  // namespace carom
