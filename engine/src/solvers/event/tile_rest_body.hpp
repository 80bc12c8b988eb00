#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/event_carrying_forces.hpp"
#include "contact/event_rest.hpp"
#include "contact/event_settling.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

template <class P>
void Tile<P>::start_resting(At now) requires(P::kRests) {
  woken_.clear();
  next_settling_ = P::Clock::never();
  if constexpr (P::Law::kBends) {
    // How often groups are looked at: about the time of a fall through the largest ball.
    const Vec<S>& g = motion_.law().pull();
    const S pull = root(S(g.x * g.x + g.y * g.y));
    if (!(pull > 0)) return;
    const S fall = root(S(2 * motion_.largest_radius() / pull));
    const Time span = motion_.rules().scale.ticks(fall);
    settling_shift_ = P::Clock::shift_of(std::min(span, P::Clock::era()));
    for (Disk& disk : disks_) {
      if (!motion_.fixed(disk) && !motion_.asleep(disk) && disk.start == now) {
        motion_.lean_on_walls(disk);
      }
    }
    schedule_settling(now);
  }
}

template <class P>
void Tile<P>::schedule_settling(At now) requires(P::kRests) {
  if (!P::Law::kBends || next_settling_ != P::Clock::never() || left_.empty()) return;
  next_settling_ = P::Clock::span(P::Clock::steps(now, settling_shift_) + 1, settling_shift_);
}

template <class P>
void Tile<P>::lean(Index i) requires(P::kRests) {
  if constexpr (P::Law::kBends) {
    Disk& disk = disks_[i];
    if (motion_.fixed(disk)) return;
    const unsigned before = motion_.carried(disk);
    motion_.lean_on_walls(disk);
    const Index peg = left_[i];
    if (peg != kUnknown) motion_.lean_on_peg(disk, disks_[peg]);
    if ((motion_.carried(disk) & ~before) != 0) ++counts_.resting_contacts;
  }
}

template <class P>
void Tile<P>::wake(Index i, At now) requires(P::kRests) {
  if (P::Law::kBends && !motion_.fixed(disks_[i]) && motion_.asleep(disks_[i])) {
    ++counts_.wakes;
    std::vector<Index> group{i};
    const auto rouse = [&](Index k) {
      Disk& disk = disks_[k];
      motion_.carry(disk, now);
      motion_.set_carried(disk, 0);
      motion_.lean_on_walls(disk);
      left_[k] = kUnknown;
    };
    unlink(i);
    forget(i);
    rouse(i);
    for (std::size_t n = 0; n < group.size(); ++n) {
      const Index k = group[n];
      neighbours_.lists().each(k, [&](Index j) {
        const Disk& other = disks_[j];
        if (motion_.fixed(other) || !motion_.asleep(other)) return;
        const Vec<S> r = motion_.way(motion_.place(disks_[k], now), motion_.place(other, now));
        const S reach = motion_.kind(disks_[k]).radius + motion_.kind(other).radius;
        if (!near(r, reach, S(kTouching))) return;
        unlink(j);
        forget(j);
        rouse(j);
        group.push_back(j);
      });
    }
    woken_.insert(woken_.end(), group.begin(), group.end());
  }
}

template <class P>
void Tile<P>::wake_around(Index i, At now) requires(P::kRests) {
  std::vector<Index> leaning;
  const Vec<S> here = motion_.place(disks_[i], now);
  neighbours_.lists().each(i, [&](Index j) {
    const Vec<S> r = motion_.way(here, motion_.place(disks_[j], now));
    const S reach = motion_.kind(disks_[i]).radius + motion_.kind(disks_[j]).radius;
    if (near(r, reach, S(kTouching))) leaning.push_back(j);
  });
  for (const Index j : leaning) wake(j, now);
  woken_.clear();  // all are looked at anew
}

template <class P>
void Tile<P>::look_again_at_woken(At now) requires(P::kRests) {
  while (!woken_.empty()) {
    const Index k = woken_.back();
    woken_.pop_back();
    look_again(k, now);
  }
}

// Every contact that approaches parts again, and every one that does not part is made to, by the
// least impulses that do it; false: this is no hop.
template <class P>
bool Tile<P>::hop_jointly(Instant& instant, At now) const requires(P::kRests) {
  const std::size_t n = instant.contacts.size();
  const CarryingForces<S> forces(instant.bodies, instant.contacts, S(kGive));
  std::vector<Vec<S>> motion;
  for (const Body<S>& body : instant.bodies) motion.push_back(body.velocity);
  const auto disk_of = [&](int body) -> const Disk& {
    return disks_[instant.members[static_cast<std::size_t>(body)]];
  };
  // Where an instant does not end, everything hops, and farther each time.
  const std::size_t again = at_once_ / (64 + 2 * disks_.size());
  const double times = std::ldexp(1.0, static_cast<int>(std::min<std::size_t>(again, 12)));
  std::vector<S> missing(n);
  S largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Contact<S>& c = instant.contacts[k];
    const S parting = forces.parting(k, motion);
    const Disk& a = disk_of(c.a);
    S wanted = 0;
    if (c.b == kWall) {
      if (again == 0 && parting < 0 && -parting > motion_.fastest_hop(a, a, now)) return false;
      if (parting < 0) wanted = wall_impact(parting, c.restitution);
    } else {
      const Disk& b = disk_of(c.b);
      const S hop = times * motion_.hop_speed(motion_.kind(a).radius + motion_.kind(b).radius);
      if (again == 0 && parting < 0 && -parting > motion_.fastest_hop(a, b, now)) return false;
      const S parts = again == 0 ? S(hop * kHopError) : hop;
      if (!(parting > parts)) wanted = larger(S(-parting), hop);
    }
    missing[k] = parting - wanted;
    largest = larger(largest, absolute(missing[k]));
  }
  std::vector<S> impulses(n, S(0));
  forces.solve(missing, S(largest * kHopError), impulses);
  const std::vector<Vec<S>> changes = forces.changes(impulses);
  for (std::size_t k = 0; k < instant.bodies.size(); ++k) {
    instant.bodies[k].velocity = instant.bodies[k].velocity + changes[k];
  }
  for (const typename Instant::Stop& stop : instant.stops) {
    Vec<S>& v = instant.bodies[stop.member].velocity;
    S& along = stop.wall - kWalls < 2 ? v.x : v.y;
    if (stop.wall % 2 == kWalls % 2 ? along < 0 : along > 0) along = 0;
  }
  return true;
}

template <class P>
std::uint64_t Tile<P>::resting_now() const requires(P::kRests) {
  std::uint64_t count = 0;
  for (Index i = 0; i < disks_.size(); ++i) {
    const Disk& disk = disks_[i];
    if (motion_.fixed(disk) || motion_.carried(disk) == 0) continue;
    for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
      if (motion_.rules().domain.solid((wall - kWalls) / 2) &&
          motion_.wall(disk, {disk.x, disk.y}, wall).gap == 0) {
        ++count;
      }
    }
    if (!motion_.asleep(disk)) continue;
    neighbours_.lists().each(i, [&](Index j) {
      const Disk& other = disks_[j];
      if (!motion_.fixed(other) && (j < i || !motion_.asleep(other))) return;
      const S reach = motion_.kind(disk).radius + motion_.kind(other).radius;
      if (near(motion_.way({disk.x, disk.y}, {other.x, other.y}), reach, S(kTouching))) ++count;
    });
  }
  return count;
}

}  // namespace carom::event
