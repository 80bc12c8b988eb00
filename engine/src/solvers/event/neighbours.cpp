#include "solvers/event/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/event_wall_time.hpp"
#include "solvers/event/lanes.hpp"

namespace carom::event {
namespace {

// How far the new square is shifted the way the ball flies, as a part of half its side.
constexpr double kForward = 0.7;
// Wider than the rounding of centres and gaps.
constexpr double kMargin = 0x1p-30;

}  // namespace

// Half a side that makes searching for neighbours about as dear as looking at them: measured at
// packings 0.1, 0.5 and 0.7 of equal disks.
void Neighbours::choose_skin(const HugeVector<Disk>& disks) {
  const Domain& domain = motion_.rules().domain;
  const double area = (domain.upper[0] - domain.lower[0]) * (domain.upper[1] - domain.lower[1]);
  double diameters = 0;
  for (const Disk& disk : disks) diameters += 2 * motion_.kind(disk).radius;
  const auto n = static_cast<double>(std::max<std::size_t>(disks.size(), 1));
  const double diameter = diameters / n;
  const double spacing = std::sqrt(area / n);
  skin_ = 0.15 * diameter + 0.75 * std::max(spacing - diameter, 0.0);
  for (const double period : motion_.periods()) skin_ = std::min(skin_, period / 8);
}

void Neighbours::reset(const HugeVector<Disk>& disks, Ticks now) {
  choose_skin(disks);
  const Domain& domain = motion_.rules().domain;
  const double range = (2 * motion_.largest_radius() + 2 * skin_) * (1 + kMargin);
  const double most = 2 * std::sqrt(static_cast<double>(disks.size())) + 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double length = domain.upper[axis] - domain.lower[axis];
    count_[axis] = static_cast<std::uint32_t>(std::clamp(length / range, 1.0, 4 * most));
    per_length_[axis] = count_[axis] / length;
  }
  const auto n = static_cast<Index>(disks.size());
  centres_.resize(n);
  cell_.resize(n);
  seen_.assign(n, 0);
  stamp_ = 0;
  lists_.reset(n);
  cells_.reset(std::size_t{count_[0]} * count_[1]);
  for (Index i = 0; i < n; ++i) {
    set_square(disks[i], i, now);
    cell_[i] = cell_of(centres_[i]);
    cells_.add(cell_[i], i);
  }
  for (Index i = 0; i < n; ++i) list(disks, i);
}

std::uint32_t Neighbours::cell_of(const Centre& at) const {
  const Domain& domain = motion_.rules().domain;
  const auto along = [&](double x, std::size_t axis) {
    const double cells = (x - domain.lower[axis]) * per_length_[axis];
    return static_cast<std::uint32_t>(std::clamp(cells, 0.0, count_[axis] - 1.0));
  };
  return along(at.y, 1) * count_[0] + along(at.x, 0);
}

void Neighbours::set_square(const Disk& disk, Index i, Ticks now) {
  if (motion_.fixed(disk)) {
    centres_[i] = {disk.x, disk.y};
    return;
  }
  const Vec<double> at = motion_.place(disk, now);
  const Vec<double> v = motion_.velocity(disk, now);
  const double speed = std::max(std::abs(v.x), std::abs(v.y));
  const double ahead = speed > 0 ? kForward * skin_ / speed : 0;
  const Vec<double> centre = motion_.wrapped({at.x + v.x * ahead, at.y + v.y * ahead});
  centres_[i] = {centre.x, centre.y};
}

Ticks Neighbours::leaving(const Disk& disk, Index i, Ticks now) const {
  if (motion_.fixed(disk)) return kNever;
  const Vec<double> off = motion_.way({centres_[i].x, centres_[i].y}, motion_.place(disk, now));
  const Vec<double> v = motion_.velocity(disk, now);
  double wait = 0;
  if (motion_.falls()) {
    const auto& g = motion_.rules().gravity;
    wait = std::min({wall_time(skin_ - off.x, -v.x, -g[0]), wall_time(skin_ + off.x, v.x, g[0]),
                     wall_time(skin_ - off.y, -v.y, -g[1]), wall_time(skin_ + off.y, v.y, g[1])});
  } else {
    const double wait_x = (skin_ - std::copysign(1.0, v.x) * off.x) / std::abs(v.x);
    const double wait_y = (skin_ - std::copysign(1.0, v.y) * off.y) / std::abs(v.y);
    wait = std::min(v.x == 0 ? never<double>() : wait_x, v.y == 0 ? never<double>() : wait_y);
  }
  const Ticks ticks = motion_.rules().scale.ticks(std::max(wait, 0.0));
  return ticks == kNever ? kNever : now + ticks;
}

std::uint32_t Neighbours::gather(std::uint32_t cell) {
  const Domain& domain = motion_.rules().domain;
  const std::array<int, 2> middle{static_cast<int>(cell % count_[0]),
                                  static_cast<int>(cell / count_[0])};
  std::array<std::array<int, 3>, 2> at{};
  std::array<int, 2> many{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int count = static_cast<int>(count_[axis]);
    for (int step = -1; step <= 1; ++step) {
      int k = middle[axis] + step;
      if (k < 0 || k >= count) {
        // With one or two cells, what lies round the corner is there already.
        if (!(domain.period[axis] > 0) || count < 3) continue;
        k = (k + count) % count;
      }
      at[axis][static_cast<std::size_t>(many[axis]++)] = k;
    }
  }
  std::uint32_t candidates = 0;
  const auto take = [&](const auto& node) {
    if (found_.size() < candidates + 16) found_.resize(2 * found_.size() + 64);
    std::memcpy(&found_[candidates], node.item, sizeof node.item);
    candidates += node.count;
  };
  for (int r = 0; r < many[1]; ++r) {
    for (int c = 0; c < many[0]; ++c) {
      const int number = at[1][static_cast<std::size_t>(r)] * static_cast<int>(count_[0]) +
                         at[0][static_cast<std::size_t>(c)];
      const auto* node = &cells_.first(static_cast<std::uint32_t>(number));
      take(*node);
      while (node->next != 0) {
        node = &cells_.after(*node);
        take(*node);
      }
    }
  }
  return candidates;
}

// Without branches: which of the candidates are near cannot be foreseen.
std::uint32_t Neighbours::keep_near(const HugeVector<Disk>& disks, Index i,
                                    std::uint32_t candidates) {
  if (found_.size() < candidates + kLanes) found_.resize(candidates + 64);
  Index* const list = found_.data();
  for (std::uint32_t l = 0; l < kLanes; ++l) list[candidates + l] = i;
  const Centre at = centres_[i];
  const Lanes zero{};
  const Lanes period_x = zero + motion_.periods()[0];
  const Lanes period_y = zero + motion_.periods()[1];
  const double radius = motion_.kind(disks[i]).radius;
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
    if (!motion_.one_kind()) {
      for (std::uint32_t l = 0; l < kLanes; ++l) {
        reach[l] = (radius + motion_.kind(disks[j[l]]).radius) * wider;
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

void Neighbours::list(const HugeVector<Disk>& disks, Index i) {
  const std::uint32_t found = keep_near(disks, i, gather(cell_[i]));
  if (stamp_ > 0xfffffff0U) {
    std::fill(seen_.begin(), seen_.end(), 0);
    stamp_ = 0;
  }
  stamp_ += 2;
  lists_.each(i, [&](Index j) { seen_[j] = stamp_; });
  fresh_.clear();
  for (std::uint32_t n = 0; n < found; ++n) {
    const Index j = found_[n];
    if (seen_[j] != stamp_) {
      lists_.add(j, i);
      fresh_.push_back(j);
    }
    seen_[j] = stamp_ + 1;
  }
  lists_.each(i, [&](Index j) {
    if (seen_[j] == stamp_) lists_.remove(j, i);
  });
  lists_.assign(i, found_.data(), found);
}

const std::vector<Index>& Neighbours::renew(const HugeVector<Disk>& disks, Index i, Ticks now) {
  set_square(disks[i], i, now);
  const std::uint32_t cell = cell_of(centres_[i]);
  if (cell != cell_[i]) {
    cells_.remove(cell_[i], i);
    cells_.add(cell, i);
    cell_[i] = cell;
  }
  list(disks, i);
  return fresh_;
}

void Neighbours::fetch_around(Index i) const {
  const std::uint32_t last = count_[0] * count_[1] - 1;
  for (const std::uint32_t row : {cell_[i] - count_[0], cell_[i], cell_[i] + count_[0]}) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      __builtin_prefetch(&cells_.first(std::min(row + c - 1, last)));
    }
  }
}

std::size_t Neighbours::bytes() const {
  return centres_.capacity() * sizeof(Centre) +
         (cell_.capacity() + seen_.capacity() + found_.capacity()) * sizeof(Index) +
         lists_.bytes() + cells_.bytes();
}

}  // namespace carom::event
