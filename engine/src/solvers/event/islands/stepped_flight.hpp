#pragma once

namespace carom::event {

/// A flight of a ball of a contact island: straight, slowed by drag alone, in place of one that the
/// same force acts on all the time.
///
/// Rule: it begins with what the force makes in its first half, and at its end is owed the rest: so
/// it ends where the other one does, and the energy of its middle is that of the one before, to
/// second order in its length; without drag exactly, but for flights of different lengths, which
/// differ by the squares of what the force makes in half of each.
/// Units: what an acceleration of 1 makes, or how far a speed of 1 goes: seconds.
struct SteppedFlight {
  double seconds = 0;  ///< from its start to the next step
  double fading = 0;   ///< the rate of drag

  /// How far it goes in so many seconds.
  [[nodiscard]] double way(double elapsed) const;
  [[nodiscard]] double way() const { return way(seconds); }
  /// What it is given at its start.
  [[nodiscard]] double given() const;
  /// What it is owed after so many seconds; less than 0: it is ahead.
  [[nodiscard]] double owed(double elapsed) const;
  /// How far it will go till it has the energy that it is counted with; less than 0: it is past it.
  [[nodiscard]] double ahead(double elapsed) const;
};

/// What gravity has to do with a ball's flight as one of an island, up to some time.
struct GravityOfFlight {
  double owed = 0;   ///< see SteppedFlight
  double ahead = 0;  ///< the same
};

}  // namespace carom::event
