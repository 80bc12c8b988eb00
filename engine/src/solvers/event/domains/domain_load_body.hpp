#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "solvers/event/domains/domain_loop.hpp"
#include "solvers/event/domains/slot_runs.hpp"

namespace carom::event {

/// Pairs are taken to touch so much earlier than they do, as a part of a radius and of the box:
/// more than all roundings of carried paths.
inline constexpr double kSlackOfRadius = 0x1p-30;
inline constexpr double kSlackOfBox = 0x1p-44;
/// Of the queue, for each ball.
inline constexpr double kBucketsOfCollision = 0.75;

template <class P>
DomainLoop<P>::DomainLoop(const Motion<P>& motion, double normal_radius)
    : motion_(motion),
      normal_radius_(normal_radius),
      bends_(motion.bends()),
      walls_(motion.box().solid(0) || motion.box().solid(1)),
      contacts_last_(motion.contacts_last()),
      books_flights_(motion.loses_in_flight() && !motion.rules().only_drag_takes()),
      approach_({0, 0}, 1, nullptr, 0, 1) {
  smallest_radius_ = never<double>();
  for (const auto& species : motion.rules().all_species) {
    smallest_radius_ = std::min(smallest_radius_, species.radius);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    periods_[axis] = motion.rules().domain.period[axis];
    per_period_[axis] = periods_[axis] > 0 ? 1 / periods_[axis] : 0;
    farthest_[axis] = motion.farthest(axis) * (1 - 0x1p-20);
    pull_[axis] = std::abs(motion.law().pull(axis)) / 2;
  }
}

template <class P>
void DomainLoop<P>::begin(const DomainWindow& window, const Memory& memory) {
  window_ = window;
  memory_ = memory;
  falls_on_fixed_ = memory.lefts != nullptr;
  tracked_ = window.halo;
  end_ = seconds(window.until);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    slow_[axis] = (farthest_[axis] / end_ - pull_[axis] * end_) * (1 - 0x1p-20);
  }
  bend_per_square_ = std::hypot(pull_[0], pull_[1]);
  bend_ = bend_per_square_ * end_ * end_ / 4;
  // Seen in straightened time it falls faster at the end.
  if constexpr (P::Law::kStretches) bend_ *= std::exp(2 * motion_.law().rate * end_);
  skin_square_ = window.skin * window.skin * (1 - 0x1p-20);
  near_ = 2 * window.skin * (1 + 0x1p-20);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    inside_[axis] = periods_[axis] / 2 - 2 * (motion_.largest_radius() + window.skin) - near_;
  }
  loading_.clear();
  unusual_ = false;
  tally_ = {};
}

// From the middle of the domain, in the nearest image.
template <class P>
[[gnu::always_inline]] inline Path DomainLoop<P>::path_at_start(const BlockFlight& flight) const {
  Path path{flight.x, flight.y, flight.vx, flight.vy};
  if (flight.start != kEver) {
    if (!bends_) {
      const double wait = motion_.rules().scale.seconds(window_.from - flight.start);
      path.x += wait * flight.vx;
      path.y += wait * flight.vy;
    } else {
      const Vec<double> at = motion_.place(flight, window_.from);
      const Vec<double> v = motion_.velocity(flight, window_.from);
      path = {at.x, at.y, v.x, v.y};
    }
  }
  const double dx = path.x - window_.middle[0];
  const double dy = path.y - window_.middle[1];
  path.x = dx - periods_[0] * std::rint(dx * per_period_[0]);
  path.y = dy - periods_[1] * std::rint(dy * per_period_[1]);
  return path;
}

template <class P>
void DomainLoop<P>::load(Index memory, bool own) {
  const BlockFlight& flight = memory_.flights[memory];
  const Path path = path_at_start(flight);
  const Vec<double> shift = ahead({path.vx, path.vy});
  Loaded ball{static_cast<float>(path.x + shift.x),
              static_cast<float>(path.y + shift.y),
              memory,
              0,
              0,
              kToTheEnd,
              own};
  if (!own) {
    const std::array<double, 2> at{path.x, path.y};
    double distance = -1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (window_.whole[axis]) continue;
      const double inside = std::clamp(at[axis], window_.lowest[axis], window_.highest[axis]);
      distance = std::max(distance, std::abs(inside) - window_.own[axis]);
    }
    distance -= std::max(0.0, motion_.rules().all_species[flight.species].radius - normal_radius_);
    ball.distance = static_cast<float>(distance);
    if (distance > window_.full) {
      const double part = (window_.reach - distance) / (window_.reach - window_.full);
      if (!(part > 0)) return;
      ball.limit = static_cast<float>(part * end_);
    }
  }
  loading_.push_back(ball);
}

template <class P>
bool DomainLoop<P>::start() {
  if (loading_.size() > kMostBalls) return false;
  const auto n = static_cast<std::uint32_t>(loading_.size());
  std::array<double, 2> wrapped{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (window_.wraps[axis]) wrapped[axis] = periods_[axis];
  }
  cells_.reset(window_.loaded, wrapped, (2 * normal_radius_ + near_) * (1 + 0x1p-20), n);
  mixed_ = !motion_.one_species();
  search_.reset(n, window_.loaded, wrapped, near_,
                mixed_ ? std::nullopt : std::optional<double>(smallest_radius_));
  queue_.reset(n, window_.until - window_.from + 1, kBucketsOfCollision * window_.collisions);
  lists_.reset(n);
  sort_into_slots();
  if (contacts_last_ && any_rests()) return false;
  slack_ = kSlackOfRadius * smallest_radius_ +
           kSlackOfBox * (std::abs(window_.middle[0]) + window_.loaded[0] +
                          std::abs(window_.middle[1]) + window_.loaded[1]);
  approach_ = Approach(wrapped, smallest_radius_, mixed_ ? radii_.data() : nullptr, slack_,
                       window_.skin > 0 && end_ > 0 ? window_.skin / end_ : 1);
  list_all();
  for (std::size_t k = 0; falls_on_fixed_ && k < flights_.size(); ++k) {
    note_fixed(static_cast<Slot>(k));
  }
  first_events();
  return !unusual_;
}

// What begins now may lie on a wall already.
template <class P>
bool DomainLoop<P>::any_rests() const {
  for (std::size_t k = 0; k < flights_.size(); ++k) {
    if (motion_.fixed(flights_[k])) continue;
    if (!motion_.flies(flights_[k])) return true;
    if (flights_[k].start == window_.from && rests_on_wall(static_cast<Slot>(k))) return true;
  }
  return false;
}

template <class P>
void DomainLoop<P>::sort_into_slots() {
  const auto n = static_cast<std::uint32_t>(loading_.size());
  ends_.assign(cells_.cells() + 1, 0);
  for (Loaded& ball : loading_) {
    ball.cell = cells_.cell_at(ball.x, ball.y);
    ++ends_[ball.cell + 1];
  }
  for (std::size_t c = 0; c < cells_.cells(); ++c) ends_[c + 1] += ends_[c];
  flights_.resize(n);
  // Lists may be read a little beyond their last.
  paths_.resize(n + NearLists::kShort + 2);
  sides_.resize(n);
  memories_.resize(n);
  around_.resize(n + NearSearch::kAtATime);
  tracks_.resize(tracked_ ? n : 0);
  spins_.resize(motion_.rules().spins ? n : 0);
  lefts_.resize(falls_on_fixed_ ? n : 0);
  radii_.resize(mixed_ ? n + NearLists::kShort + 2 : 0);
  large_.clear();
  for (const Loaded& ball : loading_) {
    const std::uint32_t k = ends_[ball.cell]++;
    BlockFlight& flight = flights_[k];
    flight = memory_.flights[ball.memory];
    memories_[k] = ball.memory;
    const Path path = path_at_start(flight);
    paths_[k] = path;
    // To one that falls it does not move straight: its times are asked for one by one.
    if (falls_on_fixed_ && motion_.fixed(flight)) paths_[k].vx = std::nan("");
    if (falls_on_fixed_) lefts_[k] = memory_.lefts[ball.memory];
    Side& side = sides_[k];
    side = {};
    side.x = ball.x;
    side.y = ball.y;
    side.limit = ball.limit;
    side.own = ball.own;
    const auto& species = motion_.species(flight);
    const double r = species.radius;
    side.fixed = species.fixed();
    if (tracked_) {
      tracks_[k] = {0, static_cast<float>(path.x), static_cast<float>(path.y), 0, ball.distance};
    }
    if (!spins_.empty()) spins_[k] = memory_.spins[ball.memory];
    if (mixed_) radii_[k] = r;
    search_.set(k, ball.x, ball.y, r);
    if (r > normal_radius_) {
      large_.push_back(static_cast<Slot>(k));
    } else {
      cells_.add(static_cast<Slot>(k), ball.cell);
    }
    note_ends(static_cast<Slot>(k));
    side.leaves = side.fixed ? never<double>() : exit(static_cast<Slot>(k), window_.from);
    note_walls(static_cast<Slot>(k));
    side.set(kFar, flies_far(flight, window_.until));
  }
}

// A list for each ball; the fast way where a cell and those around it are all different.
template <class P>
void DomainLoop<P>::list_all() {
  const auto n = static_cast<std::uint32_t>(flights_.size());
  const auto is_large = [&](std::uint32_t k) { return radii_[k] > normal_radius_; };
  if (!large_.empty() || !cells_.plain()) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto me = static_cast<Slot>(i);
      gathered_.clear();
      if (!large_.empty() && is_large(i)) {
        search_.each_group(i, 0, n,
                           [&](std::uint32_t k, std::uint32_t mask) { gathered_.add(k, mask); });
      } else {
        cells_.each_near(cells_.cell_of(me), [&](Slot k) { gathered_.add(k, search_.near(i, k)); });
        for (const Slot k : large_) gathered_.add(k, search_.near(i, k));
      }
      lists_.set(me, gathered_);
    }
    return;
  }
  each_cell_run(cells_.plane(), ends_, [&](const SlotRun& cell, std::span<const SlotRun> around) {
    for (std::uint32_t i = cell.first; i < cell.last; ++i) {
      gathered_.clear();
      for (const SlotRun& run : around) {
        search_.each_group(i, run.first, run.last,
                           [&](std::uint32_t k, std::uint32_t mask) { gathered_.add(k, mask); });
      }
      lists_.set(static_cast<Slot>(i), gathered_);
    }
  });
}

template <class P>
void DomainLoop<P>::first_events() {
  const auto n = static_cast<std::uint32_t>(flights_.size());
  for (std::uint32_t k = 0; k < n && !unusual_; k += 2) {
    const auto i = static_cast<Slot>(k);
    const auto j = static_cast<Slot>(std::min(k + 1, n - 1));
    const Approach::Earliest of_i = earliest(i, 0);
    const Approach::Earliest of_j = earliest(j, 0);
    if (!sides_[i].fixed) keep_bound(i, of_i.first, of_i.second, of_i.ball, window_.from);
    if (i == j || sides_[j].fixed) continue;
    keep_bound(j, of_j.first, of_j.second, of_j.ball, window_.from);
  }
}

}  // namespace carom::event
