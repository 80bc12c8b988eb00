#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "carom/scene_file.hpp"
#include "solvers/event/loop_core.hpp"
#include "solvers/event/saved_flight.hpp"
#include "state/totals.hpp"

namespace carom::event {

// From balls, or saved flights, to an event loop, domains or conflict groups, and back.

template <class P>
void LoopCore<P>::take_flights(const Continuation& from, const std::string& source) {
  const std::vector<SavedFlight>& flights = from.flights;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    flights_.push_back(restored<P>(flights[i]));
    const auto& left = flights[i].left;
    left_.push_back(left ? static_cast<Index>(*left) : kUnknown);
    supports_.push_back(rests_ ? flights[i].support : 0);
    left_outs_.push_back(flights[i].left_out);
    spins_.push_back(effects_.friction ? number_of<S>(flights[i].spin) : S(0));
    const auto& start = flights_.back().start;
    const auto earliest = -P::Clock::longest_flight();
    if (balls_[i].fixed || (start <= now_.ticks && start >= earliest)) continue;
    throw SceneError(source,
                     {{fmt::format("/continuation/flights/{}/start", i),
                       fmt::format("must be from {} to {}, the present of its clock, "
                                   "got {}",
                                   text_of(earliest), text_of(now_.ticks), flights[i].start)}});
  }
}

template <class P>
auto LoopCore<P>::flight_of(const Ball& ball) const -> Disk {
  const SolverBox<S> room(domain_);
  Disk disk;
  const auto at = room.wrapped({S(ball.position.x()), S(ball.position.y())});
  disk.x = with_plain_zero(at.x);
  disk.y = with_plain_zero(at.y);
  disk.vx = ball.fixed ? 0 : with_plain_zero(ball.velocity.x());
  disk.vy = ball.fixed ? 0 : with_plain_zero(ball.velocity.y());
  disk.start = now_.ticks;
  return disk;
}

// Takes the flights out of the event loop, into the order of the balls.
template <class P>
void LoopCore<P>::land() {
  collect_log();
  was_still_ = all_is_still();
  // What a flight has gone round stays with it until it ends.
  if (loop_ || groups_) turns_before_ = turns(false);
  read_balls(balls_);
  flights_.resize(slot_.size());
  left_.assign(slot_.size(), kUnknown);
  supports_.assign(slot_.size(), 0);
  left_outs_.assign(slot_.size(), 0);
  std::vector<Index> number(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) number[slot_[i]] = static_cast<Index>(i);
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    flights_[i] = flight(i);
    supports_[i] = motion().support(flights_[i]);
    left_outs_[i] = left_out(i);
    const Index left = this->left(i);
    if (left != kUnknown) left_[i] = number[left];
    if (const auto spin = this->spin(i)) spins_[i] = *spin;
  }
  before_.ball_ball += counts().ball_ball;
  before_.ball_wall += counts().ball_wall;
  before_.joint_impacts += counts().joint_impacts;
  before_.jammed += counts().jammed;
  before_.resting_contacts += counts().resting_contacts;
  before_.max_overlap = std::max(before_.max_overlap, counts().max_overlap);
  costs_before_ += costs();
  lost_before_ = lost();
  lost_before_.add(present_losses());
  if constexpr (kShares) {
    if (domains_) again_ += domains_->solved_again();
  }
}

template <class P>
bool LoopCore<P>::all_is_still() const {
  if (gravity_of(effects_) != std::array<double, 2>{0, 0}) return false;
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    const Disk disk = flight(i);
    if (disk.vx != 0 || disk.vy != 0) return false;
  }
  return true;
}

template <class P>
void LoopCore<P>::go_on_to(const Moment& moment) {
  was_still_ = false;
  now_ = moment;
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    if (!balls_[i].fixed) flights_[i].start = now_.ticks;
  }
}

template <class P>
void LoopCore<P>::take_clock() {
  const S epochs = static_cast<S>(P::Clock::epoch()) * now_.epoch;
  const S seconds = scale_.seconds(now_.ticks) + epochs * scale_.tick();
  scale_ = typename P::Clock(crossing_time(domain_, effects_, balls_));
  go_on_to(moment(seconds));
}

template <class P>
void LoopCore<P>::start() {
  if (was_still_) take_clock();
  BasicRules<S> rules{domain_,
                      scale_,
                      gravity_of(effects_),
                      has_collisions(effects_),
                      effects_.collisions ? effects_.collisions->restitution : 1,
                      effects_.walls ? effects_.walls->restitution : 1,
                      {},
                      effects_.drag ? effects_.drag->rate : 0,
                      effects_.friction ? effects_.friction->balls : 0,
                      effects_.friction ? effects_.friction->walls : 0,
                      effects_.gravity.has_value(),
                      effects_.friction.has_value(),
                      rests_,
                      movers()};
  const Way way = choose_way();
  if (way == Way::loop) {
    slot_ = places_in_memory(domain_, balls_);
  } else {
    slot_.resize(balls_.size());
    std::iota(slot_.begin(), slot_.end(), 0U);
  }
  std::map<std::pair<S, S>, Index> all_species;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const BasicSpecies<S> species{balls_[i].radius,
                                  balls_[i].fixed ? S(0) : S(1 / S(balls_[i].mass))};
    const auto [at, added] = all_species.try_emplace({species.radius, species.inverse_mass},
                                                     static_cast<Index>(rules.all_species.size()));
    if (added) rules.all_species.push_back(species);
    flights_[i].species = at->second;
  }
  supports_.resize(balls_.size(), 0);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    flights_[i].species += static_cast<Index>(supports_[i] * rules.all_species.size());
  }
  std::vector<Disk> disks;
  if (way == Way::loop) {
    disks.resize(balls_.size());
    for (std::size_t i = 0; i < balls_.size(); ++i) disks[slot_[i]] = flights_[i];
  } else {
    disks = std::move(flights_);
  }
  loop_.reset();
  groups_.reset();
  domains_.reset();
  flights_ = std::vector<Disk>();  // not beside those of the event loop
  if constexpr (kShares) {
    if (way == Way::domains) {
      domains_ = std::make_unique<Domains<P>>(rules);
      domains_->set_workers(workers_);
      domains_->reset(disks, now_.ticks, effects_.friction ? spins_ : std::vector<S>{}, left_);
      flights_.clear();
      domains_began_ = now_;
      if (rules.only_drag_takes()) {
        std::vector<Ball> balls = balls_;
        read_balls(balls);
        domains_energy_ = kinetic_energy(Balls(balls));
      } else {
        leave_out_present_losses();
      }
      return;
    }
  }
  left_.resize(balls_.size(), kUnknown);
  if (way == Way::groups) {
    groups_ = std::make_unique<ConflictGroups<P>>(rules);
    groups_->set_workers(workers_);
    groups_->note_impacts(log_.wanted);
    groups_->reset(disks, now_.ticks, left_, effects_.friction ? spins_ : std::vector<S>{});
    flights_.clear();
    leave_out_present_losses();
    return;
  }
  loop_ = std::make_unique<EventLoop<P>>(std::move(rules));
  std::vector<Index> left(balls_.size(), kUnknown);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (left_[i] != kUnknown) left[slot_[i]] = slot_[left_[i]];
  }
  std::vector<S> spins;
  if (effects_.friction) {
    spins.resize(balls_.size());
    for (std::size_t i = 0; i < balls_.size(); ++i) spins[slot_[i]] = spins_[i];
  }
  left_outs_.resize(balls_.size(), 0);
  std::vector<double> left_outs(balls_.size());
  for (std::size_t i = 0; i < balls_.size(); ++i) left_outs[slot_[i]] = left_outs_[i];
  loop_->reset(disks, now_.ticks, left, spins, left_outs);
  if (log_.wanted) loop_->note_in(&log_);
  flights_.clear();
  leave_out_present_losses();
}

// What these flights have lost before the present is counted when they end.
template <class P>
void LoopCore<P>::leave_out_present_losses() {
  lost_before_.add(-present_losses());
}

}  // namespace carom::event
