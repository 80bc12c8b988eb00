#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "solvers/event/loop_core.hpp"
#include "solvers/event/saved_flight.hpp"

namespace carom::event {

template <class P>
auto LoopCore<P>::flight(std::size_t ball) const -> Disk {
  if constexpr (kShares) {
    if (domains_) return domains_->flight(ball);
  }
  if (groups_) return groups_->flight(ball);
  return loop_->disks()[slot_[ball]];
}

template <class P>
auto LoopCore<P>::spin(std::size_t ball) const -> std::optional<S> {
  if (!effects_.friction) return std::nullopt;
  if constexpr (kShares) {
    if (domains_) return domains_->spin(ball);
  }
  return groups_ ? groups_->spin(ball) : loop_->spins()[slot_[ball]];
}

template <class P>
Index LoopCore<P>::left(std::size_t ball) const {
  if constexpr (kShares) {
    if (domains_) return domains_->left(ball);
  }
  return groups_ ? groups_->left(ball) : loop_->left(slot_[ball]);
}

// Where nothing takes energy one event loop has all balls.
template <class P>
double LoopCore<P>::left_out(std::size_t ball) const {
  return loop_ ? loop_->left_out(slot_[ball]) : 0;
}

template <class P>
const Motion<P>& LoopCore<P>::motion() const {
  if constexpr (kShares) {
    if (domains_) return domains_->motion();
  }
  return groups_ ? groups_->motion() : loop_->motion();
}

template <class P>
Counts LoopCore<P>::counts() const {
  if constexpr (kShares) {
    if (domains_) return domains_->counts();
  }
  return groups_ ? groups_->counts() : loop_->counts();
}

template <class P>
Costs LoopCore<P>::costs() const {
  if constexpr (kShares) {
    if (domains_) return domains_->costs();
  }
  return groups_ ? groups_->costs() : loop_->costs();
}

template <class P>
Turns LoopCore<P>::turns(bool of_present_flights) const {
  Turns turns = turns_before_;
  if (!loop_ && !groups_) return turns;
  const Turns& since = groups_ ? groups_->turns() : loop_->turns();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (since[axis].empty()) {
      turns[axis].clear();
      continue;
    }
    turns[axis].resize(slot_.size(), 0);
    const S period = domain_.period[axis];
    for (std::size_t i = 0; i < slot_.size(); ++i) {
      turns[axis][i] += since[axis][slot_[i]];
      if (!of_present_flights || balls_[i].fixed) continue;
      const Vec<S> at = motion().place(flight(i), now_.ticks);
      const Vec<S> image = motion().wrapped(at);
      const S apart = axis == 0 ? S(at.x - image.x) : S(at.y - image.y);
      turns[axis][i] += std::llrint(static_cast<double>(S(apart / period)));
    }
  }
  return turns;
}

template <class P>
void LoopCore<P>::read_balls(std::size_t first, std::span<Ball> balls) const {
  constexpr std::size_t kBallsAhead = 16;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if constexpr (kShares) {
      if (domains_ && k + kBallsAhead < balls.size()) domains_->fetch(first + k + kBallsAhead);
    }
    Ball& ball = balls[k];
    if (ball.fixed) continue;
    const Disk disk = flight(first + k);
    const auto at = motion().wrapped(motion().place(disk, now_.ticks));
    const auto v = motion().velocity(disk, now_.ticks);
    ball.position = {static_cast<double>(at.x), static_cast<double>(at.y)};
    ball.velocity = {static_cast<double>(v.x), static_cast<double>(v.y)};
    if (const auto spin = this->spin(first + k)) {
      ball.spin = static_cast<double>(motion().spin_at(disk, *spin, now_.ticks));
    }
  }
}

template <class P>
std::vector<ExactPosition> LoopCore<P>::exact_positions() const {
  const auto parts = [](S rest) {
    std::vector<double> result;
    do {
      result.push_back(static_cast<double>(rest));
      rest -= result.back();
    } while (rest != 0);
    return result;
  };
  const Motion<P>& motion = this->motion();
  std::vector<ExactPosition> result(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    const auto at = motion.wrapped(motion.place(flight(i), now_.ticks));
    result[i] = {parts(at.x), parts(at.y)};
  }
  return result;
}

template <class P>
Tally LoopCore<P>::tally() const {
  Tally tally;
  tally.ball_ball = before_.ball_ball + counts().ball_ball;
  tally.ball_wall = before_.ball_wall + counts().ball_wall;
  tally.joint_impacts = before_.joint_impacts + counts().joint_impacts;
  tally.jammed = before_.jammed + counts().jammed;
  tally.resting_contacts = before_.resting_contacts + counts().resting_contacts;
  tally.max_overlap = std::max(before_.max_overlap, counts().max_overlap);
  tally.islands_again = again_;
  if constexpr (kShares) {
    if (domains_) tally.islands_again += domains_->solved_again();
  }
  Costs costs = costs_before_;
  costs += this->costs();
  tally.collisions = costs.collisions;
  tally.walls = costs.walls;
  tally.friction = costs.friction;
  tally.bending = costs.bending;
  return tally;
}

template <class P>
void LoopCore<P>::save(Continuation& continuation) const {
  continuation.tick = static_cast<double>(scale_.tick());
  continuation.rests = rests_;
  continuation.jam.reset();
  // Other ways have no such count, and balls that lose energy hardly need it.
  if (loop_ && motion().elastic() && motion().contacts_last()) {
    loop_->jam_watch().save(continuation.jam.emplace());
  }
}

template <class P>
void LoopCore<P>::visit_flights(const std::function<void(const SavedFlight&)>& visit) const {
  std::vector<Index> number(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) number[slot_[i]] = static_cast<Index>(i);
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    const std::optional<S> spin = this->spin(i);
    SavedFlight saved = event::saved<P>(flight(i), spin ? &*spin : nullptr);
    saved.support = motion().support(flight(i));
    const Index left = this->left(i);
    if (left != kUnknown) saved.left = number[left];
    saved.left_out = left_out(i);
    visit(saved);
  }
}

}  // namespace carom::event
