#pragma once

#include "solvers/event/loop_core.hpp"

namespace carom::event {

template <class P>
void LoopCore<P>::add(const Ball& ball) {
  land();
  balls_.push_back(ball);
  flights_.push_back(flight_of(ball));
  spins_.push_back(ball.fixed ? 0 : with_plain_zero(ball.spin));
  for (auto& turns : turns_before_) {
    if (!turns.empty()) turns.push_back(0);
  }
  start();
}

template <class P>
void LoopCore<P>::remove(std::size_t ball) {
  std::vector<char> rested(slot_.size(), 0);
  for (std::size_t i = 0; i < slot_.size() && log_.wanted && !domains_; ++i) {
    rested[i] = motion().support(flight(i)) == kResting ? 1 : 0;
  }
  if (loop_) loop_->wake_around(slot_[ball], now_.ticks);
  if (groups_) groups_->wake_around(ball, now_.ticks);
  land();
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    if (i == ball || rested[i] == 0 || supports_[i] == kResting) continue;
    tell_wake(i < ball ? i : i - 1, flights_[i]);
  }
  balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(ball));
  flights_.erase(flights_.begin() + static_cast<std::ptrdiff_t>(ball));
  spins_.erase(spins_.begin() + static_cast<std::ptrdiff_t>(ball));
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ball));
  for (auto& turns : turns_before_) {
    if (!turns.empty()) turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(ball));
  }
  supports_.erase(supports_.begin() + static_cast<std::ptrdiff_t>(ball));
  left_outs_.erase(left_outs_.begin() + static_cast<std::ptrdiff_t>(ball));
  for (Index& left : left_) {
    if (left == kUnknown || left < ball) continue;
    left = left == ball ? kUnknown : left - 1;
  }
  start();
}

// Flights start again, too, where what carries balls at rest comes or goes, or its friction
// changes.
template <class P>
void LoopCore<P>::set(const Domain& domain, const Effects& effects, bool bends) {
  const auto has_friction = [](const Effects& of) {
    return of.friction ? std::pair(of.friction->balls, of.friction->walls) : std::pair(0.0, 0.0);
  };
  const auto lies = [this] {
    for (std::size_t i = 0; i < slot_.size(); ++i) {
      if (motion().support(flight(i)) != 0) return true;
    }
    return false;
  };
  bends = bends || (rests_ && (has_walls(effects) != has_walls(effects_) ||
                               has_collisions(effects) != has_collisions(effects_) ||
                               (has_friction(effects) != has_friction(effects_) && lies())));
  const Turns with_present = bends ? turns(true) : Turns{};
  land();
  if (bends) {
    turns_before_ = with_present;
    for (std::size_t i = 0; i < slot_.size() && log_.wanted; ++i) {
      tell_slides(i, noted_);
      if (motion().support(flights_[i]) == kResting) tell_wake(i, flights_[i]);
    }
    for (Disk& disk : flights_) {
      const auto i = static_cast<std::size_t>(&disk - flights_.data());
      if (disk.start != P::Clock::ever()) motion().carry(disk, now_.ticks, &spins_[i]);
    }
    std::fill(left_.begin(), left_.end(), kUnknown);
    std::fill(supports_.begin(), supports_.end(), 0U);
    std::fill(left_outs_.begin(), left_outs_.end(), 0.0);
  }
  domain_ = domain;
  effects_ = effects;
  start();
}

}  // namespace carom::event
