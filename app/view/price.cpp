#include "view/price.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/camera.hpp"

namespace carom {
namespace {

constexpr int kDecades = 16;  // from rounding to a radius
constexpr int kEdges = 2;

std::string number(double value) {
  return value == 0 ? "0" : fmt::format("{:.1e}", value);
}

/// One '#' for each power of ten that the distance is above rounding, full at a radius.
std::string bar(double distance, double radius) {
  int full = 0;
  if (distance > 0 && radius > 0) {
    full = kDecades + static_cast<int>(std::ceil(std::log10(distance / radius)));
  }
  full = std::clamp(full, 0, kDecades);
  return std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(kDecades - full), '.');
}

std::vector<std::string> lines_of(const Price& price) {
  std::vector<std::string> lines{
      price.method, fmt::format("{:.2f} ms per frame", price.milliseconds),
      "energy error " + number(price.energy_error),
      fmt::format("deepest overlap {} of a radius", number(price.max_overlap))};
  if (!price.beside) return lines;
  lines.push_back(fmt::format("+ {}: {:.2f} ms", price.beside->name, price.beside->milliseconds));
  lines.push_back("distance " + number(price.beside->distance));
  lines.push_back('[' + bar(price.beside->distance, price.beside->radius) + "] of a radius");
  return lines;
}

}  // namespace

void paint_price(const Price& price, Canvas& canvas) {
  const std::vector<std::string> lines = lines_of(price);
  std::size_t widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, line.size());
  const int room = std::max(0, canvas.columns - kEdges);
  const auto width = std::min(widest, static_cast<std::size_t>(room));
  const int left = canvas.columns - static_cast<int>(width) - kEdges;
  const std::string edge = '+' + std::string(width, '-') + '+';
  int row = 0;
  canvas.write(left, row++, edge, Ink::notice);
  for (const std::string& line : lines) {
    canvas.write(left, row++, fmt::format("|{:<{}}|", line.substr(0, width), width), Ink::notice);
  }
  canvas.write(left, row, edge, Ink::notice);
}

void paint_ghost(const Frame& frame, Canvas& canvas) {
  const Camera camera(frame.box, canvas.columns, canvas.rows);
  for (const FrameBall& ball : frame.balls) {
    Vec2 home = ball.position;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double size = frame.box.size()[axis];
      if (frame.box.periodic[static_cast<std::size_t>(axis)])
        home[axis] -= size * std::floor((home[axis] - frame.box.lower()[axis]) / size);
    }
    const double x = std::floor(camera.x(home.x()));
    const double y = std::floor(camera.y(home.y()));
    if (!(x >= 0 && x < canvas.columns && y >= 0 && y < canvas.rows)) continue;
    Cell& cell = canvas.at(static_cast<int>(x), static_cast<int>(y));
    if (cell.character == ' ') cell = {'+', Ink::ghost, 0};
  }
}

}  // namespace carom
