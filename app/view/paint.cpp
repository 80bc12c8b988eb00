#include "view/paint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/ball_images.hpp"
#include "view/border.hpp"
#include "view/camera.hpp"
#include "view/disk.hpp"
#include "view/pixels.hpp"

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

class Painter {
 public:
  Painter(const Frame& frame, Canvas& canvas, const Camera& camera)
      : frame_(frame),
        canvas_(canvas),
        camera_(camera),
        clip_(visible_cells(frame, camera, canvas)),
        claims_(canvas.cells.size()) {}

  void paint() {
    for (const FrameBall& ball : frame_.balls) {
      each_image(frame_, camera_, ball, [&](const Ellipse& ellipse) { draw(ball, ellipse); });
    }
    const double typical = typical_speed(frame_.balls);
    for (std::size_t cell = 0; cell < claims_.size(); ++cell) {
      const Claim& claim = claims_[cell];
      if (claim.ball == nullptr) continue;
      const char character = claim.character != 0 ? claim.character : character_for(claim.coverage);
      if (character == ' ') continue;
      canvas_.cells[cell] = {static_cast<unsigned char>(character),
                             claim.ball->fixed ? Ink::fixed : Ink::ball,
                             heat_of(*claim.ball, typical), Ink::none, 0};
    }
  }

 private:
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
  const Camera& camera_;
  CellRange clip_;
  std::vector<Claim> claims_;
  std::vector<Coverage> coverage_;
};

}  // namespace

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

void paint(const Frame& frame, Canvas& canvas, const Drawing& drawing) {
  if (canvas.cells.empty()) return;
  const Camera camera(frame.box, canvas.columns, canvas.rows, drawing.viewpoint);
  paint_border(frame, camera, drawing.glyphs, canvas);
  if (drawing.glyphs == Glyphs::ascii) {
    Painter(frame, canvas, camera).paint();
  } else {
    paint_pixels(frame, camera, drawing.glyphs, canvas);
  }
}

}  // namespace carom
