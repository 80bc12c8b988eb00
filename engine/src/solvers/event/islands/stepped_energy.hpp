#pragma once

#include <vector>

#include "numbers/scalar.hpp"
#include "solvers/event/islands/island_motion.hpp"

namespace carom::event {

/// The energy of contact islands but for their height, less what gravity has given ahead to balls
/// that are stepped.
///
/// Left out: a straight flight is, in its middle, lower than the path that bends all the time, by
/// a h^2 / 8 for an acceleration a.  So a ball that joins or leaves would gain or lose m (a h /
/// 2)^2 / 2.  Where nothing takes energy, each ball keeps that amount, and what contacts hold that
/// cannot move, beside its flight.
/// Holds: sums are rounded once, so that no order shows.
/// Units: those of the scene.  `next`: the flight that begins.
class SteppedEnergy {
 public:
  struct Rules {
    Vec<double> pull;     ///< gravity
    bool keeps = false;   ///< nothing loses energy at all
    double touching = 0;  ///< balls so near touch
    double still = 0;     ///< balls so slow are at rest, where nothing loses energy
    bool drifts = false;  ///< what nothing holds goes on along an axis as gravity makes it
  };
  explicit SteppedEnergy(const Rules& rules) : rules_(rules) {}

  /// Twice what it is.
  struct Parts {
    double stepped;
    double ahead;
    double others;
    double left_out;
    [[nodiscard]] double all() const { return stepped - ahead + others + left_out; }
  };
  [[nodiscard]] Parts of(const IslandMotion& island, const SteppedFlight& next) const;
  /// The same, of the flights so far.
  [[nodiscard]] double so_far(const IslandMotion& island) const;

  /// Twice what balls that were stepped, and leave the island, have more than before.
  [[nodiscard]] double of_leaving(const IslandMotion& island, const std::vector<ConeBody>& before,
                                  const std::vector<unsigned>& were) const;

  /// Twice what flights that end before their time may give back of what they are counted with too
  /// little.
  [[nodiscard]] double given_back(const IslandMotion& island, const std::vector<ConeBody>& before,
                                  const SteppedFlight& next) const;

  /// Notes of each ball what its flight is counted without.  `before`: how it moved before gravity
  /// and contacts did what they do in this flight.
  void leave_out(IslandMotion& island, const std::vector<ConeBody>& before,
                 const SteppedFlight& next) const;

  /// What the contacts of an island have taken is what it has less than it had.  That may be less
  /// than nothing: a ball that joins is given ahead a fall that a contact found later at the same
  /// instant takes back.
  [[nodiscard]] double loss(const IslandMotion& island, double had,
                            const SteppedFlight& next) const;

  /// What is left unsolved must not make energy: those that are stepped are slowed down to what
  /// there was, but for their drift along axes along which nothing holds them, which has what
  /// gravity gave it.  Where nothing loses any, all of the island keeps what it had, by one factor;
  /// if it `gives_up`, it may have less.  Whether anything is changed.  Where what is left out
  /// would slow the island down by much, less is; what has no way to go is not driven by its
  /// rounding.
  bool keep(IslandMotion& island, double had, const SteppedFlight& next, bool gives_up) const;

  /// Where nothing loses energy: what an island has less than it had, as none of it can move with
  /// that, stays with its stepped balls, by their masses, until some can.  Gives what is lost all
  /// the same.
  double hold(IslandMotion& island, double lost) const;

  /// Where nothing takes energy, what an island has lost beyond what its resting balls had is held
  /// by contacts that cannot move: they are jammed.
  [[nodiscard]] bool is_held(const IslandMotion& island, double lost) const;

 private:
  template <class Ahead>
  [[nodiscard]] Parts sum(const IslandMotion& island, const Ahead& ahead) const;
  /// Along axes along which nothing that never moves pushes an island, the motion of the centre of
  /// mass of what is stepped.
  struct Drift {
    Vec<double> velocity{0, 0};
    double energy = 0;  ///< twice what it has
    double most = 0;    ///< twice what it may have more than there is
  };
  [[nodiscard]] Drift drift_of(const IslandMotion& island, const SteppedFlight& next) const;
  /// See `keep`, where something loses energy.
  bool slow_down(IslandMotion& island, double had, const SteppedFlight& next) const;
  /// How many times as fast the island is to go, where nothing loses any.
  [[nodiscard]] double factor(const IslandMotion& island, const Parts& now, double had,
                              const SteppedFlight& next) const;
  /// Whether no contact closes beyond touching if all go `a` times as fast.
  [[nodiscard]] bool can_go(const IslandMotion& island, double a, double span) const;

  Rules rules_;
};

}  // namespace carom::event
