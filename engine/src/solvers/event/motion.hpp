#pragma once

#include <array>
#include <limits>
#include <vector>

#include "contact/event_scalar.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/ticks.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// Radius and mass, shared by all balls that have the same.
struct Kind {
  double radius = 0.5;
  double inverse_mass = 1;  ///< 0: fixed

  [[nodiscard]] bool fixed() const { return inverse_mass == 0; }
};

/// What moves and stops the balls.
struct Rules {
  Domain domain;
  TickScale scale;
  std::array<double, 2> gravity{0, 0};
  bool collisions = true;
  double restitution = 1;
  double wall_restitution = 1;
  std::vector<Kind> kinds{Kind{}};
};

/// The end of a flight: with what, and when.
struct Meeting {
  Ticks time = kNever;
  Index partner = kUnknown;
};

/// Flights and impacts: pure functions of one flight or two.
///
/// Holds: no result depends on when it is asked for, nor on the order of a pair.
class Motion {
 public:
  explicit Motion(Rules rules);

  /// Where a flight is at `now`, not wrapped.
  [[nodiscard]] Vec<double> place(const Disk& disk, Ticks now) const;
  [[nodiscard]] Vec<double> velocity(const Disk& disk, Ticks now) const;
  /// From a to b, the shorter way round periodic axes.
  [[nodiscard]] Vec<double> way(const Vec<double>& a, const Vec<double>& b) const;
  [[nodiscard]] Vec<double> wrapped(const Vec<double>& at) const;

  /// When two balls meet; one of them may be fixed.  `from_contact`: the flight of the one that is
  /// not fixed began with an impact of the two.
  [[nodiscard]] Ticks pair_meets(const Disk& a, const Disk& b, bool from_contact = false) const;
  /// When a ball meets a wall, or has flown so far that its flight starts anew.
  [[nodiscard]] Meeting alone(const Disk& disk) const;

  /// Starts the flight anew where it is at `now`.
  void carry(Disk& disk, Ticks now) const;
  void bounce(Disk& disk, Index wall, Ticks now) const;
  /// The impact of two balls; gives how deep they overlapped, as a part of the smaller radius.
  double strike(Disk& a, Disk& b, Ticks now) const;

  [[nodiscard]] const Rules& rules() const { return rules_; }
  [[nodiscard]] const Kind& kind(const Disk& disk) const { return rules_.kinds[disk.kind]; }
  [[nodiscard]] bool fixed(const Disk& disk) const { return kind(disk).fixed(); }
  [[nodiscard]] bool falls() const { return falls_; }
  [[nodiscard]] bool one_kind() const { return rules_.kinds.size() == 1; }
  [[nodiscard]] double largest_radius() const { return largest_radius_; }
  /// Lengths of the axes, infinite where an axis is not periodic.
  [[nodiscard]] const std::array<double, 2>& periods() const { return periods_; }

  /// How far a place is from touching a wall (negative: beyond), and where touching leaves it.
  struct Wall {
    double gap;
    double stop;
  };
  [[nodiscard]] Wall wall(const Disk& disk, const Vec<double>& at, Index wall) const;
  /// When it meets this wall.
  [[nodiscard]] Ticks wall_meets(const Disk& disk, Index wall) const;

 private:
  [[nodiscard]] Meeting wall_meeting(const Disk& disk, std::size_t axis) const;

  Rules rules_;
  std::array<double, 2> periods_;
  std::array<double, 2> reach_;  ///< how far along a periodic axis a flight may go
  double largest_radius_ = 0;
  bool falls_;
};

}  // namespace carom::event
