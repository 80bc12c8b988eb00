#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "carom/scene_file.hpp"
#include "effects/domains_suit.hpp"
#include "solvers/event/loop_core.hpp"
#include "solvers/event/saved_flight.hpp"
#include "state/totals.hpp"

namespace carom::event {

inline constexpr std::size_t kManyBalls = 4000;   // from here on their order in memory matters
inline constexpr std::uint64_t kSortAfter = 100;  // impacts of each ball
inline constexpr double kLeastPeriod = 8;         // radii: for domains

/// A saved run goes on by its own clock, also where all its balls are gone and others are to come.
inline bool keeps_its_clock(const Continuation& from, const std::vector<Ball>& balls) {
  return !from.flights.empty() || (balls.empty() && from.tick);
}

template <class P>
LoopCore<P>::LoopCore(CoreStart start)
    : domain_(start.domain),
      effects_(start.effects),
      balls_(std::move(start.balls)),
      rests_(start.rests),
      scale_(keeps_its_clock(start.from, balls_)
                 ? P::Clock::of_tick(*start.from.tick)
                 : typename P::Clock(crossing_time(domain_, effects_, balls_))),
      sharing_(start.sharing),
      workers_(start.workers),
      now_(moment(start.from.time)),
      target_(now_) {
  flights_.reserve(balls_.size());
  spins_.reserve(balls_.size());
  if (start.from.flights.empty()) {
    for (const Ball& ball : balls_) {
      flights_.push_back(flight_of(ball));
      spins_.push_back(ball.fixed ? 0 : with_plain_zero(ball.spin));
    }
  } else {
    take_flights(start.from, start.source);
  }
  this->start();
}

template <class P>
void LoopCore<P>::take_flights(const Continuation& from, const std::string& source) {
  const std::vector<SavedFlight>& flights = from.flights;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    flights_.push_back(restored<P>(flights[i]));
    const auto& left = flights[i].left;
    left_.push_back(left ? static_cast<Index>(*left) : kUnknown);
    supports_.push_back(rests_ ? flights[i].support : 0);
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
  disk.x = with_plain_zero(room.wrapped(0, ball.position.x()));
  disk.y = with_plain_zero(room.wrapped(1, ball.position.y()));
  disk.vx = ball.fixed ? 0 : with_plain_zero(ball.velocity.x());
  disk.vy = ball.fixed ? 0 : with_plain_zero(ball.velocity.y());
  disk.start = now_.ticks;
  return disk;
}

template <class P>
auto LoopCore<P>::moment(double seconds) const -> Moment {
  using std::floor;
  const S length = static_cast<S>(P::Clock::epoch());
  const S ticks = seconds * scale_.per_second();
  const S epoch = floor(S(ticks / length));
  return {static_cast<double>(epoch), P::Clock::whole(ticks - epoch * length)};
}

template <class P>
std::vector<Phase> LoopCore<P>::phases() {
  std::vector<const char*> names{effects_.walls ? "wall_computation" : "flight"};
  if (effects_.collisions) names.insert(names.end(), {"pair_computation", "pair_resolution"});
  std::vector<Phase> phases;
  for (const char* name : names) {
    const std::size_t number = phases.size();
    phases.push_back({name, [this, number](Share share) { work(number, share); },
                      [this, number] { return finish_phase(number); }});
  }
  return phases;
}

template <class P>
void LoopCore<P>::work(std::size_t phase, Share share) {
  if constexpr (kShares) {
    if (domains_) return domains_->work(phase, share);
  }
  if (groups_) {
    groups_->work(phase, share);
  } else if (share.index == 0) {
    advance();
  }
}

template <class P>
std::size_t LoopCore<P>::finish_phase(std::size_t phase) {
  if constexpr (kShares) {
    if (domains_) return finish_domains(phase);
  }
  return groups_ ? finish_way(*groups_, phase) : Phase::kFrameDone;
}

template <class P>
std::size_t LoopCore<P>::aim(double time) {
  const Moment wanted = moment(time);
  if (wanted.epoch < now_.epoch || (wanted.epoch == now_.epoch && wanted.ticks <= now_.ticks)) {
    return Phase::kFrameDone;
  }
  target_ = wanted;
  if constexpr (kShares) {
    if (domains_) return aim_way(*domains_);
  }
  if (groups_) return aim_way(*groups_);
  return effects_.collisions ? ConflictGroups<P>::kResolve : ConflictGroups<P>::kFly;
}

template <class P>
void LoopCore<P>::set_workers(std::size_t workers) {
  const Way way = choose_way();
  workers_ = workers;
  if (way != choose_way()) {
    land();
    start();
  }
  if (groups_) groups_->set_workers(workers);
  if constexpr (kShares) {
    if (domains_) domains_->set_workers(workers);
  }
}

template <class P>
template <class Solved>
std::size_t LoopCore<P>::aim_way(Solved& way) {
  return way.aim(now_.epoch < target_.epoch ? P::Clock::epoch() : target_.ticks);
}

template <class P>
template <class Solved>
std::size_t LoopCore<P>::finish_way(Solved& way, std::size_t phase) {
  std::size_t next = way.finish(phase);
  while (next == Phase::kFrameDone) {
    now_.ticks = way.now();
    if constexpr (std::is_same_v<Solved, ConflictGroups<P>>) {
      if (log_.wanted) {
        way.take_impacts(log_.impacts);
        collect_log();
      }
    } else if (way.stuck()) {
      return next;
    }
    if (now_.epoch == target_.epoch) return Phase::kFrameDone;
    way.rebase(P::Clock::epoch());
    now_ = {now_.epoch + 1, 0};
    if (now_.epoch == target_.epoch && target_.ticks == 0) return Phase::kFrameDone;
    next = aim_way(way);
  }
  return next;
}

template <class P>
std::size_t LoopCore<P>::finish_domains(std::size_t phase) requires kShares {
  const std::size_t next = finish_way(*domains_, phase);
  if (next != Phase::kFrameDone || !domains_->stuck()) return next;
  no_domains_ = true;
  land();
  start();
  if (now_.epoch == target_.epoch && now_.ticks >= target_.ticks) return next;
  return groups_ ? aim_way(*groups_) : std::size_t{ConflictGroups<P>::kResolve};
}

template <class P>
void LoopCore<P>::advance() {
  while (now_.epoch < target_.epoch) {
    loop_->advance_to(P::Clock::epoch());
    collect_log();
    loop_->rebase(P::Clock::epoch());
    now_ = {now_.epoch + 1, 0};
  }
  loop_->advance_to(target_.ticks);
  now_ = target_;
  sort_again();
}

template <class P>
void LoopCore<P>::sort_again() {
  const std::uint64_t impacts = counts().ball_ball + counts().ball_wall;
  if (balls_.size() >= kManyBalls && impacts > kSortAfter * balls_.size()) {
    land();
    no_domains_ = false;
    start();
  }
}

/// Whether the balls are many enough, and nothing comes to rest or is left at a fixed ball.  Where
/// nothing presses balls together, contacts that last are rare: domains leave them to an event
/// loop.
template <class P>
bool LoopCore<P>::suits_domains() const {
  if (!kShares || no_domains_ || log_.wanted) return false;
  const std::size_t least = workers_ > 1 ? workers_ * sharing_.balls_of_worker : 0;
  if (balls_.size() < std::max(least, sharing_.least_balls)) return false;
  const bool fixed =
      std::any_of(balls_.begin(), balls_.end(), [](const Ball& ball) { return ball.fixed; });
  const std::array<bool, 2> periodic{domain_.period[0] > 0, domain_.period[1] > 0};
  if (!domains_suit(effects_, periodic, fixed, rests_)) return false;
  const double least_period = std::min(domain_.period[0] > 0 ? domain_.period[0] : HUGE_VAL,
                                       domain_.period[1] > 0 ? domain_.period[1] : HUGE_VAL);
  return std::none_of(balls_.begin(), balls_.end(),
                      [&](const Ball& ball) { return least_period < kLeastPeriod * ball.radius; });
}

template <class P>
auto LoopCore<P>::choose_way() const -> Way {
  if (suits_domains()) return Way::domains;
  // Where nothing takes energy and balls touch, one event loop sees what jams.
  const bool jams = rests_ && !loses_energy(effects_) && !effects_.drag;
  return workers_ > 1 && !jams ? Way::groups : Way::loop;
}

// Takes the flights out of the event loop, into the order of the balls.
template <class P>
void LoopCore<P>::land() {
  collect_log();
  // What a flight has gone round stays with it until it ends.
  if (loop_ || groups_) turns_before_ = turns(false);
  read_balls(balls_);
  flights_.resize(slot_.size());
  left_.assign(slot_.size(), kUnknown);
  supports_.assign(slot_.size(), 0);
  std::vector<Index> number(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) number[slot_[i]] = static_cast<Index>(i);
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    flights_[i] = flight(i);
    supports_[i] = motion().support(flights_[i]);
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
void LoopCore<P>::start() {
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
                      rests_};
  slot_ = places_in_memory(domain_, balls_);
  const Way way = choose_way();
  if (way != Way::loop) std::iota(slot_.begin(), slot_.end(), 0U);
  std::map<std::pair<S, S>, Index> all_species;
  std::vector<Disk> disks(balls_.size());
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
    disks[slot_[i]] = flights_[i];
    disks[slot_[i]].species += static_cast<Index>(supports_[i] * rules.all_species.size());
  }
  loop_.reset();
  groups_.reset();
  domains_.reset();
  flights_ = std::vector<Disk>();  // not beside those of the event loop
  if constexpr (kShares) {
    if (way == Way::domains) {
      domains_ = std::make_unique<Domains<P>>(rules);
      domains_->set_workers(workers_);
      domains_->reset(disks, now_.ticks, effects_.friction ? spins_ : std::vector<S>{});
      flights_.clear();
      if (effects_.drag) {
        std::vector<Ball> balls = balls_;
        read_balls(balls);
        domains_energy_ = kinetic_energy(Balls(balls));
      }
      domains_began_ = now_;
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
  loop_->reset(disks, now_.ticks, left, spins);
  if (log_.wanted) loop_->note_in(&log_);
  flights_.clear();
  // What was taken from these flights before has been counted already.
  lost_before_.add(-present_losses());
}

}  // namespace carom::event
