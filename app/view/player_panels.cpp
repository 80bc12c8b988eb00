// What is shown beside the balls and over them: trails, arrows, numbers, instruments, threads.
#include "view/player.hpp"

namespace carom {

/// A frame was computed.
void Player::note_frame(Instant now) {
  Simulation& simulation = session_->simulation();
  if (trails_.shown()) trails_.add(simulation.frame());
  if (instruments_.open()) instruments_.measure(simulation, history_.measured(*session_));
  if (single_ == 0) threads_.computed(simulation, calls_, now);
}

void Player::toggle_trails() {
  trails_.show(!trails_.shown());
  if (trails_.shown()) trails_.add(session_->simulation().frame());
  say(trails_.shown() ? "trails show where the balls were" : "trails off");
}

void Player::toggle_arrows() {
  arrows_shown_ = !arrows_shown_;
  say(arrows_shown_ ? "arrows show velocities" : "arrows off");
}

void Player::toggle_numbers() {
  numbers_shown_ = !numbers_shown_;
  say(numbers_shown_ ? "numbers on balls that are wide enough" : "numbers off");
}

void Player::toggle_instruments() {
  if (instruments_.open()) {
    instruments_.close(session_->simulation());
    return say("panel closed");
  }
  threads_first_ = false;
  instruments_.open(session_->simulation(), history_.measured(*session_));
  const UserInterface::Size size = interface_.size();
  say(docks(size.columns, size.rows - lines_below(size.rows)).instruments.empty()
          ? "the screen is too small for the instruments"
          : "instruments: averages of the last 10 simulated seconds");
}

void Player::toggle_threads() {
  if (threads_.open()) {
    threads_.close(session_->simulation());
    return say("panel closed");
  }
  threads_first_ = true;
  threads_.open(session_->simulation());
  const UserInterface::Size size = interface_.size();
  say(docks(size.columns, size.rows - lines_below(size.rows)).threads.empty()
          ? "the screen is too small for the threads' panel"
          : "threads: L goes from barrier to barrier");
}

void Player::toggle_slow_motion() {
  if (threads_.slow()) {
    threads_.set_slow(false);
    return say("slow motion ends: space goes on");
  }
  if (!threads_.open()) threads_.open(session_->simulation());
  if (!session_->paused()) session_->apply(command::Pause{});
  threads_.set_slow(true);
  threads_first_ = true;
  say("slow motion: . goes to the next barrier");
}

/// From the last barrier of a frame to the first of the next one, which is computed first.
void Player::next_barrier() {
  notice_.clear();
  if (threads_.pass_barrier()) return;
  threads_.begin_frame(session_->simulation());
  single_ += ThreadsWatch::slow_frame(session_->simulation(), frame_seconds());
}

}  // namespace carom
