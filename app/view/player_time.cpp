// Time back: what leads to a moment that was, and the bar that shows where it lies.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "view/player.hpp"

namespace carom {
namespace {

constexpr int kTen = 10;
constexpr int kLeastRowsForBar = 10;

}  // namespace

bool Player::press_for_time(int key, int times) {
  if (key != ',' && key != key::kBackspace) return false;
  if (!history_.possible()) {
    say("no way back: too many balls to remember");
    return true;
  }
  const int frames = key == ',' ? times : kTen * times;
  const double from = seek_.value_or(session_->simulation().time());
  const double to = history_.frame_before(from, frames);
  if (to >= from) {
    say("this is the start");
    return true;
  }
  go_to(to);
  say(fmt::format("back to {:.2f} s: . goes forward, space goes on", to));
  return true;
}

/// In the past `.` shows the frames that were shown.
void Player::single_frames(int times) {
  if (history_.is_past(*session_) || seek_) {
    const double from = seek_.value_or(session_->simulation().time());
    seek_ = history_.frame_before(from, -times);
  } else {
    single_ += times * frame_seconds();
  }
}

void Player::go_to(double time) {
  if (!history_.possible()) return;
  single_ = 0;
  if (time < session_->simulation().time()) {
    history_.go_back(session_, time);
    slice_cost_ = {};
    meter_.reset();
  } else if (!session_->paused()) {
    session_->apply(command::Pause{});
  }
  seek_ = std::min(time, history_.last());
}

/// Moves on in the past, as far as the time for a frame reaches; false where the session is not
/// there.
bool Player::move_in_the_past(Instant limit) {
  if (!seek_ && history_.is_past(*session_)) {
    if (session_->paused() && single_ == 0) return false;
    const double time = session_->simulation().time();
    seek_ = std::min(time + (single_ > 0 ? single_ : frame_seconds()), history_.last());
    single_ = 0;
  }
  if (!seek_) return false;
  Instant now = interface_.now();
  do {
    const double time = session_->simulation().time();
    const double left = *seek_ - time;
    const double slice = slice_cost_.slice(left, session_->simulation().step(),
                                           std::chrono::duration<double>(limit - now).count());
    history_.move_on(*session_, slice < left ? time + slice : *seek_);
    const Instant then = std::exchange(now, interface_.now());
    const double moved = session_->simulation().time() - time;
    if (moved > 0) slice_cost_.note(moved, std::chrono::duration<double>(now - then).count());
  } while (session_->simulation().time() < *seek_ && now < limit);
  if (session_->simulation().time() >= *seek_) {
    seek_.reset();
    if (reference_) begin_reference();
  }
  changed_ = true;
  return true;
}

/// What was to come on the way so far does not come any more.
void Player::changed_by_hand() {
  history_.forget_after(*session_);
  seek_.reset();
}

std::optional<ScrubBar> Player::scrub_bar_now() const {
  const UserInterface::Size size = interface_.size();
  if (!session_->paused() || !history_.possible() || size.rows < kLeastRowsForBar ||
      history_.last() <= history_.first())
    return std::nullopt;
  return ScrubBar{history_.first(), seek_.value_or(session_->simulation().time()), history_.last(),
                  history_.bytes()};
}

}  // namespace carom
