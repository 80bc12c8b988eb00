// What the mouse does.
#include <fmt/format.h>

#include <algorithm>

#include "view/player.hpp"
#include "view/pointer.hpp"
#include "view/spawn.hpp"

namespace carom {
namespace {

constexpr double kZoomOfWheel = 1.25;
constexpr double kThrow = 2;  // drags of a length become that length times so much in a second

/// Inside the solid sides, as far as the box has room.
double kept_inside(double x, double lower, double upper) {
  return lower < upper ? std::clamp(x, lower, upper) : x;
}

}  // namespace

Camera Player::camera() const {
  const UserInterface::Size size = box_size();
  return {session_->scene().box, size.columns, size.rows, drawing_.viewpoint};
}

void Player::use_mouse(const Mouse& mouse) {
  const UserInterface::Size size = box_size();
  if (picker_) return use_mouse_in_picker(mouse);
  const bool inside = mouse.column < size.columns && mouse.row < size.rows;
  switch (mouse.action) {
    case Mouse::Action::wheel_up:
    case Mouse::Action::wheel_down: {
      if (!inside || help_page_ >= 0) return;
      const double factor =
          mouse.action == Mouse::Action::wheel_up ? kZoomOfWheel : 1 / kZoomOfWheel;
      drawing_.viewpoint = zoomed_at(session_->scene().box, size.columns, size.rows,
                                     drawing_.viewpoint, factor, mouse.column, mouse.row);
      return say(fmt::format("zoom {:.3g}x", drawing_.viewpoint.zoom));
    }
    case Mouse::Action::press:
      aim_.reset();
      scrubbing_ = false;
      if (mouse.button == 0) press_button(mouse.column, mouse.row);
      return;
    case Mouse::Action::drag:
      if (scrubbing_) scrub(mouse.column);
      if (!aim_) return;
      aim_->to_column = mouse.column;
      aim_->to_row = mouse.row;
      return;
    case Mouse::Action::release:
      scrubbing_ = false;
      if (!aim_) return;
      aim_->to_column = mouse.column;
      aim_->to_row = mouse.row;
      throw_ball();
      aim_.reset();
      return;
  }
}

void Player::use_mouse_in_picker(const Mouse& mouse) {
  const UserInterface::Size size = interface_.size();
  switch (mouse.action) {
    case Mouse::Action::wheel_up:
      return picker_->move(-1);
    case Mouse::Action::wheel_down:
      return picker_->move(1);
    case Mouse::Action::press: {
      const std::string before = picker_->chosen();
      const int rows = size.rows - lines_below(size.rows);
      const bool again = picker_->choose_at(mouse.column, mouse.row, size.columns, rows) &&
                         picker_->chosen() == before;
      if (again) open_scene(before);
      return;
    }
    default:
      return;
  }
}

void Player::scrub(int column) {
  if (const auto bar = scrub_bar_now()) go_to(moment_at(*bar, interface_.size().columns, column));
}

void Player::press_button(int column, int row) {
  const UserInterface::Size screen = interface_.size();
  const UserInterface::Size size = box_size();
  if (row == screen.rows - 1 && lines_below(screen.rows) > 1 && notice_.empty()) {
    const auto hints = key_hints(screen.columns, session_->paused(), effect_keys(scene_.effects));
    if (const int key = key_of_hint(hints, column)) press(key, 1);
    return;
  }
  if (help_page_ >= 0) {
    help_page_ = -1;
    return;
  }
  const int below = screen.rows - lines_below(screen.rows);
  if (row == below - 1 && scrub_bar_now()) {
    scrubbing_ = true;
    return scrub(column);
  }
  if (const auto place = selected_place()) {
    const SelectedBall ball = selected_ball(*place);
    const Canvas panel = selection_panel(ball, size.columns, size.rows, drawing_.glyphs);
    if (column < panel.columns && row < panel.rows) {
      if (const auto key = selection_key_at(ball, panel.columns, panel.rows, column, row))
        press(*key, 1);
      return;
    }
  }
  if (column >= size.columns || row >= size.rows) return;
  const Frame frame = session_->simulation().frame();
  if (const auto ball = ball_at(frame, camera(), column, row)) return select(ball);
  const Vec2 point = point_at(camera(), column, row);
  const Vec2 lower = frame.box.lower();
  const Vec2 upper = frame.box.upper();
  const bool in_box = point.x() >= lower.x() && point.x() <= upper.x() && point.y() >= lower.y() &&
                      point.y() <= upper.y();
  if (in_box) aim_ = Aim{column, row, column, row};
}

void Player::throw_ball() {
  const Vec2 from = point_at(camera(), aim_->column, aim_->row);
  const Vec2 to = point_at(camera(), aim_->to_column, aim_->to_row);
  const Box& box = session_->scene().box;
  Ball ball = model_ball(*session_);
  ball.position = from;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!session_->simulation().frame().walls || box.periodic[axis]) continue;
    ball.position[axis] =
        kept_inside(from[axis], box.lower()[axis] + ball.radius, box.upper()[axis] - ball.radius);
  }
  ball.velocity = kThrow * (to - from);
  obey(command::Add{ball}, aim_->still()
                               ? "added a ball at rest: drag to throw one"
                               : fmt::format("threw a ball, speed {:.3g}", ball.velocity.norm()));
}

}  // namespace carom
