#include "view/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace carom {
namespace {

using Real = std::chrono::duration<double>;

constexpr double kShare = 0.75;   // of a period: computing stops there, the rest is for drawing
constexpr double kActing = 0.25;  // of a period: what keys ask for beyond waits for the next frame
constexpr std::chrono::seconds kNoticeStays{2};
constexpr std::chrono::hours kForever{24};
constexpr double kSmooth = 0.9;  // of what the reference run costs

Instant::duration whole(Real real) {
  return std::chrono::duration_cast<Instant::duration>(real);
}

}  // namespace

Player::Player(Scene scene, UserInterface& interface, const Settings& settings)
    : scene_(std::move(scene)),
      interface_(interface),
      settings_(settings),
      timer_(FrameTimer::Period{std::chrono::nanoseconds{std::chrono::seconds{1}} /
                                settings.frames_per_second},
             interface.now()),
      piles_up_(choose_method(scene_).piles_up) {
  drawing_.glyphs = interface.unicode() ? settings.glyphs : Glyphs::ascii;
  scene_name_ = settings_.scene;
  session_ = std::make_unique<Session>(scene_);
  history_.begin(*session_, interface_.now());
}

int Player::play() {
  interface_.set_title(title());
  timer_.restart(interface_.now());
  energy_due_ = interface_.now();
  show();
  timer_.shown(interface_.now());
  while (!quit_ && !session_->quit()) {
    if (idle()) {
      receive(interface_.wait_until(interface_.now() + kForever));
      timer_.restart(interface_.now());
    }
    read_events_until(timer_.due());
    act();
    if (quit_) break;
    compute();
    if (changed_) {
      show();
    } else {
      meter_.reset();
    }
    timer_.shown(interface_.now());
  }
  finish_recording();
  return signal_;
}

std::string Player::title() const {
  return "carom: " + (scene_.name.empty() ? "a scene" : scene_.name);
}

bool Player::idle() const {
  return session_->stuck() && single_ == 0 && !seek_ && !picker_ && !changed_ && presses_.empty();
}

double Player::frame_seconds() const {
  return speed_ / settings_.frames_per_second;
}

/// All that wait, and those that come until the frame is due; a flood does not keep it longer.
void Player::read_events_until(Instant due) {
  constexpr int kBetweenLooks = 256;
  int read = 0;
  while (!quit_) {
    const Event event = interface_.wait_until(due);
    if (event.kind == Event::Kind::none) return;
    receive(event);
    if (++read % kBetweenLooks == 0 && interface_.now() >= due + timer_.period() / 4) return;
  }
}

/// Quit and pause go ahead of all that waits; the rest waits its turn.
void Player::receive(const Event& event) {
  if (event.kind == Event::Kind::none) return;
  changed_ = true;
  switch (event.kind) {
    case Event::Kind::key: {
      const bool page = help_page_ >= 0 || picker_ || page_waits_;
      if (event.value == 'q' && !page) {
        quit_ = true;
      } else if ((event.value == ' ' || event.value == 'p') && !page) {
        pause_or_go_on();
      } else {
        page_waits_ = page_waits_ || event.value == '?' || event.value == key::kTab;
        presses_.add(event);
      }
      return;
    }
    case Event::Kind::pasted:
    case Event::Kind::mouse:
      return presses_.add(event);
    case Event::Kind::resumed:
      timer_.restart(interface_.now());
      meter_.reset();
      return;
    case Event::Kind::ended:
      signal_ = event.value;
      quit_ = true;
      return;
    default:
      return;
  }
}

/// What keys ask for, in their order, as far as a part of the time for a frame reaches.
void Player::act() {
  const Instant limit = interface_.now() + whole(kActing * Real(timer_.period()));
  do {
    if (presses_.empty()) break;
    const Presses::Press first = presses_.front();
    // Balls come and go one key at a time, since each takes its time.
    const bool one_by_one =
        first.event.value == 'a' || first.event.value == 'A' || first.event.value == 'x';
    const int times = one_by_one ? 1 : first.times;
    presses_.done(times);
    if (first.event.kind == Event::Kind::key) {
      press(first.event.value, times);
    } else if (first.event.kind == Event::Kind::pasted) {
      say("pasted text is ignored");
    } else if (first.event.kind == Event::Kind::mouse) {
      use_mouse(first.event.mouse);
    }
    changed_ = true;
  } while (!quit_ && interface_.now() < limit);
  if (presses_.empty()) page_waits_ = false;
}

/// Moves the simulation on by what a frame wants, as far as the time for a frame reaches.
void Player::compute() {
  const Instant start = interface_.now();
  const Instant limit = start + whole(kShare * Real(timer_.period()));
  if (picker_) {
    picker_->move_preview(interface_, frame_seconds() / speed_, limit);
    changed_ = true;
    return;
  }
  if (move_in_the_past(limit)) {
    calls_ = 1;
    if (!seek_) note_frame(interface_.now());
    return;
  }
  const double target = session_->clock() + frame_seconds();
  const bool moves = !session_->paused() || single_ > 0;
  double left = single_ > 0 ? single_ : target - session_->clock();
  Instant now = start;
  computing_ = computing_.zero();
  calls_ = 0;
  Real beside{0};
  while (left > 0 && !session_->quit() && now < limit) {
    const double slice =
        slice_cost_.slice(left, session_->simulation().step(), Real(limit - now).count());
    if (single_ > 0) {
      session_->nudge(slice);
      left = single_ = slice < left ? left - slice : 0;
    } else {
      session_->advance_clock_to(slice < left ? session_->clock() + slice : target);
      left = slice < left ? target - session_->clock() : 0;
    }
    ++calls_;
    const Instant then = std::exchange(now, interface_.now());
    computing_ += now - then;
    if (reference_) {
      follow_reference();
      const Instant without = std::exchange(now, interface_.now());
      beside += now - without;
    }
    if (moves) slice_cost_.note(slice, Real(now - then).count());
  }
  if (moves) note_frame(now);
  history_.note(*session_, interface_);
  look_ahead();
  reference_cost_ = kSmooth * reference_cost_ + (1 - kSmooth) * beside;
  changed_ = changed_ || moves;
}

void Player::say(std::string notice) {
  notice_ = std::move(notice);
  notice_until_ = interface_.now() + kNoticeStays;
}

/// A command that the engine refuses is said and changes nothing.
bool Player::obey(const Command& command, const std::string& notice) {
  try {
    const std::size_t before = session_->commands();
    session_->apply(command);
    if (session_->commands() != before) changed_by_hand();
    say(notice);
    return true;
  } catch (const CommandError& refused) {
    say(refused.what());
    return false;
  }
}

std::string Player::summary() const {
  const Measurements measured = history_.measured(*session_);
  return fmt::format(
      "{}: {:.2f} s in {} frames, {} late; {} impacts of balls, {} of walls; energy error {:.1e}",
      scene_.name.empty() ? "carom" : scene_.name, session_->simulation().time(), frames_,
      timer_.late(), measured.ball_ball, measured.ball_wall, measured.relative_energy_error());
}

}  // namespace carom
