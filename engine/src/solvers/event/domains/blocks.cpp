#include "solvers/event/domains/blocks.hpp"

namespace carom::event {

std::vector<BlockRange> cut(const Blocks& blocks, std::size_t wanted) {
  const double width = blocks.side(0) * blocks.count(0);
  const double height = blocks.side(1) * blocks.count(1);
  const double across = std::sqrt(static_cast<double>(wanted) * width / height);
  const int columns = std::clamp(static_cast<int>(std::lround(across)), 1,
                                 std::min(blocks.count(0), static_cast<int>(wanted)));
  const int rows = std::clamp(static_cast<int>((wanted + static_cast<std::size_t>(columns) - 1) /
                                               static_cast<std::size_t>(columns)),
                              1, blocks.count(1));
  const auto at = [](int count, int k, int parts) {
    return static_cast<int>(static_cast<std::int64_t>(count) * k / parts);
  };
  std::vector<BlockRange> ranges;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      BlockRange range;
      range.first = {at(blocks.count(0), x, columns), at(blocks.count(1), y, rows)};
      range.size = {at(blocks.count(0), x + 1, columns) - range.first[0],
                    at(blocks.count(1), y + 1, rows) - range.first[1]};
      ranges.push_back(range);
    }
  }
  return ranges;
}

}  // namespace carom::event
