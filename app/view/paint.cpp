#include "view/paint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/camera.hpp"
#include "view/disk.hpp"
#include "view/sides.hpp"

namespace carom {
namespace {

constexpr double kOneCharacter = 1.2;  // balls below this area, in cells, are one character
constexpr double kTiny = 0.3;          // and below this one a dot
constexpr int kSolid = 26;             // samples of 64 from which a cell is full of '#' or a glyph

/// The ball that a cell belongs to so far: the one that covers most of it.
struct Claim {
  const FrameBall* ball = nullptr;
  Coverage coverage;
  char character = 0;  // decided already; 0: by coverage
};

/// The root mean square speed of the balls that can move.
double typical_speed(const std::vector<FrameBall>& balls) {
  double fastest = 0;
  for (const FrameBall& ball : balls) fastest = std::max(fastest, ball.speed);
  if (!(fastest > 0) || !std::isfinite(fastest)) return 0;
  double sum = 0;
  double count = 0;
  for (const FrameBall& ball : balls) {
    if (ball.fixed) continue;
    sum += (ball.speed / fastest) * (ball.speed / fastest);
    ++count;
  }
  return count > 0 ? fastest * std::sqrt(sum / count) : 0;
}

class Painter {
 public:
  Painter(const Frame& frame, Canvas& canvas)
      : frame_(frame),
        canvas_(canvas),
        camera_(frame.box, canvas.columns, canvas.rows),
        clip_{0, 0, canvas.columns, canvas.rows},
        claims_(canvas.cells.size()) {
    // Only where there is no side can a ball be seen beyond it.
    if (frame.walls || frame.box.periodic[0]) {
      clip_.left = std::max(0, camera_.left());
      clip_.right = std::min(canvas.columns, camera_.left() + camera_.columns());
    }
    if (frame.walls || frame.box.periodic[1]) {
      clip_.top = std::max(0, camera_.top());
      clip_.bottom = std::min(canvas.rows, camera_.top() + camera_.rows());
    }
  }

  void paint() {
    paint_sides(frame_, camera_, canvas_);
    for (const FrameBall& ball : frame_.balls) place(ball);
    const double typical = typical_speed(frame_.balls);
    for (std::size_t cell = 0; cell < claims_.size(); ++cell) {
      const Claim& claim = claims_[cell];
      if (claim.ball == nullptr) continue;
      const char character = claim.character != 0 ? claim.character : character_for(claim.coverage);
      if (character == ' ') continue;
      const double heat = typical > 0 ? std::min(1.0, claim.ball->speed / (2 * typical)) : 0.0;
      canvas_.cells[cell] = {character, claim.ball->fixed ? Ink::fixed : Ink::ball,
                             static_cast<float>(heat)};
    }
  }

 private:
  /// The ball and, on a periodic axis, its images next to the box.
  void place(const FrameBall& ball) {
    const Vec2 lower = frame_.box.lower();
    const Vec2 size = frame_.box.size();
    Vec2 home = ball.position;
    for (int axis = 0; axis < 2; ++axis) {
      if (frame_.box.periodic[static_cast<std::size_t>(axis)])
        home[axis] -= size[axis] * std::floor((home[axis] - lower[axis]) / size[axis]);
    }
    const int beside = frame_.box.periodic[0] ? 1 : 0;
    const int above = frame_.box.periodic[1] ? 1 : 0;
    for (int i = -beside; i <= beside; ++i) {
      for (int j = -above; j <= above; ++j) {
        draw(ball, {camera_.x(home.x() + i * size.x()), camera_.y(home.y() + j * size.y()),
                    ball.radius * camera_.across(), ball.radius * camera_.down()});
      }
    }
  }

  void draw(const FrameBall& ball, const Ellipse& ellipse) {
    const CellRange range = cells_of(ellipse, clip_);
    if (range.right <= range.left || range.bottom <= range.top) return;
    const double area = std::numbers::pi * ellipse.across * ellipse.down;
    if (area < kOneCharacter) {
      draw_small(ball, ellipse, area);
      return;
    }
    cover(ellipse, range, coverage_);
    const char solid = ball.glyph != 0 ? ball.glyph : ball.fixed ? '#' : '\0';
    int most = 0;
    for (const Coverage& coverage : coverage_) most = std::max(most, coverage.total());
    const int least = solid != 0 ? std::min(kSolid, most) : 1;
    auto coverage = coverage_.begin();
    for (int row = range.top; row < range.bottom; ++row) {
      for (int column = range.left; column < range.right; ++column, ++coverage) {
        if (coverage->total() >= least) claim(column, row, {&ball, *coverage, solid});
      }
    }
  }

  void draw_small(const FrameBall& ball, const Ellipse& ellipse, double area) {
    const int column = static_cast<int>(std::floor(ellipse.x));
    const int row = static_cast<int>(std::floor(ellipse.y));
    if (column < clip_.left || column >= clip_.right || row < clip_.top || row >= clip_.bottom)
      return;
    char character = 'o';
    if (ball.glyph != 0) {
      character = ball.glyph;
    } else if (ball.fixed) {
      character = '#';
    } else if (area < kTiny) {
      character = ellipse.y - row < 0.5 ? '\'' : '.';
    }
    Claim small{&ball, {}, character};
    small.coverage.quarters[0] = static_cast<int>(area * 4 * Coverage::kFull);
    claim(column, row, small);
  }

  /// Gives the cell to whom covers most of it; on equal terms to both, so that a symmetric frame
  /// makes a symmetric picture.
  void claim(int column, int row, const Claim& claim) {
    Claim& cell =
        claims_[static_cast<std::size_t>(row) * static_cast<std::size_t>(canvas_.columns) +
                static_cast<std::size_t>(column)];
    const int lead = claim.coverage.total() - cell.coverage.total();
    if (cell.ball == nullptr || lead > 0) {
      cell = claim;
    } else if (lead == 0) {
      for (std::size_t i = 0; i < 4; ++i) {
        int& quarter = cell.coverage.quarters[i];
        quarter = std::min(Coverage::kFull, quarter + claim.coverage.quarters[i]);
      }
    }
  }

  const Frame& frame_;
  Canvas& canvas_;
  Camera camera_;
  CellRange clip_;
  std::vector<Claim> claims_;
  std::vector<Coverage> coverage_;
};

}  // namespace

void paint(const Frame& frame, Canvas& canvas) {
  if (canvas.cells.empty()) return;
  Painter(frame, canvas).paint();
}

}  // namespace carom
