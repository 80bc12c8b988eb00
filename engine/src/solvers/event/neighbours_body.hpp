#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "solvers/event/exit_lanes.hpp"
#include "solvers/event/lanes.hpp"
#include "solvers/event/neighbours.hpp"
#include "solvers/event/word_search.hpp"

namespace carom::event {

// How far the new square is shifted the way the ball flies, as a part of half its side.
inline constexpr double kForward = 0.7;
// Wider than the rounding of centres and gaps.
inline constexpr double kMargin = 0x1p-30;

// Half a side that makes searching for neighbours cost about as much as predicting contacts with
// them: measured at packings 0.1, 0.5 and 0.7 of equal disks.
template <class P>
void Neighbours<P>::choose_skin(const Disks& disks, double area) {
  double diameters = 0;
  for (const auto& disk : disks) diameters += 2 * radius(disk);
  const auto n = static_cast<double>(std::max<std::size_t>(disks.size(), 1));
  const double diameter = diameters / n;
  const double spacing = std::sqrt(area / n);
  skin_ = 0.25 * diameter + 0.7 * std::max(spacing - diameter, 0.0);
  for (const double period : periods_) skin_ = std::min(skin_, period / 8);
}

template <class P>
void Neighbours<P>::reset(const Disks& disks, typename P::At now) {
  const Domain& domain = motion_.rules().domain;
  const auto length_of = [&domain](std::size_t axis) {
    return domain.upper[axis] - domain.lower[axis];
  };
  choose_skin(disks, length_of(0) * length_of(1));
  const double range = (2 * motion_.largest_radius() + 2 * skin_) * (1 + kMargin);
  const double most = 2 * std::sqrt(static_cast<double>(disks.size())) + 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = length_of(axis);
    plane_.divide(axis, domain.lower[axis], length, std::min(length / range, 4 * most),
                  domain.period[axis] > 0);
  }
  const auto n = static_cast<Index>(disks.size());
  centres_.resize(n);
  cell_.resize(n);
  lists_.reset(n);
  cells_.reset(plane_.size());
  for (Index i = 0; i < n; ++i) {
    set_square(disks[i], i, motion_.at(disks[i], now));
    cell_[i] = cell_of(centres_[i]);
    cells_.add(cell_[i], i);
  }
  for (Index i = 0; i < n; ++i) list(disks, i);
}

template <class P>
void Neighbours<P>::set_square(const typename P::Disk& disk, Index i, const Flight<S>& here) {
  const auto rough = [](const Vec<S>& a) {
    return Vec<double>{static_cast<double>(a.x), static_cast<double>(a.y)};
  };
  const Vec<double> at = rough(here.position);
  if (motion_.fixed(disk)) {
    centres_[i] = {at.x, at.y};
    return;
  }
  const Vec<double> v = rough(here.velocity);
  const double speed = std::max(std::abs(v.x), std::abs(v.y));
  // A speed near the least number there is would take for ever.
  const double wait = speed > 0 ? kForward * skin_ / speed : 0;
  const double ahead = std::isfinite(wait) ? wait : 0;
  const Domain& domain = motion_.rules().domain;
  const auto wrapped = [&domain](std::size_t axis, double x) {
    return domain.period[axis] > 0 ? domain.wrapped(axis, x) : x;
  };
  centres_[i] = {wrapped(0, at.x + v.x * ahead), wrapped(1, at.y + v.y * ahead)};
}

template <class P>
[[gnu::always_inline]] inline typename P::Time Neighbours<P>::leaving(const typename P::Disk& disk,
                                                                      Index i,
                                                                      const Flight<S>& here,
                                                                      typename P::At now) const {
  if (motion_.fixed(disk)) return P::Clock::never();
  const Vec<S>& v = here.velocity;
  S wait = 0;
  if constexpr (kIsDouble<S>) {
    const TwoLanes period{periods_[0], periods_[1]};
    const TwoLanes off{here.position.x - centres_[i].x, here.position.y - centres_[i].y};
    wait = motion_.ask(disk, [&](const auto& law) {
      return square_exit_bound(law, nearest(off, period, period / 2), TwoLanes{v.x, v.y}, skin_);
    });
  } else {
    const S skin = skin_;
    const Vec<S> off = motion_.way({centres_[i].x, centres_[i].y}, here.position);
    const auto& law = motion_.law_of(disk);
    const auto along = [&](std::size_t axis, const S& at, const S& speed) {
      const S forward = speed < 0 ? S(-at) : at;
      const S& push = law.push(axis, speed);
      return exit_bound(S(skin - forward), S(skin + forward), absolute(speed),
                        speed < 0 ? S(-push) : push, S(law.fading()));
    };
    wait = std::min(along(0, off.x, v.x), along(1, off.y, v.y));
  }
  const auto ticks = motion_.rules().scale.ticks(wait);
  return ticks == P::Clock::never() ? ticks : typename P::Time(now + ticks);
}

template <class P>
std::uint32_t Neighbours<P>::gather(std::uint32_t cell) {
  std::uint32_t candidates = 0;
  const auto take = [&](const auto& node) {
    if (found_.size() < candidates + 16) found_.resize(2 * found_.size() + 64);
    std::memcpy(&found_[candidates], node.item, sizeof node.item);
    candidates += node.count;
  };
  plane_.each_near(cell, [&](Cells::Number c) {
    const auto* node = &cells_.first(c);
    take(*node);
    while (node->next != 0) {
      node = &cells_.after(*node);
      take(*node);
    }
  });
  return candidates;
}

// Without branches: which of the candidates are near cannot be foreseen.
template <class P>
std::uint32_t Neighbours<P>::keep_near(const Disks& disks, Index i, std::uint32_t candidates) {
  if (found_.size() < candidates + kWords) found_.resize(candidates + 64);
  Index* const list = found_.data();
  for (std::uint32_t l = 0; l < kLanes; ++l) list[candidates + l] = i;
  const Centre at = centres_[i];
  const Lanes zero{};
  const Lanes period_x = zero + periods_[0];
  const Lanes period_y = zero + periods_[1];
  const double radius = this->radius(disks[i]);
  const double wider = 1 + kMargin;
  Lanes reach = zero + 2 * radius * wider;
  std::uint32_t found = 0;
  for (std::uint32_t from = 0; from < candidates; from += kLanes) {
    const Index j[kLanes] = {list[from], list[from + 1], list[from + 2], list[from + 3]};
    const Centre* c[kLanes] = {&centres_[j[0]], &centres_[j[1]], &centres_[j[2]], &centres_[j[3]]};
    Lanes dx = Lanes{c[0]->x, c[1]->x, c[2]->x, c[3]->x} - at.x;
    Lanes dy = Lanes{c[0]->y, c[1]->y, c[2]->y, c[3]->y} - at.y;
    dx = nearest(dx, period_x, period_x / 2);
    dy = nearest(dy, period_y, period_y / 2);
    dx = (dx < zero ? -dx : dx) - 2 * skin_ * wider;
    dy = (dy < zero ? -dy : dy) - 2 * skin_ * wider;
    dx = dx < zero ? zero : dx;
    dy = dy < zero ? zero : dy;
    if (!motion_.one_species()) {
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        reach[l] = (radius + this->radius(disks[j[l]])) * wider;
      }
    }
    const WholeLanes near = dx * dx + dy * dy <= reach * reach;
    for (std::uint32_t l = 0; l < kLanes; ++l) {
      list[found] = j[l];
      found += static_cast<std::uint32_t>(near[l] & 1) & static_cast<std::uint32_t>(j[l] != i);
    }
  }
  return found;
}

template <class P>
void Neighbours<P>::list(const Disks& disks, Index i) {
  const std::uint32_t found = keep_near(disks, i, gather(cell_[i]));
  // Which are new and which are gone cannot be foreseen either.
  const std::uint32_t had = lists_.copy(i, gone_);
  if (fresh_.size() < found_.size()) fresh_.resize(found_.size());
  for (std::uint32_t n = 0; n < kWords; ++n) {  // no neighbour of itself
    gone_[had + n] = i;
    found_[found + n] = i;
  }
  fresh_count_ = 0;
  for (std::uint32_t n = 0; n < found; ++n) {
    const Index j = found_[n];
    fresh_[fresh_count_] = j;
    fresh_count_ += is_among(gone_.data(), had, j) ? 0U : 1U;
  }
  std::uint32_t gone = 0;
  for (std::uint32_t n = 0; n < had; ++n) {
    const Index j = gone_[n];
    gone_[gone] = j;
    gone += is_among(found_.data(), found, j) ? 0U : 1U;
  }
  lists_.assign(i, found_.data(), found);
  for (std::uint32_t n = 0; n < fresh_count_; ++n) lists_.add(fresh_[n], i);
  for (std::uint32_t n = 0; n < gone; ++n) lists_.remove(gone_[n], i);
}

template <class P>
std::span<const Index> Neighbours<P>::renew(const Disks& disks, Index i, const Flight<S>& here) {
  set_square(disks[i], i, here);
  const std::uint32_t cell = cell_of(centres_[i]);
  if (cell != cell_[i]) {
    cells_.remove(cell_[i], i);
    cells_.add(cell, i);
    cell_[i] = cell;
  }
  list(disks, i);
  return {fresh_.data(), fresh_count_};
}

template <class P>
std::span<const Index> Neighbours<P>::around(double x, double y) {
  const std::uint32_t candidates = gather(cell_of({x, y}));
  return {found_.data(), candidates};
}

template <class P>
template <class Visit>
void Neighbours<P>::each_cell_around(Index i, Visit visit) const {
  const auto last = static_cast<std::uint32_t>(plane_.size()) - 1;
  const std::uint32_t columns = plane_.count(0);
  for (const std::uint32_t row : {cell_[i] - columns, cell_[i], cell_[i] + columns}) {
    for (std::uint32_t c = 0; c < 3; ++c) visit(cells_.first(std::min(row + c - 1, last)));
  }
}

template <class P>
void Neighbours<P>::fetch_cells(Index i) const {
  each_cell_around(i, [](const auto& node) { __builtin_prefetch(&node); });
}

template <class P>
void Neighbours<P>::fetch_search(Index i) const {
  const auto& list = lists_.first(i);
  for (std::uint32_t n = 0; n < list.count; ++n) __builtin_prefetch(&lists_.first(list.item[n]));
  each_cell_around(i, [this](const auto& node) {
    for (std::uint32_t n = 0; n < node.count; ++n) __builtin_prefetch(&centres_[node.item[n]]);
  });
}

}  // namespace carom::event
