#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "solvers/event/tile.hpp"
#include "solvers/event/windows.hpp"
#include "solvers/solver.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom {

/// Method `event`: balls fly on their closed-form paths from impact to impact, in the order of
/// time.  There is no step; a frame only looks.
///
/// Holds: the same bits at any frame rate, number of workers and order in memory.
/// Threads: where there are many balls and several workers they share the plane, see
/// event::Windows, with the phases
///
///     islands     each worker: which of its balls the other parts need
///     halos       each worker: takes those into its parts
///     impacts     each worker: solves its parts over a window
///     check       each worker: compares its copies with their owners
///     undo        each worker: takes back what came after the first difference
///
/// Else one worker does the impacts and the others wait.
template <class P>
class EventSolver final : public Solver {
 public:
  using Choice = typename event::Windows<P>::Choice;

  /// `choice`: how the plane is shared, where that is not left to the solver.
  EventSolver(const Scene& scene, std::vector<Ball> balls, const Choice& choice = {});
  /// Goes on from where another has stopped, by other physics of the same numbers; what that one
  /// had counted is counted here.
  template <class Other>
  explicit EventSolver(EventSolver<Other>& other)
      : domain_((other.land(), other.domain_)),
        effects_(other.effects_),
        balls_(std::move(other.balls_)),
        flights_(std::move(other.flights_)),
        left_(std::move(other.left_)),
        scale_(other.scale_),
        again_(other.again_),
        before_(other.before_),
        costs_before_(other.costs_before_),
        turns_before_(std::move(other.turns_before_)),
        now_{other.now_.era, other.now_.ticks},
        target_(now_) {
    start();
    for (const event::Index slot : slot_) {
      if (motion().carried(tile_->disks()[slot]) != 0) ++before_.resting_contacts;
    }
  }

  [[nodiscard]] std::vector<Phase> phases() override;
  void set_workers(std::size_t) override {}
  [[nodiscard]] std::size_t aim(double time) override;
  void add(const Ball& ball) override;
  void remove(std::size_t ball) override;
  void set(const Effects& effects) override;
  void set_step(double) override {}
  [[nodiscard]] std::size_t balls() const override { return balls_.size(); }
  [[nodiscard]] std::vector<Ball> state() const override;
  [[nodiscard]] std::vector<ExactPosition> exact_positions() const override;
  [[nodiscard]] std::string state_hash() const override;
  [[nodiscard]] double energy() const override;
  [[nodiscard]] Vec2 momentum() const override;
  void count(Measurements& measurements) const override;
  void save(Scene& scene) const override;
  /// Whether it has stopped before the time aimed at, as balls come to rest: SettlingSolver.
  [[nodiscard]] bool settles() const { return tile_ && tile_->settles(); }

 private:
  using S = typename P::Scalar;
  using Disk = typename P::Disk;

  template <class Other>
  friend class EventSolver;

  /// A moment: whole eras, and ticks of the present one.
  struct Moment {
    double era = 0;
    typename P::Time ticks = 0;
  };

  [[nodiscard]] Disk flight_of(const Ball& ball) const;
  [[nodiscard]] Moment moment(double seconds) const;
  [[nodiscard]] typename P::Clock fitting_scale() const;
  /// In more digits flights are so dear that there are never enough balls.
  static constexpr bool kShares = event::kIsDouble<S> && !P::kSpins && !P::kRests;

  [[nodiscard]] std::vector<Phase> phases_of_windows() requires kShares;
  [[nodiscard]] bool shares(const event::BasicRules<S>& rules) const;
  [[nodiscard]] std::size_t aim_windows() requires kShares;
  [[nodiscard]] std::size_t finish(std::size_t phase) requires kShares;
  void sort_again();
  [[nodiscard]] const Disk& flight(std::size_t ball) const;
  [[nodiscard]] const event::Motion<P>& motion() const;
  [[nodiscard]] const event::Counts& counts() const;
  [[nodiscard]] event::Costs costs() const;
  void advance();
  void land();
  /// How often each ball was brought back round a periodic axis that gravity pulls along, in the
  /// flights that are over, and in the present ones if so asked.
  [[nodiscard]] Turns turns(bool of_present_flights) const;
  void start();
  void take_flights(const Scene& scene);
  void refuse_other_places(const Scene& scene) const;
  void sort_by_place();

  Domain domain_;
  Effects effects_;
  std::vector<Ball> balls_;         // as they were at the last `land`
  std::vector<Disk> flights_;       // of the balls, in their order, while there is no tile
  std::vector<event::Index> left_;  // the fixed ball at which each began, by number
  std::vector<unsigned> carried_;   // what carries each, where contacts can rest
  std::vector<event::Index> slot_;  // where in the tile a ball is
  typename P::Clock scale_;
  Choice choice_;
  bool sharing_ = false;                        // the present frame is done in windows
  bool one_tile_ = false;                       // windows did not get on
  std::unique_ptr<event::Tile<P>> tile_;        // all balls,
  std::unique_ptr<event::Windows<P>> windows_;  // or those of the parts
  std::uint64_t again_ = 0;                     // solved again by windows that are gone
  event::Counts before_;                        // counted in tiles that are gone
  event::Costs costs_before_;
  Turns turns_before_;  // in the order of the balls
  Moment now_;
  Moment target_;
};

}  // namespace carom
