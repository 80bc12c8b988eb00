#include "view/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "view/keys.hpp"
#include "view/newcomer.hpp"
#include "view/paint.hpp"
#include "view/status.hpp"

namespace carom {
namespace {

using Real = std::chrono::duration<double>;

constexpr Pacer::Period kPeriod{std::chrono::nanoseconds{std::chrono::seconds{1}} / 30};
constexpr double kShare = 0.75;      // of a period: computing stops there, the rest is for drawing
constexpr double kSliceShare = 0.6;  // of the time left: a slice may cost more than was foreseen
constexpr std::chrono::seconds kNoticeStays{2};
constexpr std::chrono::milliseconds kEnergyEvery{500};
constexpr std::chrono::hours kForever{24};
constexpr double kFastest = 64;
constexpr double kFallsBehind = 0.95;  // of the speed wanted; below, the status says so
constexpr double kSmooth = 0.9;        // of what the exact run costs
constexpr int kLeastColumns = 20;
constexpr int kLeastRows = 8;
constexpr int kRowsForHints = 12;  // screens this high have a second line below

Instant::duration whole(Real real) {
  return std::chrono::duration_cast<Instant::duration>(real);
}

}  // namespace

Player::Player(Scene scene, UserInterface& interface)
    : scene_(std::move(scene)),
      interface_(interface),
      pacer_(kPeriod, interface.now()),
      piles_up_(choose_method(scene_).piles_up) {
  session_.emplace(scene_);
}

int Player::play() {
  pacer_.restart(interface_.now());
  energy_due_ = interface_.now();
  show();
  pacer_.shown(interface_.now());
  while (!quit_ && !session_->quit()) {
    if (idle()) {
      handle(interface_.wait_until(interface_.now() + kForever));
      pacer_.restart(interface_.now());
    }
    handle_events_until(pacer_.due());
    if (quit_) break;
    compute();
    if (changed_) {
      show();
    } else {
      meter_.reset();
    }
    pacer_.shown(interface_.now());
  }
  return signal_;
}

bool Player::idle() const {
  return session_->stuck() && single_ == 0 && !changed_;
}

/// A flood of keys waits for the frame that is due in between.
void Player::handle_events_until(Instant due) {
  while (!quit_) {
    const Event event = interface_.wait_until(due);
    if (event.kind == Event::Kind::none) return;
    handle(event);
    if (interface_.now() >= due + pacer_.period() / 4) return;
  }
}

void Player::handle(const Event& event) {
  switch (event.kind) {
    case Event::Kind::none:
      return;
    case Event::Kind::key:
      press(static_cast<char>(event.value));
      break;
    case Event::Kind::resized:
      break;
    case Event::Kind::resumed:
      pacer_.restart(interface_.now());
      meter_.reset();
      break;
    case Event::Kind::ended:
      signal_ = event.value;
      quit_ = true;
      break;
  }
  changed_ = true;
}

/// Moves the simulation on by what a frame wants, as far as the time for a frame reaches.
void Player::compute() {
  const Instant start = interface_.now();
  const Instant limit = start + whole(kShare * Real(pacer_.period()));
  const double target = session_->clock() + speed_ / kFramesPerSecond;
  const bool moves = !session_->paused() || single_ > 0;
  double left = single_ > 0 ? single_ : target - session_->clock();
  Instant now = start;
  computing_ = computing_.zero();
  Real beside{0};
  while (left > 0 && !session_->quit() && now < limit) {
    // Nothing known of the cost yet: a step at a time.
    const double affordable =
        slice_cost_ > 0 ? kSliceShare * Real(limit - now).count() / slice_cost_ : 0;
    const double slice = std::min(left, std::max(session_->simulation().step(), affordable));
    if (single_ > 0) {
      session_->nudge(slice);
      left = single_ = slice < left ? left - slice : 0;
    } else {
      session_->advance_clock_to(slice < left ? session_->clock() + slice : target);
      left = slice < left ? target - session_->clock() : 0;
    }
    const Instant then = std::exchange(now, interface_.now());
    computing_ += now - then;
    if (ghost_) {
      follow();
      const Instant without = std::exchange(now, interface_.now());
      beside += now - without;
    }
    if (moves) slice_cost_ = std::max(0.9 * slice_cost_, Real(now - then).count() / slice);
  }
  ghost_cost_ = kSmooth * ghost_cost_ + (1 - kSmooth) * beside;
  changed_ = changed_ || moves;
}

void Player::show() {
  const Instant now = interface_.now();
  const UserInterface::Size size = interface_.size();
  Canvas screen(size.columns, size.rows);
  changed_ = false;
  if (size.columns < kLeastColumns || size.rows < kLeastRows) {
    screen.write(0, 0, "too small:", Ink::notice);
    screen.write(0, 1, fmt::format("{}x{} is least", kLeastColumns, kLeastRows), Ink::notice);
    interface_.show(screen);
    return;
  }
  const Simulation& simulation = session_->simulation();
  const int lines = size.rows >= kRowsForHints ? 2 : 1;
  Canvas picture(size.columns, size.rows - lines);
  paint(simulation.frame(), picture);
  if (ghost_) paint_ghost(ghost_->frame(), picture);
  if (priced_) paint_price(price(), picture);
  if (help_page_ >= 0) paint_help(picture, help_page_);
  std::copy(picture.cells.begin(), picture.cells.end(), screen.cells.begin());

  if (now >= energy_due_ || session_->paused()) {
    energy_error_ = simulation.measure().relative_energy_error();
    energy_due_ = now + kEnergyEvery;
  }
  if (now >= notice_until_ && !session_->paused()) notice_.clear();
  const bool running = !session_->paused();
  if (running) {
    meter_.record(now, simulation.time(), computing_);
    ++frames_;
  } else {
    meter_.reset();
  }
  Status status;
  status.scene = scene_.name.empty() ? "carom" : scene_.name;
  status.balls = simulation.balls();
  status.workers = simulation.workers();
  status.time = simulation.time();
  status.frames_per_second = meter_.frames_per_second();
  status.computing_milliseconds = running ? meter_.computing_milliseconds() : 0;
  status.energy_error = energy_error_;
  if (piles_up_) status.note = std::string("overlap: ") + kPilesUp;
  status.late = pacer_.late();
  status.speed = speed_;
  status.paused = !running;
  const auto pace = meter_.pace();
  if (pace && *pace < kFallsBehind * speed_) status.pace = pace;

  const int below = size.rows - lines;
  const std::string line = status_line(status, size.columns);
  if (lines == 2) {
    screen.write(0, below, line, Ink::status);
    if (notice_.empty()) {
      screen.write(0, below + 1, key_hints(size.columns, !running, effect_keys(scene_.effects)),
                   Ink::status);
    } else {
      screen.write(0, below + 1, ' ' + notice_, Ink::notice);
    }
  } else if (notice_.empty()) {
    screen.write(0, below, line, Ink::status);
  } else {
    screen.write(0, below, ' ' + notice_, Ink::notice);
  }
  interface_.show(screen);
}

void Player::say(std::string notice) {
  notice_ = std::move(notice);
  notice_until_ = interface_.now() + kNoticeStays;
}

void Player::press(char key) {
  switch (key) {
    case ' ':
    case 'p':
      meter_.reset();
      if (session_->paused()) {
        obey(command::Resume{}, "running");
      } else {
        obey(command::Pause{}, "paused: space goes on, . shows one frame");
      }
      return;
    case '.':
      if (!session_->paused()) return say("'.' shows one frame while paused: space pauses");
      single_ += speed_ / kFramesPerSecond;
      return say("one frame");
    case 'a':
      return add_balls(1);
    case 'A':
      return add_balls(10);
    case 'x':
      if (session_->simulation().balls() == 0) return say("there is no ball to remove");
      obey(command::Remove{}, "removed the newest ball");
      return;
    case 'r':
      return restart();
    case '+':
    case '=':
      return change_speed(2);
    case '-':
    case '_':
      return change_speed(0.5);
    case '[':
      return change_step(0.5);
    case ']':
      return change_step(2);
    case 'm':
      return change_method();
    case 'e':
      priced_ = !priced_;
      return say(priced_ ? "what this run costs: [ ] and m change it, E an exact run beside it"
                         : "the price is put away");
    case 'E':
      return toggle_ghost();
    case '?':
      ++help_page_;
      {
        const UserInterface::Size size = interface_.size();
        const Canvas canvas(size.columns, size.rows - (size.rows >= kRowsForHints ? 2 : 1));
        if (help_page_ >= help_pages(canvas)) help_page_ = -1;
        return say(help_page_ < 0 ? "help away" : "help: ? for more, then away");
      }
    case 'q':
      quit_ = true;
      return say("quit");
    default:
      if (toggle_effect(key)) return;
      return say(key > ' ' && key <= '~' ? fmt::format("'{}' is no key here: ? lists them", key)
                                         : "that is no key here: ? lists them");
  }
}

/// A command that the engine refuses is said and changes nothing.
bool Player::obey(const Command& command, const std::string& notice) {
  try {
    session_->apply(command);
    say(notice);
    return true;
  } catch (const CommandError& refused) {
    say(refused.what());
    return false;
  }
}

void Player::add_balls(int count) {
  int placed = 0;
  try {
    for (; placed < count; ++placed) {
      const std::optional<Ball> ball = newcomer(*session_, added_);
      if (!ball) break;
      ++added_;
      session_->apply(command::Add{*ball});
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
  const double speed = speed_ * factor;
  if (speed > kFastest || speed < 1 / kFastest) {
    return say(fmt::format("speed stays {}", speed_text(speed_)));
  }
  speed_ = speed;
  meter_.reset();
  say(fmt::format("speed {}", speed_text(speed_)));
}

void Player::change_step(double factor) {
  const double step = session_->simulation().step() * factor;
  slice_cost_ = 0;
  obey(command::SetStep{step}, fmt::format("step 1/{:.6g} s", 1 / step));
}

/// Off: values that do nothing; on: those of the scene.  False where the key is no effect's.
bool Player::toggle_effect(char key) {
  bool found = false;
  std::size_t index = 0;
  for_each_effect([&](const auto& entry) {
    bool& off = switched_off_[index++];
    if (entry.key != key) return;
    found = true;
    const auto& effect = scene_.effects.*entry.slot;
    if (!effect) return say(fmt::format("this scene has no {}", entry.name));
    command::SetEffects change;
    change.effects.*entry.slot = off ? *effect : switched_off(*effect);
    if (obey(change, fmt::format("{} {}", entry.name, off ? "on" : "off"))) off = !off;
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
  session_.emplace(std::move(scene));
  scene_.solver.digits = session_->scene().solver.digits;
  scene_.solver.method = method;
  piles_up_ = false;
  slice_cost_ = 0;
  meter_.reset();
  const std::string notice = std::string("method ") + method_name(method);
  if (ghost_) begin_ghost();
  say(ghost_ ? notice + "; the comparison starts again" : notice);
}

void Player::toggle_ghost() {
  if (ghost_) {
    ghost_.reset();
    return say("the exact run is put away");
  }
  begin_ghost();
  if (!ghost_) return;
  priced_ = true;
  say("an exact run beside this one, from here: its balls are '+'");
}

void Player::begin_ghost() {
  ghost_.reset();
  ghost_cost_ = ghost_cost_.zero();
  try {
    ghost_.emplace(*session_);
  } catch (const SceneError& refused) {
    say("no exact run: " + refused.problems().front().message);
  }
}

/// A command, of a key or of the script, makes it another run.
void Player::follow() {
  if (ghost_->is_of(session_->simulation())) return ghost_->follow(session_->simulation());
  begin_ghost();
  if (ghost_) say((notice_.empty() ? "" : notice_ + "; ") + "the comparison starts again");
}

Price Player::price() const {
  const Simulation& simulation = session_->simulation();
  const Measurements measured = simulation.measure();
  Price price;
  price.method = method_name(simulation.method());
  if (simulation.method() == Method::overlap || scene_.effects.attraction) {
    price.method += fmt::format(", step 1/{:.6g} s", 1 / simulation.step());
  } else {
    price.method += fmt::format(", {} digits", session_->scene().solver.digits);
  }
  price.milliseconds = meter_.computing_milliseconds();
  price.energy_error = measured.relative_energy_error();
  price.max_overlap = measured.max_overlap;
  if (!ghost_) return price;
  price.beside.emplace();
  price.beside->name = ghost_->name();
  price.beside->milliseconds = std::chrono::duration<double, std::milli>(ghost_cost_).count();
  price.beside->distance = ghost_->distance();
  const Frame frame = simulation.frame();
  for (const FrameBall& ball : frame.balls) {
    double& radius = price.beside->radius;
    radius = radius == 0 ? ball.radius : std::min(radius, ball.radius);
  }
  return price;
}

void Player::restart() {
  const bool compared = ghost_.has_value();
  ghost_.reset();
  session_.reset();  // its threads end before as many start again
  session_.emplace(scene_);
  switched_off_.fill(false);
  added_ = 0;
  single_ = 0;
  slice_cost_ = 0;
  meter_.reset();
  energy_due_ = interface_.now();
  pacer_.restart(interface_.now());
  if (compared) begin_ghost();
  say(ghost_ ? "restarted; the comparison starts again" : "restarted");
}

std::string Player::summary() const {
  const Measurements measured = session_->simulation().measure();
  return fmt::format(
      "{}: {:.2f} s in {} frames, {} late; {} impacts of balls, {} of walls; energy error {:.1e}",
      scene_.name.empty() ? "carom" : scene_.name, session_->simulation().time(), frames_,
      pacer_.late(), measured.ball_ball, measured.ball_wall, measured.relative_energy_error());
}

}  // namespace carom
