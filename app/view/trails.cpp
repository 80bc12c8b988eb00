#include "view/trails.hpp"

#include <algorithm>

#include "carom/shorter_way.hpp"
#include "view/ball_images.hpp"
#include "view/camera.hpp"
#include "view/dots.hpp"

namespace carom {
namespace {

constexpr std::size_t kMostPieces = 1500;  // of all trails, from a frame to the next
constexpr std::size_t kFewestPieces = 6;

}  // namespace

void Trails::show(bool shown) {
  shown_ = shown;
  positions_.clear();
}

void Trails::add(const Frame& frame) {
  if (!shown_) return;
  const bool other = !positions_.empty() && positions_.front().size() != frame.balls.size();
  if (other || frame.time < time_) positions_.clear();
  if (!positions_.empty() && frame.time == time_) return;
  time_ = frame.time;
  std::vector<Vec2> positions;
  positions.reserve(frame.balls.size());
  for (const FrameBall& ball : frame.balls) positions.push_back(ball.position);
  positions_.push_back(std::move(positions));
  if (positions_.size() > kFrames) positions_.pop_front();
}

void Trails::paint(const Frame& frame, Canvas& canvas, const Drawing& drawing) const {
  if (positions_.size() < 2 || positions_.back().size() != frame.balls.size()) return;
  const Camera camera(frame.box, canvas.columns, canvas.rows, drawing.viewpoint);
  const CellRange cells = visible_cells(frame, camera, canvas);
  const double typical = typical_speed(frame.balls);
  // Of many balls the trails are shorter: the picture is not to be full of them.
  const std::size_t frames =
      std::clamp(kMostPieces / (1 + frame.balls.size()), kFewestPieces, kFrames);
  const std::size_t first = positions_.size() > frames ? positions_.size() - frames : 1;
  Dots dots(canvas, cells, drawing.glyphs);
  for (std::size_t i = 0; i < frame.balls.size(); ++i) {
    const FrameBall& ball = frame.balls[i];
    if (ball.fixed || ball.speed == 0) continue;
    const float heat = heat_of(ball, typical);
    for (std::size_t k = first; k < positions_.size(); ++k) {
      // The short way through a periodic side ends at one side and begins at the other.
      const Vec2 from = positions_[k - 1][i];
      const Vec2 to = positions_[k][i];
      const Vec2 way = shorter_way(to - from, frame.box);
      const auto draw = [&](const Vec2& begin, const Vec2& end) {
        dots.line({camera.x(begin.x()), camera.y(begin.y())},
                  {camera.x(end.x()), camera.y(end.y())}, heat);
      };
      draw(to - way, to);
      if (way.x() != to.x() - from.x() || way.y() != to.y() - from.y()) draw(from, from + way);
    }
  }
  dots.lay_under(Ink::trail, canvas);
}

}  // namespace carom
