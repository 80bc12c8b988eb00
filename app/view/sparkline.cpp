#include "view/sparkline.hpp"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr char32_t kAsciiCurve[] = {U'_', U'.', U'-', U'=', U'+', U'*', U'#', U'@'};
constexpr char32_t kBlockCurve[] = {U'▁', U'▂', U'▃', U'▄', U'▅', U'▆', U'▇', U'█'};
constexpr int kCurveLevels = 8;
constexpr double kLevelWithin = 1e-12;  // values that differ by no more are level

}  // namespace

Canvas sparkline(const std::vector<double>& values, int columns, Glyphs glyphs) {
  Canvas line(columns, 1);
  if (values.empty() || line.columns == 0) return line;
  // The mean of the values that share a column; a few values share columns the other way.
  std::vector<double> means;
  const std::size_t count = std::min(values.size(), static_cast<std::size_t>(columns));
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k * values.size() / count;
    const std::size_t end = (k + 1) * values.size() / count;
    double sum = 0;
    for (std::size_t i = first; i < end; ++i) sum += values[i];
    means.push_back(sum / static_cast<double>(end - first));
  }
  const auto [low, high] = std::minmax_element(means.begin(), means.end());
  const double range = *high - *low;
  const bool level = !(range > kLevelWithin * std::max(std::abs(*low), std::abs(*high)));
  for (std::size_t k = 0; k < count; ++k) {
    const double height = level ? 0 : (means[k] - *low) / range * kCurveLevels;
    const int step = std::clamp(static_cast<int>(height), 0, kCurveLevels - 1);
    const char32_t sign = level ? (glyphs == Glyphs::ascii ? U'-' : U'─')
                                : (glyphs == Glyphs::ascii ? kAsciiCurve : kBlockCurve)[step];
    line.put(columns - static_cast<int>(count - k), 0, sign, Ink::computes);
  }
  return line;
}

}  // namespace carom
