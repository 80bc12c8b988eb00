#include "view/dots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "view/braille.hpp"

namespace carom {
namespace {

constexpr int kAcross = 2;
constexpr int kDown = 4;
constexpr unsigned kUpper = 0x1B;       // the dots of the upper half
constexpr double kLongestLine = 16384;  // dots: a longer line, far beyond the picture, is left out

char32_t sign_of(std::uint8_t dots, Glyphs glyphs) {
  if (glyphs != Glyphs::ascii) return kNoDots + dots;
  const bool upper = (dots & kUpper) != 0;
  const bool lower = (dots & ~kUpper) != 0;
  return upper && lower ? U':' : upper ? U'\'' : U'.';
}

}  // namespace

Dots::Dots(const Canvas& canvas, const CellRange& clip, Glyphs glyphs)
    : columns_(canvas.columns), clip_(clip), glyphs_(glyphs), spots_(canvas.cells.size()) {}

void Dots::line(const Vec2& from, const Vec2& to, float heat) {
  const double length =
      std::max(std::abs(to.x() - from.x()) * kAcross, std::abs(to.y() - from.y()) * kDown);
  if (!(length < kLongestLine)) return;
  const int steps = std::max(1, static_cast<int>(std::ceil(length)));
  for (int k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    dot(from.x() + part * (to.x() - from.x()), from.y() + part * (to.y() - from.y()), heat);
  }
}

void Dots::dot(double x, double y, float heat) {
  if (!(x >= clip_.left && x < clip_.right && y >= clip_.top && y < clip_.bottom)) return;
  const auto column = static_cast<int>(x);
  const auto row = static_cast<int>(y);
  Spot& spot = spots_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)];
  const auto i = static_cast<std::size_t>((x - column) * kAcross);
  const auto j = static_cast<std::size_t>((y - row) * kDown);
  spot.dots = static_cast<std::uint8_t>(spot.dots | kBrailleDot[i][j]);
  spot.heat = std::max(spot.heat, heat);
}

void Dots::lay_under(Ink ink, Canvas& canvas) const {
  for (std::size_t cell = 0; cell < spots_.size(); ++cell) {
    const Spot& spot = spots_[cell];
    if (spot.dots != 0 && canvas.cells[cell].character == U' ')
      canvas.cells[cell] = {sign_of(spot.dots, glyphs_), ink, spot.heat, Ink::none, 0};
  }
}

}  // namespace carom
