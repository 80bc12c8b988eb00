#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/crew.hpp"
#include "carom/impact.hpp"
#include "contact/disjoint_sets.hpp"
#include "contact/impact_log.hpp"
#include "contact/rest_rules.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/event/event_loop.hpp"
#include "solvers/event/groups/path.hpp"
#include "solvers/event/groups/region_pairs.hpp"

namespace carom::event {

/// Balls of a contact that lasts may be so much farther apart than those that touch.
inline constexpr double kWidest = 1 + 2 * kNear;

/// Balls solved by any number of workers, with the bits that one event loop over all balls has.
///
/// Time is cut into windows, each solved in these phases:
///
///     wall_computation    each worker: the paths of its balls through the window, walls only, and
///                         the box that each path sweeps
///     pair_computation    each worker: its share of the listed pairs: boxes first, then whether
///                         the paths meet
///     pair_resolution     balls that meet are a conflict group: each worker solves some groups
///                         exactly, by an event loop over the group's balls from the start of the
///                         window
///
/// Then pairs with a changed path are looked at again.  Groups that meet merge and are solved
/// again, until no two groups meet.
///
/// Why the bits are those of one event loop.  Paths and contact times are pure functions of
/// flights. Suppose that at the end no two groups meet, and let T be the first moment at which
/// one event loop over all balls has a ball do something else than its group did.  What a ball does
/// at T follows from the flights, up to T, of itself and of the balls that it meets or touches
/// then.  All of these have their true flights up to T.  One of another group would have been found
/// by the look at the two paths.  So all are in the ball's own group, which did the same at T: a
/// contradiction. Windows and groups come in nowhere: they decide what it costs.
///
/// A contact that lasts joins balls without an impact: those that touch at the start of a window
/// are a cluster, which is in one group or not at all, see `touch`.
///
/// Fixed balls never change.  They are of every group that comes to them, and join no groups.
///
/// Threads: `work` for the workers; the other members while no phase runs.  What a phase reads is
/// written by no other worker in it: a worker writes the paths of its balls, or of the members of
/// its groups, and its own desk.
template <class P>
class ConflictGroups {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;

  explicit ConflictGroups(const BasicRules<S>& rules);

  /// Takes these flights; `now` is not before any of their starts.  `left`: the fixed ball at which
  /// each began; kUnknown: none; empty: none.  `spins`: of the balls; empty: 0.
  void reset(const std::vector<Disk>& flights, At now, const std::vector<Index>& left,
             const std::vector<S>& spins);
  void set_workers(std::size_t workers) { desks_.resize(workers); }
  /// No window is longer; never(): they are as long as pays.
  void limit_window(At longest) { longest_ = longest; }
  /// Whether impacts are noted.
  void note_impacts(bool wanted) { notes_ = wanted; }
  /// Adds the impacts of the windows that have ended: times of the present epoch, `event` the same
  /// for the contacts of a joint one, else 0.
  void take_impacts(std::vector<Impact>& impacts);
  /// Gives the number of the phase to start with, Phase::kFrameDone where `until` is now.
  [[nodiscard]] std::size_t aim(At until);
  /// Counts time from `by` ticks later on.
  void rebase(At by);

  enum : std::size_t { kFly, kPairs, kResolve, kPhases };
  void work(std::size_t phase, Share share);
  /// What comes next: a phase, or Phase::kFrameDone when all is done up to the aim.
  [[nodiscard]] std::size_t finish(std::size_t phase);

  [[nodiscard]] At now() const { return now_; }
  [[nodiscard]] const Disk& flight(std::size_t ball) const {
    return tracks_[ball].path.back().flight;
  }
  [[nodiscard]] Index left(std::size_t ball) const { return tracks_[ball].path.back().left; }
  [[nodiscard]] const S& spin(std::size_t ball) const { return tracks_[ball].path.back().spin; }
  [[nodiscard]] const Motion<P>& motion() const { return *motion_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] Costs costs() const;
  /// The energy that impacts since `reset` have taken, and drag from flights that are over.
  [[nodiscard]] const std::vector<double>& losses() const { return lost_.parts(); }
  /// How often each ball was brought back round a periodic axis that gravity pulls along, since
  /// `reset`; empty for other axes.
  [[nodiscard]] const Turns& turns() const { return turns_; }
  [[nodiscard]] double given_ahead(At now) const;
  /// Who rests on this ball, or carries it, moves again.
  void wake_around(std::size_t ball, At now);

  /// Windows so far, how often groups were solved, and the largest group.
  [[nodiscard]] std::uint64_t windows() const { return windows_; }
  [[nodiscard]] std::uint64_t passes() const { return passes_; }
  [[nodiscard]] std::size_t largest() const { return largest_; }

 private:
  using Path = typename Paths<P>::Path;

  /// What is known of a ball in the present window.
  struct Track {
    Segment<P> first;             ///< what it begins the window with
    Path path;                    ///< from then on
    Bounds box;                   ///< swept by its centre
    std::vector<Impact> impacts;  ///< where they are noted, as `counts`
    std::vector<double> lost;     ///< energy, the same
    Counts counts;                ///< of the group it is the first of, or of it alone
    std::array<std::int64_t, 2> turns{0, 0};
    bool changed = false;  ///< since the pairs were looked at the last time
  };
  /// A pair whose paths meet, or of which one is in a contact that lasts.
  struct Encounter {
    Index first;
    Index second;
    bool lasts = false;  ///< the second
  };
  struct alignas(128) Desk {
    std::unique_ptr<EventLoop<P>> loop;
    Paths<P> paths;
    std::vector<Segment<P>> first;
    std::vector<Disk> flights;
    std::vector<Index> lefts;
    std::vector<S> spins;
    std::vector<Index> members;  ///< of the group that is solved, its fixed balls among them
    std::vector<Encounter> encounters;
    std::vector<Encounter> touching;
    ImpactLog log;
    std::vector<Index> solved;  ///< balls with new paths, since the last end of a window
    bool outside = false;       ///< a box is not in its region
    double pair_seconds = 0;
    double wall_seconds = 0;
  };
  struct Group {
    Index root;
    std::size_t size;
  };

  // Paths: conflict_groups_body.hpp.
  void fly(Share share);
  void begin(Track& track);
  [[nodiscard]] bool flies_on(const Segment<P>& segment) const;
  /// REQUIRES: the desk has its members.
  void solve(Index root, Desk& desk);
  void set_box(Index ball);

  // Pairs: path_meeting_body.hpp.
  void look_at_pairs(Share share);
  [[nodiscard]] bool same_group(Index i, Index j) const;
  [[nodiscard]] bool meet(Index i, Index j) const;
  [[nodiscard]] bool touch(Index i, Index j, const Disk& a, const Disk& b, At at) const;
  [[nodiscard]] bool lasts(Index i, Index j) const;

  // Windows.
  [[nodiscard]] std::size_t begin_window();
  [[nodiscard]] std::size_t after_flight();
  [[nodiscard]] std::size_t merge();
  static bool before(const Encounter& one, const Encounter& other);
  void join(Index i, Index j);
  void close(Index ball);
  [[nodiscard]] std::size_t end_window();
  void list_pairs();
  [[nodiscard]] bool any_outside();
  void measure_window();

  std::shared_ptr<const Motion<P>> motion_;
  std::vector<Track> tracks_;
  std::vector<Index> movers_;
  std::vector<char> fixed_;
  std::vector<double> radii_;
  std::vector<Desk> desks_;

  RegionPairs region_pairs_;
  std::vector<Bounds> regions_;
  double margin_ = 0;    ///< of a region around the path it was made for
  bool listed_ = false;  ///< the pairs of the present regions

  DisjointSets groups_;
  DisjointSets clusters_;
  std::vector<Encounter> supports_;              ///< balls and the fixed balls they touch, in order
  std::vector<std::vector<Index>> fixed_disks_;  ///< fixed balls of a group, by its root
  std::vector<Group> dirty_;                     ///< to be solved
  std::vector<char> is_dirty_;
  std::vector<char> lasts_;  ///< by root: a contact that lasts has brought the group together
  bool notes_ = false;
  std::vector<Impact> noted_;
  bool first_pass_ = false;

  Time now_ = 0;
  Time until_ = 0;  ///< the end of the present window
  Time target_ = 0;
  Time window_ = 1;  ///< as long as one should be
  Time usual_ = 1;   ///< a part of the time in which a ball meets another
  Time longest_ = P::Clock::never();
  bool full_ = false;       ///< it is not the aim that ends the present window
  std::size_t solved_ = 0;  ///< balls of all groups solved in this window
  std::size_t rounds_ = 0;  ///< passes in this window
  Counts counts_;
  Turns turns_;
  ExactSum<double> lost_;
  std::uint64_t windows_ = 0;
  std::uint64_t passes_ = 0;
  std::size_t largest_ = 0;
};

}  // namespace carom::event
