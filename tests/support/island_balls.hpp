#pragma once

#include <vector>

#include "solvers/event/islands/island_coming_body.hpp"
#include "solvers/event/islands/island_impulses_body.hpp"
#include "solvers/event/islands/island_search_body.hpp"
#include "solvers/event/neighbours_body.hpp"
#include "support/flight_at.hpp"

namespace carom::event {

/// What moves balls of radius 1/2 and mass 1 in a box of 20 by 20 around the origin, under gravity
/// 1; those of the second species are fixed, those of the third have a mass of 2.
inline Rules island_rules(double restitution, double wall_restitution) {
  Box box;
  box.width = 20;
  box.height = 20;
  box.origin = Box::Origin::center;
  Rules rules{{box, true}, FixedTimeClock(0.5)};
  rules.gravity = {0, -1};
  rules.restitution = restitution;
  rules.wall_restitution = wall_restitution;
  rules.all_species = {{0.5, 1}, {0.5, 0}, {0.5, 0.5}};
  rules.falls = true;
  rules.rests = true;
  return rules;
}

/// Balls of contact islands, and what finds and presses these.
struct IslandBalls {
  Motion<Ballistic> motion;
  HugeVector<Disk> disks;
  std::vector<double> spins;
  std::vector<double> left_out;
  FixedTime next_step = kNever;
  Neighbours<Ballistic> neighbours{motion};
  IslandSearch<Ballistic> search{motion, {disks, spins, next_step, left_out}, neighbours};
  JamLevel jam;
  IslandImpulses<Ballistic> impulses{motion, jam};

  explicit IslandBalls(const Rules& rules) : motion(rules) {}

  /// A ball that moves, of an island that is stepped unless `support` says otherwise.
  Index add(double x, double y, double vx = 0, double vy = 0, unsigned support = kStepped,
            Index species = 0) {
    disks.push_back(flight_at(x, y, vx, vy, species));
    motion.set_support(disks.back(), support);
    return static_cast<Index>(disks.size() - 1);
  }
  Index add_fixed(double x, double y) {
    disks.push_back(flight_at(x, y, 0, 0, 1));
    disks.back().start = kEver;
    return static_cast<Index>(disks.size() - 1);
  }
  /// To be called when all are there.
  void begin() {
    neighbours.reset(disks, 0);
    search.reset(disks.size());
  }
  /// The island of a ball, at the start.
  [[nodiscard]] FoundIsland<double> around(Index ball) {
    begin();
    return search.of_step({ball}, 0, 0).front();
  }
};

}  // namespace carom::event
