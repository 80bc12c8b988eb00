#include "view/arrows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/ball_images.hpp"
#include "view/camera.hpp"
#include "view/dots.hpp"

namespace carom {
namespace {

constexpr double kPart = 1.0 / 15;   // of the picture, for the typical speed, at the most
constexpr double kSpacing = 0.6;     // of the mean distance of balls, at the most
constexpr double kShortest = 0.5;    // cells
constexpr double kLongestArrow = 3;  // typical speeds

constexpr char32_t kAsciiHeads[] = {U'>', U'/', U'^', U'\\', U'<', U'/', U'v', U'\\'};
constexpr char32_t kHeads[] = {U'→', U'↗', U'↑', U'↖', U'←', U'↙', U'↓', U'↘'};

/// The eighth of a turn that a direction among cells is nearest to, counter-clockwise from right;
/// cells are twice as high as wide.
std::size_t eighth(const Vec2& way) {
  const double angle = std::atan2(-2 * way.y(), way.x());
  return static_cast<std::size_t>((std::lround(angle / (std::numbers::pi / 4)) + 8) % 8);
}

/// An arrow among the cells.
struct Arrow {
  Vec2 from;
  Vec2 to;
};

/// From the edge of the ellipse on.
Arrow arrow_of(const Ellipse& ellipse, const Vec2& way) {
  const double edge = 1 / std::hypot(way.x() / ellipse.across, way.y() / ellipse.down);
  const Vec2 from{ellipse.x + way.x() * edge, ellipse.y + way.y() * edge};
  return {from, from + way};
}

}  // namespace

void paint_arrows(const Frame& frame, const std::vector<Ball>& balls, Canvas& canvas,
                  const Drawing& drawing) {
  const double typical = typical_speed(frame.balls);
  if (!(typical > 0) || balls.size() != frame.balls.size()) return;
  const Camera camera(frame.box, canvas.columns, canvas.rows, drawing.viewpoint);
  const CellRange cells = visible_cells(frame, camera, canvas);
  const double spacing =
      std::sqrt(frame.box.width * frame.box.height / static_cast<double>(balls.size()));
  const double time = std::min(kPart * frame.box.width, kSpacing * spacing) / typical;
  std::vector<Arrow> arrows;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const FrameBall& ball = frame.balls[i];
    if (ball.fixed || !(ball.speed > 0)) continue;
    const Vec2 velocity = balls[i].velocity * std::min(1.0, kLongestArrow * typical / ball.speed);
    const Vec2 way{velocity.x() * time * camera.across(), -velocity.y() * time * camera.down()};
    if (std::max(std::abs(way.x()), std::abs(way.y())) < kShortest) continue;
    each_image(frame, camera, ball,
               [&](const Ellipse& ellipse) { arrows.push_back(arrow_of(ellipse, way)); });
  }
  // Heads go over lines, and neither goes over a ball.
  const auto& heads = drawing.glyphs == Glyphs::ascii ? kAsciiHeads : kHeads;
  for (const Arrow& arrow : arrows) {
    const double x = std::floor(arrow.to.x());
    const double y = std::floor(arrow.to.y());
    if (!(x >= cells.left && x < cells.right && y >= cells.top && y < cells.bottom)) continue;
    Cell& cell = canvas.at(static_cast<int>(x), static_cast<int>(y));
    if (cell.character == U' ')
      cell = {heads[eighth(arrow.to - arrow.from)], Ink::notice, 0, Ink::none, 0};
  }
  Dots dots(canvas, cells, drawing.glyphs);
  for (const Arrow& arrow : arrows) dots.line(arrow.from, arrow.to, 0);
  dots.lay_under(Ink::notice, canvas);
}

}  // namespace carom
