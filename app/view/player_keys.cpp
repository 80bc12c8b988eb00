// What keys do.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "view/help_panel.hpp"
#include "view/player.hpp"
#include "view/spawn.hpp"
#include "view/status.hpp"

namespace carom {
namespace {

constexpr double kFastest = 64;
constexpr double kShortestStep = 1.0 / 30720;
constexpr double kLongestStep = 1.0 / 15;
constexpr double kZoom = 1.25;
constexpr double kPart = 0.1;  // of the picture: a view moves by so much

/// The factor of a key pressed so many times, bounded so that it stays a number.
double power(double base, int times) {
  return std::pow(base, std::min(times, 100));
}

}  // namespace

void Player::press(int key, int times) {
  if (picker_) return press_in_picker(key, times);
  if (help_page_ >= 0 && press_in_help(key, times)) return;
  if (press_for_selected(key, times) || press_for_time(key, times) || press_for_scenes(key)) return;
  const bool odd = times % 2 != 0;
  switch (key) {
    case ' ':
    case 'p':
      if (odd) pause_or_go_on();
      return;
    case 'z':
      if (odd) toggle_trails();
      return;
    case 'v':
      if (odd) toggle_arrows();
      return;
    case 'N':
      if (odd) toggle_numbers();
      return;
    case 'h':
      if (odd) toggle_instruments();
      return;
    case 'l':
      if (odd) toggle_threads();
      return;
    case 'L':
      if (odd) toggle_slow_motion();
      return;
    case '.':
      if (threads_.slow()) return next_barrier();
      if (!session_->paused()) return say("space pauses first; then . shows one frame");
      single_frames(times);
      return say(times == 1 ? "one frame" : fmt::format("{} frames", times));
    case 'a':
      return add_balls(1);
    case 'A':
      return add_balls(10);
    case 'x':
      if (session_->simulation().balls() == 0) return say("no ball to remove");
      obey(command::Remove{}, "removed the newest ball");
      return;
    case 'r':
      return restart();
    case '+':
    case '=':
      return change_speed(power(2, times));
    case '-':
    case '_':
      return change_speed(power(0.5, times));
    case '[':
      return change_step(power(0.5, times));
    case ']':
      return change_step(power(2, times));
    case 'm':
      if (odd) change_method();
      return;
    case 'b':
      for (int i = 0; i < times % 3; ++i) next_glyphs();
      return;
    case '<':
      return zoom(power(1 / kZoom, times));
    case '>':
      return zoom(power(kZoom, times));
    case '0':
      drawing_.viewpoint = {};
      followed_ = false;
      return say("the whole box");
    case key::kLeft:
      return move_view(-kPart * times, 0);
    case key::kRight:
      return move_view(kPart * times, 0);
    case key::kUp:
      return move_view(0, kPart * times);
    case key::kDown:
      return move_view(0, -kPart * times);
    case 'e':
      if (odd) cost_shown_ = !cost_shown_;
      return say(cost_shown_ ? "cost: [ ] and m change it, E adds an exact run" : "panel closed");
    case 'E':
      if (odd) toggle_reference();
      return;
    case '?':
      help_page_ = 0;
      press_in_help('?', times - 1);
      return say("help: ? next page, Esc closes");
    case 'q':
      quit_ = true;
      return;
    case key::kEscape:
    case key::kEnter:
      return;
    default:
      if (toggle_effect(key, times)) return;
      return say(key > ' ' && key <= '~'
                     ? fmt::format("no such key: {} (? for help)", static_cast<char>(key))
                     : "no such key (? for help)");
  }
}

/// The keys that mean something else while the help is open.
bool Player::press_in_help(int key, int times) {
  switch (key) {
    case '?': {
      const UserInterface::Size size = interface_.size();
      const int pages = help_pages(Canvas(size.columns, size.rows - lines_below(size.rows)));
      help_page_ = (help_page_ + 1 + times) % (pages + 1) - 1;
      return true;
    }
    case 'q':
    case key::kEscape:
    case key::kEnter:
      help_page_ = -1;
      notice_.clear();
      return true;
    default:
      return false;
  }
}

void Player::pause_or_go_on() {
  meter_.reset();
  if (session_->paused()) {
    threads_.set_slow(false);
    obey(command::Resume{}, "running");
  } else {
    obey(command::Pause{}, "paused: space goes on, . shows one frame");
  }
}

void Player::add_balls(int count) {
  int placed = 0;
  try {
    for (; placed < count; ++placed) {
      const std::optional<Ball> ball = spawn(*session_, added_);
      if (!ball) break;
      ++added_;
      session_->apply(command::Add{*ball});
      changed_by_hand();
    }
  } catch (const CommandError& refused) {
    if (placed == 0) return say(refused.what());
  }
  if (placed == count) {
    say(count == 1 ? "added a ball" : fmt::format("added {} balls", count));
  } else {
    say(placed == 0 ? "no free place for a ball"
                    : fmt::format("added {}: no free place for more", placed));
  }
}

void Player::change_speed(double factor) {
  const double speed = std::clamp(speed_ * factor, 1 / kFastest, kFastest);
  if (speed == speed_) return say(fmt::format("speed stays {}", speed_text(speed_)));
  speed_ = speed;
  meter_.reset();
  say(fmt::format("speed {}", speed_text(speed_)));
}

void Player::change_step(double factor) {
  const Simulation& simulation = session_->simulation();
  if (simulation.method() == Method::event && !simulation.effects().attraction)
    return say("no step with method event");
  const double present = simulation.step();
  // Where the scene's own step is beyond the bounds, so are they.
  const double step = std::clamp(present * factor, std::min(kShortestStep, scene_.solver.step),
                                 std::max(kLongestStep, scene_.solver.step));
  const std::string words = fmt::format("1/{:.6g} s", 1 / step);
  if (step == present) return say("step stays " + words);
  slice_cost_ = {};
  obey(command::SetStep{step}, "step " + words);
}

/// False where the key is no effect's.
bool Player::toggle_effect(int key, int times) {
  bool found = false;
  for_each_effect([&](const auto& entry) {
    if (entry.key != key) return;
    found = true;
    const auto change = session_->switch_of(entry.name);
    if (!change) return say(fmt::format("this scene has no {}", entry.name));
    if (times % 2 == 0) return;
    obey(change->change, fmt::format("{} {}", entry.name, change->on ? "on" : "off"));
  });
  return found;
}

/// The run goes on from where it stands, computed the other way.
void Player::change_method() {
  const Simulation& simulation = session_->simulation();
  const Method method = simulation.method() == Method::overlap ? Method::event : Method::overlap;
  Scene scene = session_->save();
  scene.balls = simulation.state();
  const Continuation stood = scene.continuation.value_or(Continuation{});
  scene.continuation.emplace();
  scene.continuation->time = simulation.time();
  scene.continuation->clock = stood.clock;
  scene.continuation->paused = stood.paused;
  scene.continuation->step_origin = simulation.time();
  scene.solver.method = method;
  if (method == Method::overlap) scene.solver.digits = 16;
  const std::string why_not = obstacle(scene, method);
  if (!why_not.empty()) {
    return say(fmt::format("method {} stays: {}", method_name(simulation.method()), why_not));
  }
  const Effects when_on = session_->effects_when_on();
  const std::optional<std::size_t> selected = selected_place();
  session_ = std::make_unique<Session>(std::move(scene));
  selected_ = selected;
  session_->set_effects_when_on(when_on);
  history_.begin(*session_, interface_.now());
  seek_.reset();
  scene_.solver.digits = session_->scene().solver.digits;
  scene_.solver.method = method;
  piles_up_ = false;
  slice_cost_ = {};
  meter_.reset();
  const std::string notice = std::string("method ") + method_name(method);
  if (reference_) begin_reference();
  if (instruments_.open())
    instruments_.begin_again(session_->simulation(), history_.measured(*session_));
  say(reference_ ? notice + "; the comparison starts again" : notice);
}

void Player::toggle_reference() {
  if (reference_) {
    reference_.reset();
    return say("the exact run is closed");
  }
  begin_reference();
  if (!reference_) return;
  cost_shown_ = true;
  say("an exact run from here on: its balls are '+'");
}

void Player::begin_reference() {
  reference_.reset();
  reference_cost_ = reference_cost_.zero();
  try {
    reference_.emplace(*session_);
  } catch (const SceneError& refused) {
    say("no exact run: " + refused.problems().front().message);
  }
}

/// A command, of a key or of the script, makes it another run.
void Player::follow_reference() {
  if (reference_->is_of(session_->simulation())) return reference_->follow(session_->simulation());
  begin_reference();
  if (reference_) say((notice_.empty() ? "" : notice_ + "; ") + "the comparison starts again");
}

void Player::next_glyphs() {
  if (!interface_.unicode()) return say("glyphs stay ascii: other ones need a UTF-8 locale");
  drawing_.glyphs = drawing_.glyphs == Glyphs::ascii    ? Glyphs::blocks
                    : drawing_.glyphs == Glyphs::blocks ? Glyphs::braille
                                                        : Glyphs::ascii;
  chosen_glyphs_ = drawing_.glyphs;
  say(fmt::format("glyphs {}", name_of(drawing_.glyphs)));
}

void Player::zoom(double factor) {
  Viewpoint& view = drawing_.viewpoint;
  view.zoom = std::clamp(view.zoom * factor, Viewpoint::kFarthest, Viewpoint::kNearest);
  if (view.zoom == Viewpoint::kFarthest) view = {};
  say(fmt::format("zoom {:.3g}x", view.zoom));
}

void Player::move_view(double columns, double rows) {
  Viewpoint& view = drawing_.viewpoint;
  followed_ = false;
  if (view.zoom == Viewpoint::kFarthest) return say("zoom in first: >");
  view.x = std::clamp(view.x + columns / view.zoom, 0.0, 1.0);
  view.y = std::clamp(view.y + rows / view.zoom, 0.0, 1.0);
}

void Player::restart() {
  const bool compared = reference_.has_value();
  reference_.reset();
  select({});
  session_.reset();  // its threads end before as many start again
  session_ = std::make_unique<Session>(scene_);
  begin_again();
  if (compared) begin_reference();
  say(reference_ ? "restarted; the comparison starts again" : "restarted");
}

void Player::begin_again() {
  history_.begin(*session_, interface_.now());
  seek_.reset();
  added_ = 0;
  single_ = 0;
  slice_cost_ = {};
  meter_.reset();
  energy_due_ = interface_.now();
  timer_.restart(interface_.now());
  if (instruments_.open())
    instruments_.begin_again(session_->simulation(), history_.measured(*session_));
}

}  // namespace carom
