#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solvers/event/tile.hpp"
#include "solvers/solver.hpp"
#include "state/domain.hpp"

namespace carom {

/// Method `event`: balls fly on their closed-form paths from impact to impact, in the order of
/// time.  There is no step; a frame only looks.
///
/// Holds: the same bits at any frame rate, number of workers and order in memory.
/// Threads: one worker does the impacts; the others wait.
template <class P>
class EventSolver final : public Solver {
 public:
  EventSolver(const Scene& scene, std::vector<Ball> balls);

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

 private:
  using S = typename P::Scalar;
  using Disk = typename P::Disk;

  /// A moment: whole eras, and ticks of the present one.
  struct Moment {
    double era = 0;
    typename P::Time ticks = 0;
  };

  [[nodiscard]] Disk flight_of(const Ball& ball) const;
  [[nodiscard]] Moment moment(double seconds) const;
  [[nodiscard]] typename P::Clock fitting_scale() const;
  void advance();
  void land();
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
  std::unique_ptr<event::Tile<P>> tile_;
  event::Counts before_;  // counted in tiles that are gone
  Moment now_;
  Moment target_;
  std::uint64_t sorted_at_ = 0;  // impacts when the balls were last put in order
};

}  // namespace carom
