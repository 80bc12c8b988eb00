#pragma once

#include "carom/scene.hpp"

namespace carom {

/// Where the box stands on a canvas and how a point of the scene becomes a place among its cells.
///
/// A cell is taken to be twice as high as wide.  The box is as large as fits, in its proportions,
/// rounded to whole cells so that its sides lie exactly between cells; it is centred, with one cell
/// all around for its sides where there is room for them.
///
/// Units: `x` and `y` in cells from the upper left corner of the canvas, y down.
class Camera {
 public:
  Camera(const Box& box, int canvas_columns, int canvas_rows);

  [[nodiscard]] double x(double scene_x) const { return left_ + (scene_x - lower_.x()) * across_; }
  [[nodiscard]] double y(double scene_y) const { return top_ + (upper_.y() - scene_y) * down_; }

  [[nodiscard]] int left() const { return left_; }  ///< first column inside the box
  [[nodiscard]] int top() const { return top_; }    ///< first row inside the box
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double across() const { return across_; }  ///< columns per length
  [[nodiscard]] double down() const { return down_; }      ///< rows per length
  [[nodiscard]] bool bordered() const { return bordered_; }

 private:
  Vec2 lower_;
  Vec2 upper_;
  bool bordered_;
  int columns_ = 1;
  int rows_ = 1;
  int left_ = 0;
  int top_ = 0;
  double across_ = 1;
  double down_ = 1;
};

}  // namespace carom
