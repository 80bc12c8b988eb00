#pragma once

#include <array>

#include "contact/event_scalar.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/physics.hpp"
#include "solvers/event/room.hpp"
#include "solvers/event/rules.hpp"

namespace carom::event {

/// The end of a flight: with what, and when.
template <class P>
struct Meeting {
  typename P::Time time = P::Clock::never();
  Index partner = kUnknown;
};

/// Flights and impacts: pure functions of one flight or two.
///
/// Holds: no result depends on when it is asked for, nor on the order of a pair.
template <class P>
class Motion {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Kind = BasicKind<S>;
  using Rules = BasicRules<S>;

  explicit Motion(Rules rules);

  /// Where a flight is at `now`, not wrapped.
  [[nodiscard]] Vec<S> place(const Disk& disk, At now) const;
  [[nodiscard]] Vec<S> velocity(const Disk& disk, At now) const;
  /// From a to b, the shorter way round periodic axes.
  [[nodiscard]] Vec<S> way(const Vec<S>& a, const Vec<S>& b) const;
  [[nodiscard]] Vec<S> wrapped(const Vec<S>& at) const;

  /// When two balls meet; one of them may be fixed.  `from_contact`: the flight of the one that is
  /// not fixed began with an impact of the two.
  [[nodiscard]] Time pair_meets(const Disk& a, const Disk& b, bool from_contact = false) const;
  /// When a ball meets a wall, or has flown so far that its flight starts anew.
  [[nodiscard]] Meeting<P> alone(const Disk& disk) const;

  /// Starts the flight anew where it is at `now`.
  void carry(Disk& disk, At now) const;
  void bounce(Disk& disk, Index wall, At now) const;
  /// The impact of two balls; gives how deep they overlapped, as a part of the smaller radius.
  double strike(Disk& a, Disk& b, At now) const;

  [[nodiscard]] const Rules& rules() const { return rules_; }
  [[nodiscard]] const typename P::Law& law() const { return law_; }
  [[nodiscard]] const Room<S>& room() const { return room_; }
  [[nodiscard]] const Kind& kind(const Disk& disk) const { return rules_.kinds[disk.kind]; }
  [[nodiscard]] bool fixed(const Disk& disk) const { return kind(disk).fixed(); }
  [[nodiscard]] bool one_kind() const { return rules_.kinds.size() == 1; }
  [[nodiscard]] double largest_radius() const { return largest_radius_; }
  [[nodiscard]] const std::array<S, 2>& periods() const { return room_.periods(); }

  /// How far a place is from touching a wall (negative: beyond), and where touching leaves it.
  struct Wall {
    S gap;
    S stop;
  };
  [[nodiscard]] Wall wall(const Disk& disk, const Vec<S>& at, Index wall) const;
  /// When it meets this wall.
  [[nodiscard]] Time wall_meets(const Disk& disk, Index wall) const;

 private:
  [[nodiscard]] Meeting<P> wall_meeting(const Disk& disk, std::size_t axis) const;

  Rules rules_;
  typename P::Law law_;
  Room<S> room_;
  std::array<S, 2> reach_;  ///< how far along a periodic axis a flight may go
  double largest_radius_ = 0;
};

}  // namespace carom::event
