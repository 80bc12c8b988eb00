#pragma once

#include <utility>
#include <vector>

#include "view/paint.hpp"

namespace carom {

inline Frame box_with(std::vector<FrameBall> balls, bool walls = true) {
  Frame frame;
  frame.walls = walls;
  frame.balls = std::move(balls);
  return frame;
}

inline FrameBall ball_at(double x, double y, double radius = 0.5) {
  FrameBall ball;
  ball.position = {x, y};
  ball.radius = radius;
  ball.speed = 1;
  return ball;
}

inline Canvas painted(const Frame& frame, int columns = 80, int rows = 24) {
  Canvas canvas(columns, rows);
  paint(frame, canvas);
  return canvas;
}

}  // namespace carom
