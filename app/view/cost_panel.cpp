#include "view/cost_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/ball_images.hpp"
#include "view/panel.hpp"

namespace carom {
namespace {

constexpr int kDecades = 16;  // from rounding to a radius
constexpr int kEdges = 2;

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

std::vector<std::string> lines_of(const Cost& cost) {
  std::vector<std::string> lines{
      cost.method, fmt::format("{:.2f} ms per frame", cost.milliseconds),
      fmt::format("energy dissipated {:.4g}", cost.dissipated),
      "energy error " + exponent(cost.energy_error),
      fmt::format("deepest overlap {} of a radius", exponent(cost.max_overlap))};
  if (!cost.reference) return lines;
  const ReferenceCost& reference = *cost.reference;
  lines.push_back(fmt::format("+ {}: {:.2f} ms", reference.name, reference.milliseconds));
  lines.push_back("distance " + exponent(reference.distance));
  lines.push_back('[' + bar(reference.distance, reference.radius) + "] of a radius");
  lines.push_back(
      reference.horizon
          ? fmt::format("{} is right for {:.3g} s here", cost.precision, *reference.horizon)
          : fmt::format("{} is right so far, {:.3g} s", cost.precision, reference.span));
  return lines;
}

}  // namespace

Canvas cost_panel(const Cost& cost, int columns, int rows, Glyphs glyphs) {
  return framed(text_block(lines_of(cost), columns - kEdges, rows - kEdges), "cost", glyphs);
}

void paint_reference(const Frame& frame, Canvas& canvas, const Drawing& drawing) {
  const Camera camera(frame.box, canvas.columns, canvas.rows, drawing.viewpoint);
  for (const FrameBall& ball : frame.balls) {
    each_image(frame, camera, ball, [&](const Ellipse& ellipse) {
      const double x = std::floor(ellipse.x);
      const double y = std::floor(ellipse.y);
      if (!(x >= 0 && x < canvas.columns && y >= 0 && y < canvas.rows)) return;
      Cell& cell = canvas.at(static_cast<int>(x), static_cast<int>(y));
      if (cell.character == U' ') cell = {U'+', Ink::ghost, 0, Ink::none, 0};
    });
  }
}

}  // namespace carom
