#pragma once

#include <string>
#include <vector>

#include "view/canvas.hpp"
#include "view/glyphs.hpp"

namespace carom {

inline constexpr int kFrame = 2;  ///< columns or rows that a frame takes
inline constexpr int kEdge = 1;   ///< of it on one side

/// A small picture of its own, framed, with a title in its upper edge.
///
/// `inside` is what the frame goes around.
Canvas framed(const Canvas& inside, const std::string& title, Glyphs glyphs);

/// Lines of plain text as a picture, as wide as the widest, at most `columns` by `rows`.
Canvas text_block(const std::vector<std::string>& lines, int columns, int rows);

/// 0, or a number with its power of ten.
std::string exponent(double value);

/// Lays a picture over another one, its upper left corner at the cell given.
void lay_over(const Canvas& above, int column, int row, Canvas& canvas);

}  // namespace carom
