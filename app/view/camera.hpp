#pragma once

#include "carom/scene.hpp"

namespace carom {

/// What part of the box is looked at.
struct Viewpoint {
  static constexpr double kFarthest = 1;  ///< the whole box
  static constexpr double kNearest = 256;

  double zoom = kFarthest;
  double x = 0.5;  ///< the middle of the picture, in parts of the box
  double y = 0.5;
};

/// Where the box stands on a canvas and how a point of the scene becomes a place among its cells.
///
/// A cell is taken to be twice as high as wide.  The box is as large as fits, in its proportions,
/// rounded to whole cells so that its sides lie exactly between cells; it is centred, with one cell
/// all around for its sides where there is room for them.  Nearer than that the box reaches beyond
/// the canvas.
///
/// Units: `x` and `y` in cells from the upper left corner of the canvas, y down.
class Camera {
 public:
  Camera(const Box& box, int canvas_columns, int canvas_rows, const Viewpoint& viewpoint = {});

  [[nodiscard]] double x(double scene_x) const { return left_ + (scene_x - lower_.x()) * across_; }
  [[nodiscard]] double y(double scene_y) const { return top_ + (upper_.y() - scene_y) * down_; }
  /// The point of the scene at a place among the cells.
  [[nodiscard]] double scene_x(double x) const { return lower_.x() + (x - left_) / across_; }
  [[nodiscard]] double scene_y(double y) const { return upper_.y() - (y - top_) / down_; }

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
