#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "carom/crew.hpp"
#include "solvers/event/core.hpp"
#include "solvers/event/part.hpp"
#include "solvers/event/regions.hpp"
#include "solvers/event/tile.hpp"

namespace carom::event {

/// Balls solved by several workers at once, with the bits that one tile of all of them has.
///
/// Time is cut into windows.  The plane is cut into regions, each solved by one worker: a part, a
/// tile of the balls in the region, which it owns, and of copies of those in a halo around it.
/// Within a window the parts know nothing of each other; then every copy is compared with its
/// owner's version, flight by flight.  Where a copy came to differ and may since have touched a
/// ball of the part, the window ends just before: what came after is undone in all parts and solved
/// again, with the copies corrected.  Every few windows the balls are shared out anew.
///
/// Why the bits are those of one tile.  Let T be the first moment at which an owner has its ball do
/// something else than one tile would, and let the window not have been cut before T.  What a ball
/// does at T follows from the flights, up to T, of itself and of all that touch it at T, directly
/// or over others that touch.  The owner's version of the ball is true up to T.  Now look at a ball
/// that touches it.  Since the balls were shared out none has gone farther than `budget` (the
/// greatest speed of all flights times the time, summed up and checked after each window), and the
/// halo is two radii and two budgets wide: so the part has that ball.  If it owns it, it has its
/// true flight. If it has a copy, the copy equals its owner's version up to T, and so is true:
/// otherwise it came to differ at some D < T, and at the end of the window `near` found no owned
/// ball within the radii and all that either version and the owned ball can have gone since D,
/// which leaves them no time to touch.  Where more than two touch, each copy among them is compared
/// at T too, with a fingerprint of the whole group: a group that is not the same in both parts
/// counts as a difference at T of a copy that touches an owned ball, and cuts the window before T.
/// So the owner had its ball do at T what one tile would, against the assumption.  Regions, halos
/// and windows come in nowhere: they decide what it costs.
///
/// The rule for the length of a window looks only at how often one was cut short, for no better
/// reason than that a run then takes the same course every time.
///
/// Threads: `phases` for the workers; the other members while no phase runs.
template <class P>
class Windows {
 public:
  using Disk = typename P::Disk;

  Windows(const Rules& rules, const Sharing& sharing);

  /// Takes these flights; `now` is not before any of their starts.
  void reset(std::vector<Disk> flights, Ticks now);
  /// Gives the number of the phase to start with, Phase::kFrameDone where `until` is now.
  [[nodiscard]] std::size_t aim(Ticks until);
  void rebase(Ticks by);

  /// The phases' work, by number, and what comes after: a phase, or Phase::kFrameDone when all is
  /// done up to the aim, or no more can be done by windows.
  enum : std::size_t { kIslands, kHalos, kImpacts, kCheck, kUndo, kPhases };
  void work(std::size_t phase, Share share);
  [[nodiscard]] std::size_t finish(std::size_t phase);

  /// Windows became so short that one tile is faster; everything up to `now` is done.
  [[nodiscard]] bool stuck() const { return stuck_; }
  [[nodiscard]] Ticks now() const { return now_; }
  [[nodiscard]] const Disk& flight(Index ball) const;
  [[nodiscard]] const Motion<P>& motion() const { return motion_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  /// Parts of which something was undone and solved again; and windows so far.
  [[nodiscard]] std::uint64_t solved_again() const { return again_; }
  [[nodiscard]] std::uint64_t windows() const { return windows_; }
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] Costs costs() const;

 private:
  [[nodiscard]] std::size_t next();
  [[nodiscard]] std::size_t begin_window();
  [[nodiscard]] std::size_t judge();
  void choose_rims();
  void note_speed();

  Motion<P> motion_;
  Sharing sharing_;
  std::vector<std::unique_ptr<Part<P>>> parts_;
  std::vector<const Part<P>*> readers_;
  std::optional<Regions> regions_;

  // Since the balls were shared out:
  Ticks shared_at_ = 0;
  double budget_ = 0;     ///< how far a ball may go
  double used_ = 0;       ///< how far one may have gone
  double speed_ = 0;      ///< of the fastest flight
  double halo_ = 0;       ///< a part has copies of all balls this near to its region
  double travelled_ = 0;  ///< how far a ball may have gone between the last two times

  std::vector<Disk> flights_;  // until the parts have taken them
  std::vector<Vec<double>> places_;
  double pitch_ = 1;  ///< from ball to ball
  Ticks now_ = 0;
  Ticks until_ = 0;  ///< the end of the present window
  Ticks target_ = 0;
  Ticks window_ = 1;   ///< as long as one should be
  bool full_ = false;  ///< it is not the aim that ends the present window
  bool cut_ = false;   ///< the present window was cut short
  bool stuck_ = false;
  Counts counts_;
  std::uint64_t halves_ = 0;  ///< of impacts between balls: one for each of the two
  std::uint64_t again_ = 0;
  std::uint64_t windows_ = 0;
  double yield_ = 0;  ///< events of a window, over the last ones
};

}  // namespace carom::event
