#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "solvers/event/loop_core.hpp"
#include "solvers/event/suits_domains.hpp"

namespace carom::event {

inline constexpr std::uint64_t kSortAfter = 100;      // impacts of each ball
inline constexpr int kStepsOfTurn = 8;                // of contact islands, by one worker
inline constexpr std::size_t kContactsToShare = 100;  // beside those of the largest island

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
  if (loop_ && start.from.jam && !start.from.flights.empty()) {
    loop_->jam_watch().restore(*start.from.jam);
  }
}

template <class P>
auto LoopCore<P>::moment(const S& seconds) const -> Moment {
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
  } else if (phase == ConflictGroups<P>::kPairs) {  // of one loop only where steps are shared
    for (std::size_t k = taken_++; k < loop_->islands(); k = taken_++) loop_->solve_island(k);
  } else if (share.index == turn_ % share.count) {
    advance();
  }
}

template <class P>
std::size_t LoopCore<P>::finish_phase(std::size_t phase) {
  if constexpr (kShares) {
    if (domains_) return finish_domains(phase);
  }
  if (groups_) return finish_way(*groups_, phase);
  if (std::exchange(hands_on_, false)) {
    ++turn_;
    return ConflictGroups<P>::kResolve;
  }
  if (!stepping_) return Phase::kFrameDone;
  return phase == ConflictGroups<P>::kPairs ? ConflictGroups<P>::kResolve
                                            : ConflictGroups<P>::kPairs;
}

template <class P>
std::size_t LoopCore<P>::aim(double time) {
  const Moment wanted = moment(time);
  if (wanted.epoch < now_.epoch || (wanted.epoch == now_.epoch && wanted.ticks <= now_.ticks)) {
    return Phase::kFrameDone;
  }
  target_ = wanted;
  if (wanted.epoch != now_.epoch && all_is_still()) {
    land();
    go_on_to(wanted);
    start();
    return Phase::kFrameDone;
  }
  if constexpr (kShares) {
    if (domains_) return aim_way(*domains_);
  }
  if (groups_) return aim_way(*groups_);
  ++turn_;
  return effects_.collisions ? ConflictGroups<P>::kResolve : ConflictGroups<P>::kFly;
}

template <class P>
void LoopCore<P>::set_workers(std::size_t workers) {
  if (workers == workers_) return;
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
  if (std::exchange(stepping_, false)) loop_->end_step();
  const bool takes_turns = workers_ > 1 && effects_.collisions;
  for (int steps = 0;;) {
    const bool last = now_.epoch == target_.epoch;
    while (loop_->advance_to_step(last ? target_.ticks : P::Clock::epoch())) {
      if (takes_turns && steps++ == kStepsOfTurn) {
        hands_on_ = true;
        return;
      }
      loop_->begin_step();
      if (shares_step()) {
        stepping_ = true;
        taken_ = 0;
        return;
      }
      for (std::size_t k = 0; k < loop_->islands(); ++k) loop_->solve_island(k);
      loop_->end_step();
    }
    if (last) break;
    collect_log();
    loop_->rebase(P::Clock::epoch());
    now_ = {now_.epoch + 1, 0};
  }
  now_ = target_;
  sort_again();
}

// To meet the other workers twice costs what some dozens of contacts do.
template <class P>
bool LoopCore<P>::shares_step() const {
  if (workers_ == 1 || !effects_.collisions) return false;
  std::size_t all = 0;
  std::size_t most = 0;
  for (std::size_t k = 0; k < loop_->islands(); ++k) {
    all += loop_->contacts(k);
    most = std::max(most, loop_->contacts(k));
  }
  return all - most > kContactsToShare;
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

template <class P>
bool LoopCore<P>::may_use_domains() const {
  return kShares && !no_domains_ && !log_.wanted &&
         suits_domains(effects_, domain_, balls_, rests_, sharing_, workers_);
}

template <class P>
std::size_t LoopCore<P>::movers() const {
  return static_cast<std::size_t>(std::count_if(
      balls_.begin(), balls_.end(), [](const carom::Ball& ball) { return !ball.fixed; }));
}

template <class P>
auto LoopCore<P>::choose_way() const -> Way {
  if (may_use_domains()) return Way::domains;
  // Where nothing takes energy and balls touch, one event loop sees what jams.
  const bool jams = rests_ && !loses_energy(effects_) && !effects_.drag;
  if (workers_ == 1 || jams) return Way::loop;
  // A heap would be solved again in every window, and for each ball that falls on it.
  const bool heaps = rests_ && effects_.gravity && balls_.size() >= sharing_.balls_of_one_loop;
  // But where each ball that moves has a worker, that flies it.
  return heaps && workers_ < movers() ? Way::loop : Way::groups;
}

}  // namespace carom::event
