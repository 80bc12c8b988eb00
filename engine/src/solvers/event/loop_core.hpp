#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "solvers/event/core.hpp"
#include "solvers/event/crossing_time.hpp"
#include "solvers/event/domains/domains.hpp"
#include "solvers/event/event_loop.hpp"
#include "solvers/event/groups/conflict_groups.hpp"
#include "solvers/event/places_in_memory.hpp"

namespace carom::event {

/// The core that chooses between three ways to the same bits: domains of the plane where balls are
/// many and nothing comes to rest, conflict groups for several workers, one event loop else.
///
/// Threads: all ways have the phases
///
///     wall_computation    where there are walls, else "flight": see Domains and ConflictGroups
///     pair_computation    only with collisions
///     pair_resolution     only with collisions
///
/// With one event loop the workers do the last of them in turn, for a frame or a few steps of
/// contact islands, while the others wait, up to a step that is worth sharing; in pair_computation
/// each worker then solves some of its islands.
template <class P>
class LoopCore final : public Core {
 public:
  explicit LoopCore(CoreStart start);

  [[nodiscard]] std::vector<Phase> phases() override;
  [[nodiscard]] std::size_t aim(double time) override;
  void set_workers(std::size_t workers) override;
  void add(const Ball& ball) override;
  void remove(std::size_t ball) override;
  void set(const Domain& domain, const Effects& effects, bool bends) override;
  [[nodiscard]] const std::vector<Ball>& balls() const override { return balls_; }
  using Core::read_balls;
  void read_balls(std::size_t first, std::span<Ball> balls) const override;
  [[nodiscard]] std::vector<ExactPosition> exact_positions() const override;
  [[nodiscard]] Turns turns() const override { return turns(true); }
  [[nodiscard]] double energy_ahead() const override;
  [[nodiscard]] double dissipated() const override;
  [[nodiscard]] std::vector<double> losses() const override;
  void go_on_from_losses(const std::vector<double>& losses) override;
  [[nodiscard]] Tally tally() const override;
  void save(Continuation& continuation) const override;
  void visit_flights(const std::function<void(const SavedFlight&)>& visit) const override;
  void record_impacts(bool wanted) override;
  void take_impacts(std::vector<Impact>& impacts) override;
  void tell_slides(std::size_t ball, std::vector<Impact>& impacts) const override;

 private:
  using S = typename P::Scalar;
  using Disk = typename P::Disk;

  /// A moment: whole epochs, and ticks of the present one.
  struct Moment {
    double epoch = 0;
    typename P::Time ticks = 0;
  };

  [[nodiscard]] Disk flight_of(const Ball& ball) const;
  [[nodiscard]] Moment moment(const S& seconds) const;
  /// In more digits flights are so slow that domains never have enough balls.
  static constexpr bool kShares = kIsDouble<S>;

  /// Over the epochs of time up to the target, by domains or conflict groups.
  template <class Solved>
  [[nodiscard]] std::size_t aim_way(Solved& way);
  template <class Solved>
  [[nodiscard]] std::size_t finish_way(Solved& way, std::size_t phase);
  [[nodiscard]] std::size_t finish_domains(std::size_t phase) requires kShares;
  [[nodiscard]] bool may_use_domains() const;
  /// How many balls are not fixed.
  [[nodiscard]] std::size_t movers() const;
  void work(std::size_t phase, Share share);
  [[nodiscard]] std::size_t finish_phase(std::size_t phase);
  enum class Way { loop, groups, domains };
  [[nodiscard]] Way choose_way() const;
  void sort_again();
  [[nodiscard]] Disk flight(std::size_t ball) const;
  /// The fixed ball at which the flight began; kUnknown: none.
  [[nodiscard]] Index left(std::size_t ball) const;
  /// What its flight is counted without, as a part of an island.
  [[nodiscard]] double left_out(std::size_t ball) const;
  /// None where balls have no friction.
  [[nodiscard]] std::optional<S> spin(std::size_t ball) const;
  [[nodiscard]] const Motion<P>& motion() const;
  [[nodiscard]] Counts counts() const;
  [[nodiscard]] Costs costs() const;
  /// Up to the target, or to a step whose islands are to be solved by all workers.
  void advance();
  [[nodiscard]] bool shares_step() const;
  void land();
  /// Nothing moves or falls: nothing will ever happen.
  [[nodiscard]] bool all_is_still() const;
  /// Time goes on to this moment, while nothing moves.
  /// REQUIRES: landed.
  void go_on_to(const Moment& moment);
  /// Takes the clock of what moves now.
  /// REQUIRES: landed; all was still.
  void take_clock();
  /// Notes that a ball at rest, with its number from now on, moves again.
  void tell_wake(std::size_t ball, const Disk& disk);
  /// How often each ball was brought back round a periodic axis that gravity pulls along, in the
  /// flights that are over, and in the present ones if so asked.
  [[nodiscard]] Turns turns(bool of_present_flights) const;
  [[nodiscard]] ExactSum<double> lost() const;
  /// What drag and sliding have taken from the present flights till now; where domains do not count
  /// it by flights, since they began.
  [[nodiscard]] double present_losses() const;
  void leave_out_present_losses();
  void start();
  void take_flights(const Continuation& from, const std::string& source);
  void collect_log();

  Domain domain_;
  Effects effects_;
  std::vector<Ball> balls_;         // as they were at the last `land`
  std::vector<Disk> flights_;       // of the balls, in their order, while there is no event loop
  std::vector<S> spins_;            // of the balls, in their order, where they have friction
  bool rests_ = false;              // contacts can come to rest
  std::vector<Index> left_;         // the fixed ball at which each began, by number
  std::vector<unsigned> supports_;  // what carries each, where contacts can rest
  std::vector<double> left_outs_;   // see SteppedEnergy
  std::vector<Index> slot_;         // where in the event loop a ball is
  typename P::Clock scale_;
  bool was_still_ = false;  // at the last `land`: the clock is of nothing that moves
  Sharing sharing_;
  bool no_domains_ = false;                    // they did not get on
  std::size_t turn_ = 0;                       // the worker that does the event loop
  bool hands_on_ = false;                      // to the next one
  bool stepping_ = false;                      // islands are solved by all workers,
  std::atomic<std::size_t> taken_{0};          // so many of them so far
  std::unique_ptr<EventLoop<P>> loop_;         // all balls,
  std::unique_ptr<Domains<P>> domains_;        // or those of domains,
  std::unique_ptr<ConflictGroups<P>> groups_;  // or those that meet
  std::size_t workers_ = 1;
  std::uint64_t again_ = 0;  // solved again by domains that are gone
  Counts before_;            // counted in event loops that are gone
  Costs costs_before_;
  ExactSum<double> lost_before_;  // energy
  double domains_energy_ = 0;     // kinetic, as they began,
  Moment domains_began_;          // then
  Turns turns_before_;            // in the order of the balls
  Moment now_;
  Moment target_;
  ImpactLog log_;              // of the event loop, in the present epoch
  std::vector<Impact> noted_;  // by the numbers of the balls
};

}  // namespace carom::event
