#include "view/pixels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "view/ball_images.hpp"
#include "view/braille.hpp"

namespace carom {
namespace {

/// Pixels of a cell.
struct Grain {
  int across;
  int down;
};
constexpr Grain kHalfBlocks{1, 2};
constexpr Grain kBraille{2, 4};

/// Whose a pixel is: of balls that overlap on screen, the one whose middle is nearer.
struct Pixel {
  const FrameBall* ball = nullptr;
  float nearness = std::numeric_limits<float>::infinity();
};

class Raster {
 public:
  Raster(const Frame& frame, const Camera& camera, Grain grain, const Canvas& canvas)
      : grain_(grain),
        columns_(canvas.columns * grain.across),
        pixels_(canvas.cells.size() * static_cast<std::size_t>(grain.across * grain.down)) {
    const CellRange cells = visible_cells(frame, camera, canvas);
    clip_ = {cells.left * grain.across, cells.top * grain.down, cells.right * grain.across,
             cells.bottom * grain.down};
    for (const FrameBall& ball : frame.balls) {
      each_image(frame, camera, ball, [&](const Ellipse& e) {
        fill(ball,
             {e.x * grain.across, e.y * grain.down, e.across * grain.across, e.down * grain.down});
      });
    }
  }

  [[nodiscard]] const FrameBall* at(int column, int row) const {
    return pixels_[index(column, row)].ball;
  }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  void fill(const FrameBall& ball, const Ellipse& disk) {
    const CellRange range = cells_of(disk, clip_);
    if (range.right <= range.left || range.bottom <= range.top) return;
    bool seen = false;
    for (int row = range.top; row < range.bottom; ++row) {
      const double height = (row + 0.5 - disk.y) / disk.down;
      const double inside = 1 - height * height;
      if (!(inside >= 0)) continue;
      const double half = disk.across * std::sqrt(inside);
      const double first =
          std::max(std::ceil(disk.x - half - 0.5), static_cast<double>(range.left));
      const double last =
          std::min(std::floor(disk.x + half - 0.5), static_cast<double>(range.right - 1));
      for (double column = first; column <= last; ++column) {
        const double way = (column + 0.5 - disk.x) / disk.across;
        claim(ball, static_cast<int>(column), row, way * way + height * height);
        seen = true;
      }
    }
    if (seen) return;
    // Too small to have the middle of a pixel: the one that it is in.
    const int column = static_cast<int>(std::floor(disk.x));
    const int row = static_cast<int>(std::floor(disk.y));
    if (column >= clip_.left && column < clip_.right && row >= clip_.top && row < clip_.bottom)
      claim(ball, column, row, 0);
  }

  void claim(const FrameBall& ball, int column, int row, double nearness) {
    if (ball.fixed && hatched(column, row)) return;
    Pixel& pixel = pixels_[index(column, row)];
    if (static_cast<float>(nearness) < pixel.nearness)
      pixel = {&ball, static_cast<float>(nearness)};
  }

  /// The pixels that a fixed ball leaves out.
  [[nodiscard]] bool hatched(int column, int row) const {
    return grain_.across > 1 && (column + row) % 2 != 0;
  }

  Grain grain_;
  int columns_;
  CellRange clip_;
  std::vector<Pixel> pixels_;
};

Ink ink_of(const FrameBall& ball) {
  return ball.fixed ? Ink::fixed : Ink::ball;
}

Cell half_blocks(const FrameBall* upper, const FrameBall* lower, double typical) {
  const FrameBall* const fore = upper != nullptr ? upper : lower;
  Cell cell{U'▄', ink_of(*fore), heat_of(*fore, typical), Ink::none, 0};
  if (upper == nullptr) return cell;
  cell.character = U'▀';
  if (lower == nullptr) return cell;
  if (upper->fixed && lower->fixed) {
    cell.character = U'▒';
  } else if (upper == lower) {
    cell.character = U'█';
  } else {
    cell.back = ink_of(*lower);
    cell.back_heat = heat_of(*lower, typical);
  }
  return cell;
}

void paint_blocks(const Raster& raster, double typical, Canvas& canvas) {
  for (int row = 0; row < canvas.rows; ++row) {
    for (int column = 0; column < canvas.columns; ++column) {
      const FrameBall* const upper = raster.at(column, 2 * row);
      const FrameBall* const lower = raster.at(column, 2 * row + 1);
      if (upper != nullptr || lower != nullptr)
        canvas.at(column, row) = half_blocks(upper, lower, typical);
    }
  }
}

/// The dots of one cell.
Cell braille(const Raster& raster, int column, int row, double typical) {
  unsigned dots = 0;
  std::array<const FrameBall*, 8> owners{};
  std::size_t count = 0;
  for (int i = 0; i < kBraille.across; ++i) {
    for (int j = 0; j < kBraille.down; ++j) {
      const FrameBall* const ball =
          raster.at(kBraille.across * column + i, kBraille.down * row + j);
      if (ball == nullptr) continue;
      dots |= kBrailleDot[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      owners[count++] = ball;
    }
  }
  if (dots == 0) return {};
  const auto last = owners.begin() + static_cast<std::ptrdiff_t>(count);
  const FrameBall* const most =
      *std::max_element(owners.begin(), last, [&](const FrameBall* a, const FrameBall* b) {
        return std::count(owners.begin(), last, a) < std::count(owners.begin(), last, b);
      });
  return {kNoDots + dots, ink_of(*most), heat_of(*most, typical), Ink::none, 0};
}

void paint_braille(const Raster& raster, double typical, Canvas& canvas) {
  for (int row = 0; row < canvas.rows; ++row) {
    for (int column = 0; column < canvas.columns; ++column) {
      const Cell cell = braille(raster, column, row, typical);
      if (cell.character != U' ') canvas.at(column, row) = cell;
    }
  }
}

}  // namespace

void paint_pixels(const Frame& frame, const Camera& camera, Glyphs glyphs, Canvas& canvas) {
  const double typical = typical_speed(frame.balls);
  if (glyphs == Glyphs::blocks) {
    paint_blocks(Raster(frame, camera, kHalfBlocks, canvas), typical, canvas);
  } else {
    paint_braille(Raster(frame, camera, kBraille, canvas), typical, canvas);
  }
}

}  // namespace carom
