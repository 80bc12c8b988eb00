#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "carom/crew.hpp"
#include "carom/impact.hpp"
#include "solvers/event/groups/conflict_sets.hpp"
#include "solvers/event/groups/group_loop.hpp"
#include "solvers/event/groups/merge_forecast.hpp"
#include "solvers/event/groups/path.hpp"
#include "solvers/event/groups/path_meeting.hpp"
#include "solvers/event/groups/region_pairs.hpp"
#include "solvers/event/groups/tracks.hpp"
#include "solvers/event/groups/window_book.hpp"
#include "solvers/event/groups/window_length.hpp"

namespace carom::event {

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
///                         window; the largest is solved by who has had least to solve
///
/// Then pairs with a changed path are looked at again.  Groups that meet merge and are solved
/// again, until no two groups meet.  What changes in such a pass is often little: where it takes
/// less time than to wake all workers, the last one to arrive does it while the others wait.
///
/// Why the bits are those of one event loop.  Paths and contact times are pure functions of
/// flights. Suppose that at the end no two groups meet, and let T be the first moment at which
/// one event loop over all balls has a ball do something else than its group did.  What a ball does
/// at T follows from the flights, up to T, of itself and of the balls that it meets or touches
/// then.  All of these have their true flights up to T.  One of another group would have been found
/// by the test of the two paths.  So all are in the ball's own group, which did the same at T: a
/// contradiction. Windows and groups do not matter for the result: they decide what it costs.
///
/// A contact that lasts joins balls without an impact: those that touch at the start of a window
/// are in one group or in none.  Fixed balls never change.
///
/// What is known of each ball: tracks.hpp; which balls are of one group: conflict_sets.hpp; how one
/// is solved: group_loop.hpp; whether two paths meet: path_meeting.hpp; how long a window is:
/// window_length.hpp; whether near balls are one group before they meet: merge_forecast.hpp.
///
/// Threads: `work` for the workers; the other members while no phase runs.  What a phase reads is
/// written by no other worker in it: a worker writes the paths of its balls, or of the members of
/// its groups, and its own workspace.
template <class P>
class ConflictGroups {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;

  explicit ConflictGroups(const BasicRules<S>& rules);
  ConflictGroups(const ConflictGroups&) = delete;
  ConflictGroups& operator=(const ConflictGroups&) = delete;

  /// Takes these flights; `now` is not before any of their starts.  `left`: the fixed ball at which
  /// each began; kUnknown: none; empty: none.  `spins`: of the balls; empty: 0.
  void reset(const std::vector<Disk>& flights, At now, const std::vector<Index>& left,
             const std::vector<S>& spins);
  void set_workers(std::size_t workers) { workspaces_.resize(workers); }
  /// No window is longer; never(): they are as long as pays.
  void limit_window(At longest) { length_.limit(longest); }
  /// Whether impacts are noted.
  void note_impacts(bool wanted) { notes_ = wanted; }
  /// Adds the impacts of the windows that have ended: times of the present epoch, `event` the same
  /// for the contacts of a joint one, else 0.
  void take_impacts(std::vector<Impact>& impacts) { book_.take_impacts(impacts); }
  /// Gives the number of the phase to start with, Phase::kFrameDone where `until` is now.
  [[nodiscard]] std::size_t aim(At until);
  /// Counts time from `by` ticks later on.
  void rebase(At by);

  enum : std::size_t { kFly, kPairs, kResolve, kPhases };
  void work(std::size_t phase, Share share);
  /// What comes next: a phase, or Phase::kFrameDone when all is done up to the aim.
  [[nodiscard]] std::size_t finish(std::size_t phase);

  [[nodiscard]] At now() const { return now_; }
  [[nodiscard]] const Disk& flight(std::size_t ball) const { return tracks_.last(ball).flight; }
  [[nodiscard]] Index left(std::size_t ball) const { return tracks_.last(ball).left; }
  [[nodiscard]] const S& spin(std::size_t ball) const { return tracks_.last(ball).spin; }
  [[nodiscard]] const Motion<P>& motion() const { return *motion_; }
  [[nodiscard]] const Counts& counts() const { return book_.counts(); }
  [[nodiscard]] Costs costs() const;
  /// The energy that impacts since `reset` have taken, and drag from flights that are over.
  [[nodiscard]] const std::vector<double>& losses() const { return book_.losses(); }
  /// How often each ball was brought back round a periodic axis that gravity pulls along, since
  /// `reset`; empty for other axes.
  [[nodiscard]] const Turns& turns() const { return book_.turns(); }
  [[nodiscard]] double given_ahead(At now) const { return tracks_.given_ahead(now); }
  /// Balls that rest on this one, or carry it, move again.
  void wake_around(std::size_t ball, At now) { tracks_.wake_around(ball, now); }

  /// Windows so far, how often groups were solved, and the largest group.
  [[nodiscard]] std::uint64_t windows() const { return windows_; }
  [[nodiscard]] std::uint64_t passes() const { return passes_; }
  [[nodiscard]] std::size_t largest() const { return largest_; }

 private:
  using Track = typename Tracks<P>::Track;
  using PathBall = typename Tracks<P>::PathBall;

  struct alignas(128) Workspace {
    GroupLoop<P> loop;
    std::vector<Encounter> encounters;
    std::vector<Encounter> touching;
    std::vector<Index> solved;  ///< balls with new paths, since the last end of a window
    bool outside = false;       ///< a box is not in its region
    std::size_t burden = 0;     ///< the balls of all groups that it has solved
    double pair_seconds = 0;
    double wall_seconds = 0;
  };

  // The phases.
  void fly(Share share);
  void test_pairs(Share share);
  void resolve(Share share);
  // What is done between two phases; each gives the next one.
  [[nodiscard]] std::size_t after(std::size_t phase);
  [[nodiscard]] std::size_t begin_window();
  [[nodiscard]] std::size_t after_flight();
  [[nodiscard]] std::size_t merge();
  void take_turns();
  [[nodiscard]] std::size_t end_window();
  /// Whether the phase, after the first pass, takes less time than to wake all workers for it.
  [[nodiscard]] bool is_short(std::size_t phase) const;

  /// REQUIRES: the workspace's loop has its members.
  void solve(Index root, Workspace& workspace);
  void list_pairs();
  [[nodiscard]] bool any_outside() const;
  void measure();

  std::shared_ptr<const Motion<P>> motion_;
  Tracks<P> tracks_;
  std::vector<Workspace> workspaces_;

  RegionPairs region_pairs_;
  double margin_ = 0;    ///< of a region around the path it was made for
  bool listed_ = false;  ///< the pairs of the present regions

  ConflictSets sets_;
  std::vector<ConflictSets::Group> dirty_;  ///< to be solved
  bool notes_ = false;
  bool first_pass_ = false;
  std::size_t to_solve_ = 0;  ///< balls of the groups that are dirty
  std::size_t least_burdened_ = 0;
  bool heap_ = false;  ///< most balls were one group that stays together, in the present window

  Time now_ = 0;
  Time until_ = 0;  ///< the end of the present window
  Time target_ = 0;
  WindowLength<P> length_;
  typename WindowLength<P>::Cost cost_;  ///< of the present window
  MergeForecast merges_;
  WindowBook book_;
  std::uint64_t windows_ = 0;
  std::uint64_t passes_ = 0;
  std::size_t largest_ = 0;
};

}  // namespace carom::event
