#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/impact_log.hpp"
#include "solvers/event/counts.hpp"
#include "solvers/event/disk.hpp"
#include "solvers/event/ended_flights.hpp"
#include "solvers/event/energy_book.hpp"
#include "solvers/event/event_costs.hpp"
#include "solvers/event/event_schedule.hpp"
#include "solvers/event/flights_before.hpp"
#include "solvers/event/groups/path.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/impact_notes.hpp"
#include "solvers/event/impact_writer.hpp"
#include "solvers/event/islands/found_island.hpp"
#include "solvers/event/islands/island_impact.hpp"
#include "solvers/event/islands/island_impulses.hpp"
#include "solvers/event/islands/island_search.hpp"
#include "solvers/event/islands/island_stepping.hpp"
#include "solvers/event/jam_watch.hpp"
#include "solvers/event/joint_impacts.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/neighbours.hpp"
#include "solvers/event/prediction.hpp"
#include "solvers/event/resolutions.hpp"
#include "solvers/event/simultaneous_choice.hpp"
#include "solvers/event/simultaneous_impact.hpp"
#include "solvers/event/simultaneous_pairs.hpp"
#include "solvers/event/step_clock.hpp"
#include "solvers/event/supports.hpp"
#include "solvers/event/ties.hpp"
#include "solvers/event/touch_search.hpp"
#include "state/totals.hpp"

namespace carom::event {

/// Balls and their impacts in the order of time.
///
/// Each ball keeps the earliest impact that is predicted for it; a pair is kept with both of its
/// balls where neither has anything earlier.  When a ball's partner is taken by an earlier event,
/// the ball keeps a lower bound on its next event and is predicted again at that time.
///
/// Impacts of the same tick that share a ball, and those that an impact passes on to balls that
/// touch, are resolved together, by rules that do not see an order.
///
/// Holds: for every pair, the earlier of the two balls' `meets` is not after their impact.
/// Errors: std::runtime_error where impacts follow each other without time passing, or next to
/// none.
/// Source: B. Lubachevsky, How to simulate billiards and similar systems, J. Comput. Phys. 94
/// (1991) 255: one event a ball; A. Donev, S. Torquato, F. Stillinger, J. Comput. Phys. 202 (2005)
/// 737: lists of neighbours that events renew.
template <class P>
class EventLoop {
 public:
  using S = typename P::Scalar;
  using Time = typename P::Time;
  using At = typename P::At;
  using Disk = typename P::Disk;

  explicit EventLoop(BasicRules<S> rules);
  /// Of some of `population` balls that others are of, too.
  EventLoop(std::shared_ptr<const Motion<P>> motion, std::size_t population);
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  /// Takes these flights, the others are forgotten; `now` is not before any of their starts.
  /// `left`: the fixed ball at which each flight began, kUnknown where there is none; empty:
  /// at none.  `spins`: of the balls, where the rules have spins; empty: 0.  `left_out`: see
  /// SteppedEnergy; empty: nothing is.
  void reset(const std::vector<Disk>& disks, At now, const std::vector<Index>& left = {},
             const std::vector<S>& spins = {}, const std::vector<double>& left_out = {});
  /// Everything up to `until` has happened then.
  void advance_to(At until);
  // The same, where several workers solve the islands of a step:
  //
  //     while (loop.advance_to_step(until)) {
  //       loop.begin_step();
  //       each k below loop.islands() once, by any worker: loop.solve_island(k);
  //       loop.end_step();
  //     }
  /// Gives whether a step is due, before which all has happened; else all up to `until` has.
  [[nodiscard]] bool advance_to_step(At until);
  void begin_step();
  [[nodiscard]] std::size_t islands() const { return stepped_.size(); }
  /// So many contacts are in the island.
  [[nodiscard]] std::size_t contacts(std::size_t island) const {
    return stepped_[island].found.contacts.size();
  }
  void solve_island(std::size_t k);
  void end_step();
  /// Counts time from `by` ticks later on; nothing else changes.
  void rebase(At by);

  [[nodiscard]] const HugeVector<Disk>& disks() const { return disks_; }
  /// Counter-clockwise, by ball; empty where the rules have none.
  [[nodiscard]] const std::vector<S>& spins() const { return spins_; }
  /// The fixed ball at which a flight began; kUnknown where there is none or it does not matter.
  [[nodiscard]] Index left(Index i) const { return left_.empty() ? kUnknown : left_[i]; }
  /// What a flight is counted without, where nothing takes energy; see SteppedEnergy.
  [[nodiscard]] double left_out(Index i) const { return left_out_.empty() ? 0 : left_out_[i]; }
  [[nodiscard]] JamWatch<typename P::Clock>& jam_watch() { return jam_watch_; }
  [[nodiscard]] const Motion<P>& motion() const { return motion_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  /// What has happened since the last time this was asked.
  [[nodiscard]] Counts take_counts() { return std::exchange(counts_, Counts{}); }
  /// From now on every flight that begins is noted.  `paths` must outlive it.
  void record(Paths<P>* paths) { paths_ = paths; }
  /// How often each flight since `reset` was brought back round a periodic axis that gravity pulls
  /// along; empty for other axes.
  [[nodiscard]] const Turns& turns() const { return ended_.turns(); }
  /// The energy that impacts since it was made have taken, and drag from flights that are over.
  /// Terms of which it is the exact sum.
  [[nodiscard]] const std::vector<double>& losses() const { return book_.parts(); }
  /// The same since the last time this was asked, as terms of an exact sum.
  [[nodiscard]] std::vector<double> take_lost() {
    return std::exchange(book_, EnergyBook{}).parts();
  }
  /// From a sample of the events, scaled to all.
  [[nodiscard]] Costs costs() const { return costs_.total(); }

  /// Where contacts rest: who rests on this ball, or carries it, moves again.
  void wake_around(Index i, At now) { supports_.wake_around(i, now); }
  /// The energy that gravity has given to islands ahead of what they will have fallen at their next
  /// step.
  [[nodiscard]] double given_ahead(At now) const;

  /// From now on every impact is noted, with its time since the present epoch began and the places
  /// of its balls in this event loop; null: no longer.  The log must outlive it.
  void note_in(ImpactLog* log) { notes_.write_to(log); }

 private:
  [[nodiscard]] S* spin(Index i) { return spins_.empty() ? nullptr : &spins_[i]; }
  [[nodiscard]] const S* spin(Index i) const { return spins_.empty() ? nullptr : &spins_[i]; }
  using Entry = typename EventSchedule<P>::Entry;
  using SimultaneousImpact = event::SimultaneousImpact<S>;
  using FoundIsland = event::FoundIsland<S>;

  // The order of time: event_loop_body.hpp.
  void next_event(Index i, At now);
  void take(const Entry& entry);
  [[nodiscard]] const Entry* first_event(At until);
  void fetch(std::span<const Entry> entries, std::span<const Entry> next,
             std::span<const Entry> after_next) const;

  // What events cost: loop_cost_body.hpp.
  void time_event(Index i, At now);

  // Impacts: loop_impact_body.hpp.
  void meet(Index i, At now);
  [[nodiscard]] bool moves(Index partner) const {
    return partner < kFirstMark && !motion_.fixed(disks_[partner]);
  }
  void meet_alone(Index i, Index partner, At now);
  void predict(Index i, At now);
  void predict_again(Index i, At now);
  void end_flight(Index i, At now);
  void watch(At now);

  // Impacts of one instant that share a ball: loop_simultaneous_body.hpp, loop_undo_body.hpp; what
  // they do, loop_joint_body.hpp.
  void begin_simultaneous();
  void remember(Index i);
  /// Takes back what was resolved with these balls at the present instant; adds the balls to them.
  void take_back(std::vector<Index>& balls);
  /// Whether the ball, looked at only now, meets at this instant one that has been hit at it; then
  /// both wait to be resolved.
  [[nodiscard]] bool is_late(Index i, At now);
  void resolve_waiting();
  void resolve_together(std::vector<Pair> alone, const std::vector<Pair>& joint, At now);
  void settle_pressed();
  /// The moving ones of all that touches these now, and these.
  [[nodiscard]] std::vector<Index> with_all_that_touches(std::vector<Index> balls, At now) const;
  [[nodiscard]] std::vector<SimultaneousImpact> groups_of(std::vector<Index>& to_predict, At now);
  void resolve_alone(Index i, Index partner, At now);
  /// One impact, of balls that have been remembered: it is booked and noted.
  void meet_and_note(Index i, Index partner, At now);
  void predict_changed(At now);
  /// `to_predict`: the balls whose next impact is unknown.
  void resolve_group(SimultaneousImpact& group, const std::vector<Index>& to_predict, At now);
  /// What is taken as jammed in vain: see JamLevel.
  [[nodiscard]] bool gives_up() const { return jam_watch_.level().gives_up(); }

  // Contacts that rest: loop_rest_body.hpp.
  void start_resting(At now);
  void schedule_step(At now);
  void settle(Index i, At now);
  [[nodiscard]] bool is_of_island(const SimultaneousImpact& group, At now) const;
  // Contact islands: loop_island_body.hpp.
  [[nodiscard]] bool is_hit_of_island(Index i, Index partner, At now) const;
  /// `hits`: balls that meet something at the present instant, those of one group together.
  void hit_islands(const std::vector<std::vector<Index>>& hits, At now);
  /// A step of an island that nothing hits in it.
  void step_island(FoundIsland& island, IslandChange& change) const;
  /// Counts, books and notes what has happened to an island, which flies on.
  void take_on(const FoundIsland& island, const IslandChange& change, At now);
  [[nodiscard]] bool stands(const Disk& disk, const Vec<S>& at) const {
    return motion_.support(disk) == kResting && disk.x == at.x && disk.y == at.y;
  }
  /// Every member begins the flight that `island` says, by its `support`; in a large one what
  /// stands as before goes on.  Gives what was lost.
  double fly_on(const FoundIsland& island, At now);

  /// An island that is stepped now.
  struct Stepped {
    FoundIsland found;
    IslandChange change;
    double seconds = 0;
  };

  std::shared_ptr<const Motion<P>> shared_motion_;
  const Motion<P>& motion_ = *shared_motion_;
  std::size_t population_ = 0;  ///< of which the balls are a part; 0: none
  Paths<P>* paths_ = nullptr;
  HugeVector<Disk> disks_;
  std::vector<S> spins_;
  Neighbours<P> neighbours_{motion_};
  EventSchedule<P> schedule_{motion_, disks_};
  Counts counts_;
  EnergyBook book_;
  ImpactNotes notes_;
  ImpactWriter<P> writer_{motion_, disks_, notes_};
  EndedFlights<P> ended_{motion_, book_};
  EventCosts costs_;
  StepClock<typename P::Clock> step_clock_;
  /// The fixed ball a flight began at; only where balls fall on fixed disks.
  std::vector<Index> left_;
  std::vector<double> left_out_;  ///< see SteppedEnergy; only where nothing takes energy
  Time impact_time_ = 0;          ///< of the last impact: the present instant
  SimultaneousPairs pairs_;       ///< of that instant
  Resolutions resolutions_{counts_, book_, notes_};
  FlightsBefore<P> before_;
  Ties<typename P::Clock> ties_;
  std::vector<Index> changed_;  ///< balls whose next impact is to be looked for
  JamWatch<typename P::Clock> jam_watch_;
  Prediction<P> prediction_{
      motion_, {disks_, spins_, left_, step_clock_.next()}, neighbours_, ties_};
  TouchSearch<P> touch_search_{
      motion_, {disks_, spins_, neighbours_, prediction_}, pairs_, jam_watch_.level()};
  Supports<P> supports_{motion_, {disks_, spins_, left_, left_out_}, neighbours_, counts_, book_};
  JointImpacts<P> joint_impacts_{motion_, {disks_, spins_, left_}};
  SimultaneousChoice<P> choice_{
      motion_, {disks_, prediction_}, {pairs_, resolutions_, ties_, jam_watch_.level()}};
  IslandSearch<P> island_search_{
      motion_, {disks_, spins_, step_clock_.next(), left_out_}, neighbours_};
  IslandImpulses<P> island_impulses_{motion_, jam_watch_.level()};
  IslandImpact<P> island_impact_{motion_, disks_, island_impulses_};
  IslandStepping<P> island_stepping_{motion_, disks_, island_impulses_};
  std::vector<Stepped> stepped_;
  Time step_time_ = 0;  ///< of these
};

}  // namespace carom::event
