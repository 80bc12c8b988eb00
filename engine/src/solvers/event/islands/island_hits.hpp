#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

/// What of an island meets at an instant, and which balls stay of it.
struct IslandHits {
  std::vector<char> stays;    ///< by member: it is of the island afterwards
  std::vector<char> counted;  ///< by contact: it is an impact
  std::vector<char> parts;    ///< by contact: it is one that bounces
  double restitution = 1;     ///< the least of those that bounce; of an island of few contacts
  double fastest = 0;         ///< approach, of all contacts; at least what gravity makes in a step
  bool bounces = false;
  std::uint64_t walls = 0;
  std::uint64_t balls = 0;

  [[nodiscard]] std::uint64_t all() const { return walls + balls; }
};

/// `disks`: the flights of all balls.  `steps`: of a step, in which what touches is held, only what
/// comes.
template <class P>
IslandHits hits_of(const Motion<P>& motion, const HugeVector<typename P::Disk>& disks,
                   const FoundIsland<typename P::Scalar>& island, typename P::At now, bool steps) {
  using S = typename P::Scalar;
  IslandHits hits;
  hits.stays.resize(island.members.size(), 0);
  hits.counted.resize(island.contacts.size(), 0);
  hits.parts.resize(island.contacts.size(), 0);
  const auto disk_of = [&](int body) -> const typename P::Disk& {
    return disks[island.members[static_cast<std::size_t>(body)]];
  };
  const auto speed_of_step = static_cast<double>(motion.speed_of_step());
  const auto lasting_speed = static_cast<double>(motion.lasting_speed(S(0), S(1)));
  hits.fastest = speed_of_step;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const auto& near = island.near[k];
    if (!near.comes && (steps || island.touches[k] == 0)) continue;
    const auto a = static_cast<std::size_t>(c.a);
    const double speed = approach(island, k);
    if (speed < -kStill * speed_of_step) continue;
    hits.fastest = std::max(hits.fastest, speed);
    const bool wall = is_at_wall(island, k);
    if (wall && island.support[a] < kResting && !(speed > 0)) continue;
    bool sticks = false;
    if (wall) {
      sticks = island.support[a] >= kResting && motion.sticks_to_wall(disk_of(c.a), S(speed), now);
    } else {
      const typename P::Disk& partner = c.b == kWall ? disks[near.partner] : disk_of(c.b);
      sticks = motion.sticks(disk_of(c.a), partner, near.r, now);
    }
    if (speed > 0) {
      ++(wall ? hits.walls : hits.balls);
      hits.counted[k] = 1;
    }
    if (sticks) {
      hits.stays[a] = 1;
      if (c.b != kWall) hits.stays[static_cast<std::size_t>(c.b)] = 1;
    }
    // What comes faster than a contact that lasts is no such one where nothing takes its energy.
    const bool holds = sticks && !(motion.keeps_energy() && speed > lasting_speed);
    if (!holds && speed > 0) {
      hits.bounces = true;
      hits.parts[k] = 1;
      hits.restitution = std::min(
          hits.restitution, wall ? motion.rules().wall_restitution : motion.rules().restitution);
    }
  }
  return hits;
}

}  // namespace carom::event
