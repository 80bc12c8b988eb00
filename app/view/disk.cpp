#include "view/disk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace carom {
namespace {

struct Shape {
  char character;
  std::array<int, 4> quarters;  // of sixteen, as Coverage
};

// Where the ink of a character lies.  The table is closed under mirrors (left-right and up-down),
// so that a mirrored ball gets the mirrored characters; symmetric shapes stand first and win ties.
constexpr Shape kShapes[] = {
    {' ', {0, 0, 0, 0}},    {'8', {16, 16, 16, 16}},                         //
    {'8', {16, 16, 9, 9}},  {'8', {9, 9, 16, 16}},                           //
    {'8', {16, 9, 16, 9}},  {'8', {9, 16, 9, 16}},                           //
    {'o', {9, 9, 9, 9}},    {'"', {12, 12, 2, 2}},   {'o', {2, 2, 12, 12}},  //
    {'\'', {5, 5, 0, 0}},   {'_', {0, 0, 5, 5}},                             //
    {'(', {0, 12, 0, 12}},  {')', {12, 0, 12, 0}},                           //
    {'d', {4, 16, 16, 16}}, {'b', {16, 4, 16, 16}},                          //
    {'q', {16, 16, 4, 16}}, {'P', {16, 16, 16, 4}},                          //
    {'.', {0, 0, 2, 11}},   {'.', {0, 0, 11, 2}},                            //
    {'\'', {2, 11, 0, 0}},  {'\'', {11, 2, 0, 0}},                           //
};

int distance(const std::array<int, 4>& a, const std::array<int, 4>& b) {
  int sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

int whole(double value, int low, int high) {
  return static_cast<int>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
}

}  // namespace

CellRange cells_of(const Ellipse& e, const CellRange& clip) {
  if (!std::isfinite(e.x) || !std::isfinite(e.y)) return {};
  return {whole(std::floor(e.x - e.across), clip.left, clip.right),
          whole(std::floor(e.y - e.down), clip.top, clip.bottom),
          whole(std::ceil(e.x + e.across), clip.left, clip.right),
          whole(std::ceil(e.y + e.down), clip.top, clip.bottom)};
}

void cover(const Ellipse& e, const CellRange& range, std::vector<Coverage>& coverage) {
  constexpr int kSamples = Coverage::kSamples;
  const int columns = std::max(0, range.right - range.left);
  const int rows = std::max(0, range.bottom - range.top);
  coverage.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), {});
  if (columns == 0 || rows == 0) return;
  // Line by line of sample points: those within half the chord of the centre are covered.
  for (int line = 0; line < rows * kSamples; ++line) {
    const double height = (range.top + (line + 0.5) / kSamples - e.y) / e.down;
    const double inside = 1 - height * height;
    if (!(inside >= 0)) continue;
    const double half = e.across * std::sqrt(inside);
    const int limit = columns * kSamples;
    const int first = whole(std::ceil((e.x - half - range.left) * kSamples - 0.5), 0, limit);
    const int last = whole(std::floor((e.x + half - range.left) * kSamples - 0.5) + 1, 0, limit);
    const auto row = static_cast<std::size_t>(line / kSamples);
    const std::size_t lower = line % kSamples >= kSamples / 2 ? 2 : 0;
    constexpr int kHalf = kSamples / 2;
    for (int at = first; at < last;) {
      const int end = std::min(last, (at / kHalf + 1) * kHalf);
      const auto cell =
          row * static_cast<std::size_t>(columns) + static_cast<std::size_t>(at / kSamples);
      coverage[cell].quarters[lower + (at % kSamples >= kHalf ? 1 : 0)] += end - at;
      at = end;
    }
  }
}

char character_for(const Coverage& coverage) {
  const Shape* best = nullptr;
  int nearest = std::numeric_limits<int>::max();
  for (const Shape& shape : kShapes) {
    const int off = distance(shape.quarters, coverage.quarters);
    if (off >= nearest) continue;
    nearest = off;
    best = &shape;
  }
  return best->character;
}

}  // namespace carom
