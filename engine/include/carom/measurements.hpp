#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "carom/vector.hpp"

namespace carom {

using Seconds = std::vector<std::pair<std::string, double>>;  ///< name and seconds, in order

/// What a simulation has gone through, and where it stands.
struct Measurements {
  std::uint64_t ball_ball = 0;         ///< impacts between balls
  std::uint64_t ball_wall = 0;         ///< impacts at walls
  std::uint64_t joint_impacts = 0;     ///< of several contacts at one instant
  std::uint64_t resting_contacts = 0;  ///< contacts that came to rest
  std::uint64_t jammed = 0;            ///< contacts in a gap of zero, with speed across it
  std::uint64_t islands_again = 0;     ///< parts of the plane that were solved again, see event
  std::uint64_t missed_hits = 0;       ///< balls passed through between two steps, at the least
  double energy_initial = 0;           ///< kinetic and potential
  double energy_final = 0;
  double kinetic_final = 0;      ///< the part of it that is motion; with a potential
  double energy_input = 0;       ///< by commands: balls added and removed, effects changed
  double energy_dissipated = 0;  ///< by restitution, friction and drag, each by its own formula
  double energy_largest = 0;     ///< in size, of those initially and at commands
  Vec2 momentum_initial{0, 0};
  Vec2 momentum_final{0, 0};
  double max_overlap = 0;  ///< deepest penetration seen / smaller radius of the two
  Seconds phases;          ///< wall-clock seconds of each phase of the crew
  Seconds effects;         ///< wall-clock seconds of each effect that is simulated
  double computing = 0;    ///< of several workers: wall-clock seconds in phases, all together
  double waiting = 0;      ///< and those of the run in which no work of one worker was done

  /// What nothing accounts for: |final - (initial + input - dissipated)| / the largest energy, that
  /// of the motion among them; the plain difference where that is zero.
  [[nodiscard]] double relative_energy_error() const;
};

}  // namespace carom
