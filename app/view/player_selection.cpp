// The selected ball: what is told of it, and what keys do to it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carom/crew.hpp"
#include "view/ball_images.hpp"
#include "view/change_mass.hpp"
#include "view/panel.hpp"
#include "view/player.hpp"

namespace carom {
namespace {

constexpr std::chrono::milliseconds kLookingAhead{2};  // in a frame
constexpr double kFollowFrom = 3;                      // zoom, where there is none yet

std::string side_word(Side side) {
  switch (side) {
    case Side::left:
      return "left wall";
    case Side::right:
      return "right wall";
    case Side::bottom:
      return "floor";
    case Side::top:
      return "ceiling";
    default:
      return "wall";
  }
}

/// The worker whose share of `count` balls holds number `place`.
std::size_t worker_of(std::size_t place, std::size_t count, std::size_t workers) {
  std::size_t worker = 0;
  while (worker + 1 < workers && Share{worker, workers}.end(count) <= place) ++worker;
  return worker;
}

}  // namespace

bool Player::press_for_selected(int key, int times) {
  if (key == 'n') {
    select_next(times);
    return true;
  }
  const bool is_for_one = key == 'F' || key == 'X' || key == '*' || key == '/';
  if (!is_for_one && key != key::kEscape) return false;
  const auto place = selected_place();
  if (!place) {
    if (is_for_one) say("select a ball first: click it, or press n");
    return is_for_one;
  }
  switch (key) {
    case 'F':
      followed_ = !followed_;
      say(followed_ ? "the view follows the ball" : "the view stays");
      return true;
    case 'X':
      obey(command::Remove{*place}, fmt::format("removed ball {}", *selected_));
      select({});
      return true;
    case '*':
    case '/': {
      const double factor = std::pow(key == '*' ? 2.0 : 0.5, std::min(times, 100));
      const std::string why_not = change_mass(*session_, *place, factor);
      if (!why_not.empty()) {
        say(why_not);
        return true;
      }
      changed_by_hand();
      selected_ = session_->simulation().ids().back();
      say(fmt::format("mass {:.6g}; it is ball {} now", session_->simulation().state().back().mass,
                      *selected_));
      return true;
    }
    default:
      select({});
      return true;
  }
}

void Player::select(std::optional<std::size_t> ball) {
  selected_.reset();
  if (ball) {
    selected_ = session_->simulation().ids().at(*ball);
  } else {
    followed_ = false;
  }
}

void Player::select_next(int times) {
  const std::size_t balls = session_->simulation().balls();
  if (balls == 0) return say("no ball to select");
  const auto place = selected_place();
  const auto steps = static_cast<std::size_t>(times);
  select(place ? (*place + steps) % balls : (steps - 1) % balls);
}

std::optional<std::size_t> Player::selected_place() const {
  if (!selected_) return std::nullopt;
  const std::vector<std::size_t>& ids = session_->simulation().ids();
  const auto at = std::find(ids.begin(), ids.end(), *selected_);
  if (at == ids.end()) return std::nullopt;
  return static_cast<std::size_t>(at - ids.begin());
}

SelectedBall Player::selected_ball(std::size_t place) const {
  const Simulation& simulation = session_->simulation();
  const std::vector<Ball> balls = simulation.state();
  SelectedBall told;
  told.number = *selected_;
  told.ball = balls.at(place);
  told.spins = session_->scene().effects.friction.has_value();
  told.followed = followed_;
  if (const auto& next = next_event_.found()) {
    const std::string with =
        next->b == Impact::kNoBall ? side_word(next->wall) : fmt::format("ball {}", next->b);
    told.next =
        fmt::format("meets {} in {:.2f} s", with, std::max(0.0, next->time - simulation.time()));
  } else if (simulation.balls() > NextEvent::kMostBalls) {
    told.next = "next event: too many balls";
  } else {
    told.next = next_event_.none()
                    ? fmt::format("meets nothing for {:g} s", NextEvent::kFarthest / 2)
                    : "next event: looking ahead";
  }
  // Of the phases in which each worker has its share of the balls.
  const auto& phases = simulation.measure().phases;
  const bool shared = std::any_of(phases.begin(), phases.end(), [](const auto& phase) {
    return phase.first == "wall_computation" || phase.first == "flight";
  });
  if (shared && !told.ball.fixed) {
    std::size_t at = place;
    std::size_t count = balls.size();
    if (simulation.method() == Method::event && !simulation.effects().attraction) {
      count = count_moving(balls);
      at = count_moving({balls.begin(), balls.begin() + static_cast<std::ptrdiff_t>(place)});
    }
    told.worker = fmt::format("worker {}", worker_of(at, count, simulation.workers()));
  }
  return told;
}

void Player::look_ahead() {
  const auto place = selected_place();
  if (!place || session_->simulation().balls() > NextEvent::kMostBalls) return;
  if (session_->simulation().state().at(*place).fixed) return;
  const Instant until = interface_.now() + kLookingAhead;
  next_event_.look(*session_, *selected_, [&] { return interface_.now() < until; });
  // A paused screen is drawn again when there is something to say.
  if (!next_event_.found() && !next_event_.none()) changed_ = true;
}

void Player::follow_selected() {
  if (!followed_) return;
  const auto place = selected_place();
  if (!place) {
    followed_ = false;
    return;
  }
  const Box& box = session_->scene().box;
  const Vec2 at = session_->simulation().state().at(*place).position - box.lower();
  Viewpoint& view = drawing_.viewpoint;
  if (view.zoom == Viewpoint::kFarthest) view.zoom = kFollowFrom;
  view.x = at.x() / box.width;
  view.y = at.y() / box.height;
  if (box.periodic[0]) view.x -= std::floor(view.x);
  if (box.periodic[1]) view.y -= std::floor(view.y);
  view.x = std::clamp(view.x, 0.0, 1.0);
  view.y = std::clamp(view.y, 0.0, 1.0);
}

void Player::paint_selected(Canvas& picture) const {
  if (aim_) paint_aim(*aim_, picture);
  const auto place = selected_place();
  if (!place) return;
  const Frame frame = session_->simulation().frame();
  each_image(frame, camera(), frame.balls.at(*place), [&](const Ellipse& ellipse) {
    const int row = static_cast<int>(std::floor(ellipse.y));
    const UserInterface::Size size = box_size();
    const auto mark = [&](double x, char32_t character) {
      const int column = static_cast<int>(std::floor(x));
      if (column < size.columns && row < size.rows)
        picture.put(column, row, character, Ink::notice);
    };
    mark(ellipse.x - std::max(ellipse.across, 0.5) - 1, U'>');
    mark(ellipse.x + std::max(ellipse.across, 0.5) + 1, U'<');
  });
  lay_over(selection_panel(selected_ball(*place), picture.columns, picture.rows, drawing_.glyphs),
           0, 0, picture);
}

}  // namespace carom
