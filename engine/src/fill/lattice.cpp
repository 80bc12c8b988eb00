#include "fill/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scene {

namespace {

/// Columns and rows of a hexagonal lattice with their distances.
struct Rows {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double across = 0;   // from column to column
  double up = 0;       // from row to row
  double margin = 0;   // from the lower side to the first row
  double spacing = 0;  // least distance of two sites
};

Rows hexagonal_rows(const Region& region, std::size_t count, std::size_t columns) {
  const Vec2 size = region.upper - region.lower;
  Rows best;
  best.columns = columns;
  best.rows = (count + columns - 1) / columns;
  if (region.around[1] && best.rows % 2 != 0 && count > 1) ++best.rows;
  const auto n = static_cast<double>(columns);
  const bool shifted = best.rows > 1;
  best.across = size.x() / (region.around[0] || !shifted ? n : n + 0.5);
  const double half = best.across / 2;
  const auto gaps = static_cast<double>(best.rows - 1);
  if (region.around[1]) {
    best.up = size.y() / static_cast<double>(best.rows);
    best.margin = best.up / 2;
  } else if (!shifted) {
    best.margin = size.y() / 2;
    best.up = size.y();
  } else {
    // The margin is half the spacing, which is the least of three distances: to the next site of
    // the row, to the next row, and to the row after that.  2 margin + gaps * up = height has one
    // solution for each; the least margin belongs to the largest of them.
    const double h = size.y();
    const double by_row = (h - best.across) / gaps;
    const double by_next =
        (h * h - half * half) / (h * gaps + std::sqrt(h * h + (gaps * gaps - 1) * half * half));
    best.up = std::max(by_row, by_next);
    if (best.rows > 2) best.up = std::max(best.up, h / (gaps + 2));
    best.margin = (h - gaps * best.up) / 2;
  }
  best.spacing = best.across;
  if (shifted) {
    best.spacing = std::min(best.spacing, std::sqrt(half * half + best.up * best.up));
    if (best.rows > 2 || region.around[1]) best.spacing = std::min(best.spacing, 2 * best.up);
  } else {
    best.spacing = std::min(best.spacing, size.y());
  }
  return best;
}

}  // namespace

Lattice square_lattice(const Region& region, std::size_t count) {
  const Vec2 size = region.upper - region.lower;
  std::size_t columns = 1;
  double spacing = 0;
  for (std::size_t c = 1; c <= count; ++c) {
    const std::size_t rows = (count + c - 1) / c;
    const double least =
        std::min(size.x() / static_cast<double>(c), size.y() / static_cast<double>(rows));
    if (least > spacing) {
      spacing = least;
      columns = c;
    }
  }
  const std::size_t rows = (count + columns - 1) / columns;
  Lattice lattice;
  lattice.spacing = spacing;
  lattice.sites.reserve(columns * rows);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(columns);
      const double y = (static_cast<double>(j) + 0.5) / static_cast<double>(rows);
      lattice.sites.emplace_back(region.lower.x() + x * size.x(), region.lower.y() + y * size.y());
    }
  }
  return lattice;
}

Lattice hexagonal_lattice(const Region& region, std::size_t count) {
  Rows best;
  for (std::size_t columns = 1; columns <= count; ++columns) {
    const Rows rows = hexagonal_rows(region, count, columns);
    if (rows.spacing > best.spacing) best = rows;
  }
  Lattice lattice;
  lattice.spacing = best.spacing;
  lattice.sites.reserve(best.columns * best.rows);
  for (std::size_t j = 0; j < best.rows; ++j) {
    // All around, both kinds of row keep a quarter of the spacing from the ends.
    double first = best.across / 2;
    if (region.around[0]) first = best.rows > 1 ? best.across / 4 : best.across / 2;
    if (j % 2 != 0) first += best.across / 2;
    const double y = region.lower.y() + (best.margin + static_cast<double>(j) * best.up);
    for (std::size_t i = 0; i < best.columns; ++i) {
      const double x = first + static_cast<double>(i) * best.across;
      lattice.sites.emplace_back(region.lower.x() + x, y);
    }
  }
  return lattice;
}

}  // namespace carom::scene
