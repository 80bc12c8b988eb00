#pragma once

#include <algorithm>
#include <vector>

#include "contact/cone_island.hpp"
#include "solvers/event/islands/island_impulses.hpp"
#include "solvers/event/islands/lasting_speed.hpp"

namespace carom::event {

template <class P>
bool IslandImpulses<P>::lasts(const Island& island, std::size_t contact) const {
  if (!motion_.elastic_impacts()) return true;
  const S most = lasting_speed(motion_, island, contact);
  if (!(approach(island, contact) <= static_cast<double>(most))) return false;
  if (is_at_wall(island, contact)) return island.touches[contact] != 0;
  return island.contacts[contact].gap <= static_cast<double>(S(most * motion_.seconds_of_step()));
}

template <class P>
bool IslandImpulses<P>::holds(const Island& island, std::size_t contact) const {
  const auto steps = [&](int body) {
    return body == kWall || island.support[static_cast<std::size_t>(body)] == kStepped;
  };
  const ConeContact& c = island.contacts[contact];
  return steps(c.a) && steps(c.b) && lasts(island, contact);
}

template <class P>
void IslandImpulses<P>::press(Island& island, const SteppedFlight& next, double goal,
                              std::vector<double>& loads, double opens) const {
  std::vector<ConeContact> contacts;
  std::vector<std::size_t> number;
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    const ConeContact& c = island.contacts[k];
    const bool pressed = !motion_.elastic() && island.touches[k] != 0;
    if (!pressed && !holds(island, k)) continue;
    contacts.push_back(c);
    number.push_back(k);
  }
  const double rate = next.seconds > 0 ? 1 / next.way() : 0;
  ConeIsland whole(island.bodies, contacts, island.few);
  const std::vector<double> impulses = whole.resolve(island.bodies, rate, goal, opens);
  for (std::size_t k = 0; k < number.size(); ++k) loads[number[k]] += impulses[k];
}

template <class P>
bool IslandImpulses<P>::closes(const Island& island, std::size_t contact,
                               const SteppedFlight& next) const {
  const double gap = std::max(island.contacts[contact].gap, 0.0);
  return approach(island, contact) * next.way() > gap + kTouching * motion_.largest_radius();
}

template <class P>
bool IslandImpulses<P>::closes(const Island& island, const SteppedFlight& next) const {
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (closes(island, k, next) && holds(island, k)) return true;
  }
  return false;
}

template <class P>
void IslandImpulses<P>::keep_gaps(Island& island, double had, const SteppedFlight& next,
                                  double goal, std::vector<double>& loads) const {
  if (!motion_.keeps_energy() || loses() || !(next.seconds > 0)) return;
  for (int round = 0; round < kMostTurns && closes(island, next); ++round) {
    press(island, next, goal, loads);
    energy_.keep(island, had, next, loses());
  }
  // Where nothing else can move what it should keep is held: that is told, an overlap is not.
  if (closes(island, next)) press(island, next, goal, loads);
}

}  // namespace carom::event
