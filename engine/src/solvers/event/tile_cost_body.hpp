#pragma once

#include <algorithm>

#include "solvers/event/tile.hpp"
#include "state/stopwatch.hpp"

namespace carom::event {

/// One event in so many is timed: reading the clock in all would cost more than they.
inline constexpr std::uint32_t kEventsOfSample = 127;

/// What happens between two readings of the clock that have nothing between them is theirs.
template <class Work>
double seconds_of(const Work& work) {
  double clock = 0;
  double seconds = 0;
  { const Stopwatch stopwatch(true, clock); }
  {
    const Stopwatch stopwatch(true, seconds);
    work();
  }
  return std::max(0.0, seconds - clock);
}

/// Makes the compiler work out what nobody uses.
template <class Value>
void use(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

// The event is timed as a whole.  What is not the pairs' in it is small, and mixed with it in the
// code: that is done once more, on copies, and timed alone.
template <class P>
[[gnu::noinline]] void Tile<P>::time_event(Index i, At now) {
  untimed_ = kEventsOfSample - 1;
  ++samples_;
  const Disk before = disks_[i];
  const Index partner = before.meets <= before.leaves ? before.partner : kUnknown;
  const bool at_wall = partner >= kWalls;
  const bool at_ball = partner < kFirstMark;
  const Disk other_before = at_ball ? disks_[partner] : before;
  const bool both = at_ball && !motion_.fixed(other_before);

  const double crowds = crowd_seconds_;
  double whole = seconds_of([&] { next_event(i, now); });
  whole -= crowd_seconds_ - crowds;

  Costs costs;
  if (motion_.bends()) {
    const double flight = seconds_of([&] { use(motion_.at(before, now)); });
    if (partner != kUnknown) costs.bending = both ? 2 * flight : flight;
  }
  if (motion_.room().solid(0) || motion_.room().solid(1)) {
    const Disk& after = disks_[i];
    const double search =
        seconds_of([&] { use(motion_.alone(after, std::min(after.meets, after.leaves))); });
    costs.walls = both ? 2 * search : search;
  }
  if (at_wall) {
    Disk disk = before;
    const double impact = seconds_of([&] {
      S turning = spins_.empty() ? S(0) : spins_[i];
      motion_.bounce(disk, spins_.empty() ? nullptr : &turning, partner, now);
      use(disk);
    });
    costs.walls += std::max(0.0, impact - costs.bending);
  }
  if (!spins_.empty()) {
    S spin = spins_[i];
    S other_spin = at_ball ? spins_[partner] : S(0);
    Disk disk = before;
    Disk other = other_before;
    if (at_wall) {
      motion_.carry(disk, now);
      const std::size_t axis = (partner - kWalls) / 2;
      const int side = (partner - kWalls) % 2 == 0 ? 1 : -1;
      const S arrival = side * (axis == 0 ? disk.vx : disk.vy);
      costs.friction = seconds_of([&] {
        motion_.rub_wall(disk, spin, axis, side, arrival);
        use(disk);
      });
      costs.walls = std::max(0.0, costs.walls - costs.friction);
    } else if (at_ball) {
      motion_.carry(disk, now);
      if (both) motion_.carry(other, now);
      const Vec<S> r = motion_.way({disk.x, disk.y}, {other.x, other.y});
      costs.friction = seconds_of([&] {
        motion_.rub(disk, spin, other, other_spin, r);
        use(disk);
        use(other);
      });
    }
  }
  if (motion_.rules().collisions) {
    costs.collisions = std::max(0.0, whole - costs.walls - costs.friction - costs.bending);
  }
  sampled_ += costs;
}

template <class P>
Costs Tile<P>::costs() const {
  Costs costs;
  if (samples_ > 0) {
    const auto samples = static_cast<double>(samples_);
    const double scale = (samples * kEventsOfSample - untimed_) / samples;
    costs = {sampled_.collisions * scale, sampled_.walls * scale, sampled_.friction * scale,
             sampled_.bending * scale};
  }
  costs.collisions += crowd_seconds_;
  return costs;
}

}  // namespace carom::event
