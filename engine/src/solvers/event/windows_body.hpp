#include "solvers/event/windows.hpp"

#pragma once

#include <algorithm>
#include <cmath>

namespace carom::event {
// Wider than any rounding of places and speeds.
inline constexpr double kWider = 1 + 0x1p-20;
// A halo is so many balls deep beyond those that can touch an owned ball.
inline constexpr double kLayers = 1.75;
// With fewer events in a window of a part, meeting costs more than sharing gains.
inline constexpr double kLeastEvents = 32;
// A window cut short makes the next ones shorter by so much, every other one longer: about one in
// ten is cut.
inline constexpr double kShorter = 0.8;
inline constexpr double kLonger = 1.01;
// A window at first, as a part of the time in which a ball meets another.
inline constexpr double kFirstWindow = 0.1;

template <class P>
Windows<P>::Windows(const Rules& rules, const Sharing& sharing)
    : motion_(rules), sharing_(sharing) {
  for (std::size_t k = 0; k < sharing.parts; ++k) {
    parts_.push_back(std::make_unique<Part<P>>(rules, k, sharing.parts));
    readers_.push_back(parts_.back().get());
  }
}

template <class P>
void Windows<P>::reset(std::vector<Disk> flights, Ticks now) {
  flights_ = std::move(flights);
  now_ = now;
  target_ = now;
  stuck_ = false;
  yield_ = 0;
  places_.clear();
  double square = 0;
  double fastest = 0;
  for (Disk& disk : flights_) {
    if (motion_.fixed(disk)) disk.start = kEver;
    places_.push_back(motion_.wrapped(motion_.place(disk, now)));
    const Vec<double> v = motion_.velocity(disk, now);
    square += v.x * v.x + v.y * v.y;
    fastest = std::max(fastest, v.x * v.x + v.y * v.y);
  }
  const auto n = static_cast<double>(flights_.size());
  const Domain& domain = motion_.rules().domain;
  const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
  pitch_ = std::sqrt(area / n);
  speed_ = std::sqrt(fastest) * kWider;
  regions_.emplace(domain, parts_.size(), places_);
  const TickScale& scale = motion_.rules().scale;
  const double diameter = 2 * motion_.largest_radius();
  const double across = std::max(pitch_ - diameter, pitch_ / 16) * pitch_ / diameter;
  const double mean = std::sqrt(square / n);
  const Ticks chosen = mean > 0 ? scale.ticks(kFirstWindow * across / mean) : kLongestFlight / 2;
  const Ticks wanted = sharing_.window > 0 ? scale.ticks(sharing_.window) : chosen;
  window_ = std::clamp<Ticks>(wanted, 1, kLongestFlight / 2);
  choose_rims();
}

template <class P>
void Windows<P>::choose_rims() {
  const double radii = 2 * motion_.largest_radius();
  travelled_ = used_;
  used_ = 0;
  shared_at_ = now_;
  const double least = kLayers * pitch_ / 2;
  const Ticks two = std::min(window_, kLongestFlight / 8) * 2;
  budget_ = std::clamp(speed_ * motion_.rules().scale.seconds(two), least,
                       std::max(least, regions_->narrowest() / 8));
  halo_ = (radii + 2 * budget_) * kWider;
}

template <class P>
std::size_t Windows<P>::aim(Ticks until) {
  target_ = until;
  if (!(until > now_)) return Phase::kFrameDone;
  return flights_.empty() ? next() : kIslands;
}

// The phase that comes next, all being done up to now.
template <class P>
std::size_t Windows<P>::next() {
  if (now_ == target_ || stuck_) return Phase::kFrameDone;
  const Ticks wanted = std::min(window_, target_ - now_);
  if (used_ > 0 && used_ + motion_.rules().scale.seconds(wanted) * speed_ > budget_) {
    choose_rims();
    return kIslands;
  }
  return begin_window();
}

template <class P>
std::size_t Windows<P>::begin_window() {
  const Ticks room =
      speed_ > 0 ? motion_.rules().scale.ticks((budget_ - used_) / speed_) : kLongestFlight;
  full_ = window_ <= target_ - now_;
  until_ = now_ + std::clamp<Ticks>(room, 1, std::min(window_, target_ - now_));
  cut_ = false;
  return kImpacts;
}

template <class P>
void Windows<P>::work(std::size_t phase, Share share) {
  for (std::size_t k = share.index; k < parts_.size(); k += share.count) {
    Part<P>& part = *parts_[k];
    switch (phase) {
      case kIslands:
        if (flights_.empty()) {
          part.offer(*regions_, halo_, travelled_, now_);
        } else {
          part.reset(*regions_, halo_, flights_, places_, now_);
        }
        break;
      case kHalos:
        part.admit(readers_, now_);
        break;
      case kImpacts:
        part.advance(now_, until_);
        break;
      case kCheck:
        part.check(readers_, speed_);
        break;
      default:
        part.undo(until_);
    }
  }
}

template <class P>
std::size_t Windows<P>::finish(std::size_t phase) {
  switch (phase) {
    case kIslands: {
      if (flights_.empty()) return kHalos;
      flights_ = {};
      places_ = {};
      return begin_window();
    }
    case kHalos:
      return begin_window();
    case kImpacts:
    case kUndo:
      note_speed();
      return kCheck;
    default:
      return judge();
  }
}

// Of all flights since the balls were shared out.
template <class P>
void Windows<P>::note_speed() {
  double square = 0;
  for (const auto& part : parts_) square = std::max(square, part->fastest_square());
  const auto& g = motion_.rules().gravity;
  speed_ = (std::sqrt(square) +
            std::hypot(g[0], g[1]) * motion_.rules().scale.seconds(until_ - shared_at_)) *
           kWider;
}

// Accepts the window, or cuts it short.
template <class P>
std::size_t Windows<P>::judge() {
  const TickScale& scale = motion_.rules().scale;
  Ticks differs = kNever;
  double events = 0;
  for (const auto& part : parts_) {
    differs = std::min(differs, part->differs());
    events += static_cast<double>(part->events());
  }
  Ticks end = until_;
  if (differs != kNever) end = std::min(end, differs - 1);
  const double used = used_ + speed_ * scale.seconds(until_ - now_);
  if (used > budget_ * kWider) {
    end = std::min(end, now_ + scale.ticks(std::max(0.0, (budget_ - used_) / speed_)));
  }
  if (end < until_) {
    cut_ = true;
    until_ = std::max(end, now_);
    for (const auto& part : parts_) {
      const auto& entries = part->journal().entries();
      again_ += !entries.empty() && entries.back().time > until_ ? 1U : 0U;
    }
    return kUndo;
  }
  for (const auto& part : parts_) {
    const JournalShare& impacts = part->impacts();
    halves_ += impacts.ball_ball_halves;
    counts_.ball_wall += impacts.ball_wall;
    counts_.max_overlap = std::max(counts_.max_overlap, impacts.overlap);
  }
  counts_.ball_ball = halves_ / 2;
  if (until_ == now_) stuck_ = true;
  now_ = until_;
  used_ = used;
  ++windows_;
  if (full_ || cut_) {
    if (sharing_.adapts) {
      const double times = cut_ ? kShorter : kLonger;
      window_ = std::max<Ticks>(1, static_cast<Ticks>(static_cast<double>(window_) * times));
    }
    constexpr double kShare = 1.0 / 64;
    const double least = kLeastEvents * static_cast<double>(parts_.size());
    if (yield_ == 0) yield_ = 2 * std::max(events, least);
    yield_ += kShare * (events - yield_);
    if (sharing_.adapts && yield_ < least) stuck_ = true;
  }
  return next();
}

template <class P>
void Windows<P>::rebase(Ticks by) {
  now_ -= by;
  target_ -= by;
  shared_at_ -= by;
  for (Disk& disk : flights_) {
    if (disk.start != kEver) disk.start -= by;
  }
  if (!flights_.empty()) return;
  for (const auto& part : parts_) part->rebase(by);
}

template <class P>
auto Windows<P>::flight(Index ball) const -> const Disk& {
  if (!flights_.empty()) return flights_[ball];
  std::size_t k = 0;
  while (!parts_[k]->owns(ball)) ++k;
  return parts_[k]->flight(ball);
}

template <class P>
Costs Windows<P>::costs() const {
  Costs costs;
  for (const auto& part : parts_) costs += part->tile().costs();
  return costs;
}

template <class P>
std::size_t Windows<P>::bytes() const {
  std::size_t bytes = 0;
  for (const auto& part : parts_) bytes += part->bytes();
  return bytes;
}

}  // namespace carom::event
