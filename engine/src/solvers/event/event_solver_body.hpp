#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <thread>
#include <utility>

#include "carom/scene_file.hpp"
#include "solvers/event/event_solver.hpp"
#include "solvers/event/saved_flight.hpp"
#include "solvers/sampling.hpp"
#include "state/balls.hpp"
#include "state/totals.hpp"

namespace carom {
namespace event {

inline constexpr double kRoomForSpeed = 4;  // of the light balls of a mixture, in thermal speeds
inline constexpr std::size_t kManyBalls = 4000;   // from here on their order in memory matters
inline constexpr std::size_t kFewWorkers = 16;    // for more, meeting costs more than sharing
inline constexpr std::uint64_t kSortAfter = 100;  // impacts of each ball

inline constexpr double kSamePlace = 0x1p-30;  // of the box: more than rounding can move a ball

inline std::array<double, 2> gravity_of(const Effects& effects) {
  if (!effects.gravity) return {0, 0};
  return {effects.gravity->acceleration.x(), effects.gravity->acceleration.y()};
}

}  // namespace event

template <class P>
EventSolver<P>::EventSolver(const Scene& scene, std::vector<Ball> balls, const Choice& choice)
    : domain_(scene.box, has_walls(scene.effects)),
      effects_(scene.effects),
      balls_(std::move(balls)),
      choice_(choice) {
  if (choice_.parts == 0) {
    const std::size_t workers = worker_count(scene, balls_.size());
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    choice_.parts = workers > event::kFewWorkers ? 1 : std::min(workers, cores);
  }
  for (Ball& ball : balls_) {
    if (ball.fixed) ball.velocity = {0, 0};
  }
  const bool goes_on = scene.continuation && !scene.continuation->flights.empty();
  scale_ = goes_on ? P::Clock::of_tick(*scene.continuation->tick) : fitting_scale();
  if (scene.continuation) now_ = moment(scene.continuation->time);
  target_ = now_;
  if (goes_on) {
    take_flights(scene);
    start();
    refuse_other_places(scene);
    return;
  }
  for (const Ball& ball : balls_) flights_.push_back(flight_of(ball));
  start();
}

template <class P>
void EventSolver<P>::take_flights(const Scene& scene) {
  const std::vector<SavedFlight>& flights = scene.continuation->flights;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    flights_.push_back(event::restored<P>(flights[i]));
    const auto& left = flights[i].left;
    left_.push_back(left ? static_cast<event::Index>(*left) : event::kUnknown);
    carried_.push_back(P::kRests ? flights[i].carried : 0);
    const auto& start = flights_.back().start;
    const auto earliest = -P::Clock::longest_flight();
    if (balls_[i].fixed || (start <= now_.ticks && start >= earliest)) continue;
    throw SceneError(scene.source, {{fmt::format("/continuation/flights/{}/start", i),
                                     fmt::format("must be from {} to {}, the present of its clock, "
                                                 "got {}",
                                                 event::text_of(earliest),
                                                 event::text_of(now_.ticks), flights[i].start)}});
  }
}

// A ball may have been moved by hand: its flight would win without a word.
template <class P>
void EventSolver<P>::refuse_other_places(const Scene& scene) const {
  const std::vector<Ball> balls = state();
  const event::Motion<P>& motion = this->motion();
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec2& said = scene.balls[i].position;
    const Vec2& is = balls[i].position;
    const event::Vec<S> off = motion.way({S(said.x()), S(said.y())}, {S(is.x()), S(is.y())});
    const double width = domain_.upper[0] - domain_.lower[0];
    const double height = domain_.upper[1] - domain_.lower[1];
    if (event::absolute(off.x) <= event::kSamePlace * width &&
        event::absolute(off.y) <= event::kSamePlace * height) {
      continue;
    }
    throw SceneError(
        scene.source,
        {{fmt::format("/balls/{}/position", i),
          fmt::format("is not where /continuation/flights/{} has the ball, ({}, {}): leave "
                      "\"flights\" out to go on from the positions",
                      i, is.x(), is.y())}});
  }
}

template <class P>
auto EventSolver<P>::flight_of(const Ball& ball) const -> Disk {
  const event::Room<S> room(domain_);
  Disk disk;
  disk.x = room.wrapped(0, ball.position.x());
  disk.y = room.wrapped(1, ball.position.y());
  disk.vx = ball.fixed ? 0 : ball.velocity.x();
  disk.vy = ball.fixed ? 0 : ball.velocity.y();
  if constexpr (P::kSpins) disk.spin = ball.fixed ? 0 : ball.spin;
  disk.start = now_.ticks;
  return disk;
}

template <class P>
auto EventSolver<P>::moment(double seconds) const -> Moment {
  using std::floor;
  const S length = static_cast<S>(P::Clock::era());
  const S ticks = seconds * scale_.per_second();
  const S era = floor(S(ticks / length));
  return {static_cast<double>(era), P::Clock::whole(ticks - era * length)};
}

// From the fastest ball, what falling across the box adds, and the speed that the lightest ball
// gets when all share the energy.
template <class P>
typename P::Clock EventSolver<P>::fitting_scale() const {
  const double width = domain_.upper[0] - domain_.lower[0];
  const double height = domain_.upper[1] - domain_.lower[1];
  double square = 0;
  double energy = 0;
  double lightest = 0;
  std::size_t moving = 0;
  for (const Ball& ball : balls_) {
    if (ball.fixed) continue;
    const double speed_square = ball.velocity.squaredNorm();
    square = std::max(square, speed_square);
    energy += ball.mass * speed_square / 2;
    lightest = moving == 0 ? ball.mass : std::min(lightest, ball.mass);
    ++moving;
  }
  const auto [gx, gy] = event::gravity_of(effects_);
  double speed = std::sqrt(square) + std::sqrt(std::abs(gx) * width + std::abs(gy) * height);
  if (moving > 0) {
    const double share = energy / static_cast<double>(moving);
    speed = std::max(speed, event::kRoomForSpeed * std::sqrt(share / lightest));
  }
  return typename P::Clock(speed > 0 ? std::min(width, height) / speed : 1);
}

template <class P>
std::vector<Phase> EventSolver<P>::phases() {
  if constexpr (kShares) {
    if (windows_) return phases_of_windows();
  }
  choice_.parts = 1;
  return {{"impacts",
           [this](Share share) {
             if (share.index == 0) advance();
           },
           [] { return Phase::kFrameDone; }}};
}

template <class P>
std::vector<Phase> EventSolver<P>::phases_of_windows() requires kShares {
  std::vector<Phase> phases;
  for (const char* name : {"islands", "halos", "impacts", "check", "undo"}) {
    const std::size_t number = phases.size();
    phases.push_back({name,
                      [this, number](Share share) {
                        if (sharing_) {
                          windows_->work(number, share);
                        } else if (share.index == 0) {
                          advance();
                        }
                      },
                      [this, number] { return finish(number); }});
  }
  return phases;
}

template <class P>
std::size_t EventSolver<P>::aim(double time) {
  const Moment wanted = moment(time);
  if (wanted.era < now_.era || (wanted.era == now_.era && wanted.ticks <= now_.ticks)) {
    return Phase::kFrameDone;
  }
  target_ = wanted;
  if constexpr (kShares) {
    sharing_ = windows_ != nullptr;
    if (sharing_) return aim_windows();
  }
  if (choice_.parts > 1) return event::Windows<P>::kImpacts;
  return 0;
}

template <class P>
void EventSolver<P>::advance() {
  while (now_.era < target_.era) {
    tile_->advance_to(P::Clock::era());
    if (tile_->settles()) break;
    tile_->rebase(P::Clock::era());
    now_ = {now_.era + 1, 0};
  }
  if (!tile_->settles()) tile_->advance_to(target_.ticks);
  if (tile_->settles()) {
    now_.ticks = tile_->reached();
    return;
  }
  now_ = target_;
  sort_again();
}

template <class P>
void EventSolver<P>::sort_again() {
  const std::uint64_t impacts = counts().ball_ball + counts().ball_wall;
  if (balls_.size() >= event::kManyBalls && impacts > event::kSortAfter * balls_.size()) {
    land();
    one_tile_ = false;
    start();
  }
}

/// Whether the balls are many enough, and nothing comes to rest or is left at a fixed ball.
template <class P>
bool EventSolver<P>::shares(const event::BasicRules<S>& rules) const {
  if (choice_.parts < 2 || one_tile_ || !kShares) return false;
  if (balls_.size() < choice_.least_balls || !effects_.collisions) return false;
  // Parts do not count turns.
  if (event::can_rest(rules) || rules.falls_round(0) || rules.falls_round(1)) return false;
  return !P::Law::kBends ||
         std::none_of(balls_.begin(), balls_.end(), [](const Ball& ball) { return ball.fixed; });
}

template <class P>
std::size_t EventSolver<P>::aim_windows() requires kShares {
  return windows_->aim(now_.era < target_.era ? P::Clock::era() : target_.ticks);
}

template <class P>
std::size_t EventSolver<P>::finish(std::size_t phase) requires kShares {
  if (!sharing_) return Phase::kFrameDone;
  std::size_t next = windows_->finish(phase);
  while (next == Phase::kFrameDone) {
    now_.ticks = windows_->now();
    if (windows_->stuck()) {
      land();
      one_tile_ = true;
      start();
      sharing_ = false;
      return event::Windows<P>::kImpacts;
    }
    if (now_.era == target_.era) {
      sort_again();
      return Phase::kFrameDone;
    }
    windows_->rebase(P::Clock::era());
    now_ = {now_.era + 1, 0};
    if (target_.ticks == 0) return Phase::kFrameDone;
    next = aim_windows();
  }
  return next;
}

template <class P>
auto EventSolver<P>::flight(std::size_t ball) const -> const Disk& {
  if constexpr (kShares) {
    if (windows_) return windows_->flight(slot_[ball]);
  }
  return tile_->disks()[slot_[ball]];
}

template <class P>
const event::Motion<P>& EventSolver<P>::motion() const {
  if constexpr (kShares) {
    if (windows_) return windows_->motion();
  }
  return tile_->motion();
}

template <class P>
const event::Counts& EventSolver<P>::counts() const {
  if constexpr (kShares) {
    if (windows_) return windows_->counts();
  }
  return tile_->counts();
}

template <class P>
event::Costs EventSolver<P>::costs() const {
  if constexpr (kShares) {
    if (windows_) return windows_->costs();
  }
  return tile_->costs();
}

template <class P>
Turns EventSolver<P>::turns(bool of_present_flights) const {
  Turns turns = turns_before_;
  if (!tile_) return turns;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (tile_->turns()[axis].empty()) {
      turns[axis].clear();
      continue;
    }
    turns[axis].resize(slot_.size(), 0);
    const S period = domain_.period[axis];
    for (std::size_t i = 0; i < slot_.size(); ++i) {
      turns[axis][i] += tile_->turns()[axis][slot_[i]];
      if (!of_present_flights || balls_[i].fixed) continue;
      const event::Vec<S> at = motion().place(flight(i), now_.ticks);
      const event::Vec<S> image = motion().wrapped(at);
      const S apart = axis == 0 ? S(at.x - image.x) : S(at.y - image.y);
      turns[axis][i] += std::llrint(static_cast<double>(S(apart / period)));
    }
  }
  return turns;
}

// Takes the flights out of the tile, into the order of the balls.
template <class P>
void EventSolver<P>::land() {
  // What a flight has gone round stays with it until it ends.
  if (tile_) turns_before_ = turns(false);
  balls_ = state();
  flights_.resize(slot_.size());
  left_.assign(slot_.size(), event::kUnknown);
  carried_.assign(slot_.size(), 0);
  std::vector<event::Index> number(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) number[slot_[i]] = static_cast<event::Index>(i);
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    flights_[i] = flight(i);
    carried_[i] = motion().carried(flights_[i]);
    const event::Index left = windows_ ? event::kUnknown : tile_->left(slot_[i]);
    if (left != event::kUnknown) left_[i] = number[left];
  }
  before_.ball_ball += counts().ball_ball;
  before_.ball_wall += counts().ball_wall;
  before_.joint_impacts += counts().joint_impacts;
  before_.resting_contacts += counts().resting_contacts;
  before_.max_overlap = std::max(before_.max_overlap, counts().max_overlap);
  costs_before_ += costs();
  if constexpr (kShares) {
    if (windows_) again_ += windows_->solved_again();
  }
}

// Neighbours in the plane are put next to each other in memory: no result depends on it.
template <class P>
void EventSolver<P>::sort_by_place() {
  const std::size_t n = balls_.size();
  std::vector<event::Index> order(n);
  std::iota(order.begin(), order.end(), 0U);
  if (n >= event::kManyBalls) {
    const double area =
        (domain_.upper[0] - domain_.lower[0]) * (domain_.upper[1] - domain_.lower[1]);
    const double block = 8 * std::sqrt(area / static_cast<double>(n));
    std::vector<std::pair<double, double>> place(n);
    for (std::size_t i = 0; i < n; ++i) {
      place[i] = {std::floor(balls_[i].position.y() / block),
                  std::floor(balls_[i].position.x() / block)};
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](event::Index a, event::Index b) { return place[a] < place[b]; });
  }
  slot_.resize(n);
  for (std::size_t k = 0; k < n; ++k) slot_[order[k]] = static_cast<event::Index>(k);
}

template <class P>
void EventSolver<P>::start() {
  event::BasicRules<S> rules{domain_,
                             scale_,
                             event::gravity_of(effects_),
                             has_collisions(effects_),
                             effects_.collisions ? effects_.collisions->restitution : 1,
                             effects_.walls ? effects_.walls->restitution : 1,
                             {},
                             effects_.drag ? effects_.drag->rate : 0,
                             effects_.friction ? effects_.friction->balls : 0,
                             effects_.friction ? effects_.friction->walls : 0};
  sort_by_place();
  std::map<std::pair<S, S>, event::Index> kinds;
  std::vector<Disk> disks(balls_.size());
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const event::BasicKind<S> kind{balls_[i].radius,
                                   balls_[i].fixed ? S(0) : S(1 / S(balls_[i].mass))};
    const auto [at, added] = kinds.try_emplace({kind.radius, kind.inverse_mass},
                                               static_cast<event::Index>(rules.kinds.size()));
    if (added) rules.kinds.push_back(kind);
    flights_[i].kind = at->second;
  }
  carried_.resize(balls_.size(), 0);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    disks[slot_[i]] = flights_[i];
    disks[slot_[i]].kind += static_cast<event::Index>(carried_[i] * rules.kinds.size());
  }
  if constexpr (kShares) {
    if (shares(rules)) {
      tile_.reset();
      windows_ = std::make_unique<event::Windows<P>>(rules, choice_);
      windows_->reset(std::move(disks), now_.ticks);
      flights_.clear();
      return;
    }
  }
  windows_.reset();
  tile_ = std::make_unique<event::Tile<P>>(std::move(rules));
  left_.resize(balls_.size(), event::kUnknown);
  std::vector<event::Index> left(balls_.size(), event::kUnknown);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (left_[i] != event::kUnknown) left[slot_[i]] = slot_[left_[i]];
  }
  tile_->reset(disks, now_.ticks, left);
  flights_.clear();
}

template <class P>
void EventSolver<P>::add(const Ball& ball) {
  land();
  balls_.push_back(ball);
  flights_.push_back(flight_of(ball));
  for (auto& turns : turns_before_) {
    if (!turns.empty()) turns.push_back(0);
  }
  start();
}

template <class P>
void EventSolver<P>::remove(std::size_t ball) {
  if constexpr (P::kRests) tile_->wake_around(slot_[ball], now_.ticks);
  land();
  balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(ball));
  flights_.erase(flights_.begin() + static_cast<std::ptrdiff_t>(ball));
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ball));
  for (auto& turns : turns_before_) {
    if (!turns.empty()) turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(ball));
  }
  carried_.erase(carried_.begin() + static_cast<std::ptrdiff_t>(ball));
  for (event::Index& left : left_) {
    if (left == event::kUnknown || left < ball) continue;
    left = left == ball ? event::kUnknown : left - 1;
  }
  start();
}

// A new field or drag bends the flights: they start anew where they are.  So they do where what
// carries balls at rest comes or goes.
template <class P>
void EventSolver<P>::set(const Effects& effects) {
  const bool carries_otherwise =
      P::kRests && ((effects.walls && effects.walls->on != has_walls(effects_)) ||
                    (effects.collisions && effects.collisions->on != has_collisions(effects_)));
  const bool bends = effects.gravity || effects.drag || carries_otherwise;
  const Turns with_present = bends ? turns(true) : Turns{};
  land();
  if (effects.walls) {
    effects_.walls = effects.walls;
    for (Domain::Sides& sides : domain_.sides) {
      if (sides == Domain::Sides::periodic) continue;
      sides = has_walls(effects_) ? Domain::Sides::walls : Domain::Sides::open;
    }
  }
  if (effects.collisions) effects_.collisions = effects.collisions;
  if (effects.friction) effects_.friction = effects.friction;
  if (bends) {
    turns_before_ = with_present;
    for (Disk& disk : flights_) {
      if (disk.start != P::Clock::ever()) motion().carry(disk, now_.ticks);
    }
    std::fill(left_.begin(), left_.end(), event::kUnknown);
    std::fill(carried_.begin(), carried_.end(), 0U);
    if (effects.gravity) effects_.gravity = effects.gravity;
    if (effects.drag) effects_.drag = effects.drag;
  }
  start();
}

template <class P>
std::vector<Ball> EventSolver<P>::state() const {
  std::vector<Ball> result = balls_;
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    if (result[i].fixed) continue;
    const Disk& disk = flight(i);
    const auto at = motion().wrapped(motion().place(disk, now_.ticks));
    const auto v = motion().velocity(disk, now_.ticks);
    result[i].position = {static_cast<double>(at.x), static_cast<double>(at.y)};
    result[i].velocity = {static_cast<double>(v.x), static_cast<double>(v.y)};
    if constexpr (P::kSpins) result[i].spin = static_cast<double>(disk.spin);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain_.solid(axis)) continue;
      double& x = result[i].position[static_cast<Eigen::Index>(axis)];
      x = std::clamp(x, domain_.lowest(axis, result[i].radius),
                     domain_.highest(axis, result[i].radius));
    }
  }
  return result;
}

template <class P>
std::vector<ExactPosition> EventSolver<P>::exact_positions() const {
  const auto parts = [](S rest) {
    std::vector<double> result;
    do {
      result.push_back(static_cast<double>(rest));
      rest -= result.back();
    } while (rest != 0);
    return result;
  };
  const event::Motion<P>& motion = this->motion();
  std::vector<ExactPosition> result(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    const auto at = motion.wrapped(motion.place(flight(i), now_.ticks));
    result[i] = {parts(at.x), parts(at.y)};
  }
  return result;
}

template <class P>
std::string EventSolver<P>::state_hash() const {
  return carom::state_hash(Balls(state(), effects_));
}

template <class P>
double EventSolver<P>::energy() const {
  const Balls balls(state(), effects_);
  const auto [gx, gy] = event::gravity_of(effects_);
  const double spins = effects_.friction ? spin_energy(balls) : 0;
  double ahead = 0;
  if constexpr (P::kRests) ahead = tile_->given_ahead(now_.ticks);
  return kinetic_energy(balls) + spins - ahead +
         potential_energy(balls, {gx, gy}, {domain_.period[0], domain_.period[1]}, turns(true));
}

template <class P>
Vec2 EventSolver<P>::momentum() const {
  return carom::momentum(Balls(state()));
}

template <class P>
void EventSolver<P>::count(Measurements& measurements) const {
  measurements.ball_ball += before_.ball_ball + counts().ball_ball;
  measurements.ball_wall += before_.ball_wall + counts().ball_wall;
  measurements.joint_impacts += before_.joint_impacts + counts().joint_impacts;
  measurements.resting_contacts += before_.resting_contacts + counts().resting_contacts;
  measurements.max_overlap =
      std::max({measurements.max_overlap, before_.max_overlap, counts().max_overlap});
  measurements.islands_again += again_;
  if constexpr (kShares) {
    if (windows_) measurements.islands_again += windows_->solved_again();
  }
  event::Costs costs = costs_before_;
  costs += this->costs();
  EffectSeconds seconds;
  seconds.of<Collisions>() = costs.collisions;
  seconds.of<Walls>() = costs.walls;
  seconds.of<Friction>() = costs.friction;
  // Where both bend the flights it is by one formula.
  const double parts = effects_.gravity && effects_.drag ? 2 : 1;
  seconds.of<Gravity>() = costs.bending / parts;
  seconds.of<Drag>() = costs.bending / parts;
  add_seconds(effects_, seconds, measurements);
}

template <class P>
void EventSolver<P>::save(Scene& scene) const {
  Continuation& continuation = *scene.continuation;
  scene.solver.method = Method::event;
  continuation.step_origin = continuation.time;
  continuation.tick = static_cast<double>(scale_.tick());
  continuation.rests = P::kRests;
  std::vector<std::size_t> number(slot_.size());
  for (std::size_t i = 0; i < slot_.size(); ++i) number[slot_[i]] = i;
  for (std::size_t i = 0; i < slot_.size(); ++i) {
    continuation.flights.push_back(event::saved<P>(flight(i)));
    continuation.flights.back().carried = motion().carried(flight(i));
    const event::Index left = windows_ ? event::kUnknown : tile_->left(slot_[i]);
    if (left != event::kUnknown) continuation.flights.back().left = number[left];
  }
}

}  // namespace carom
