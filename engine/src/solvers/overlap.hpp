#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contact/cell_grid.hpp"
#include "contact/groups.hpp"
#include "contact/lasting_contacts.hpp"
#include "contact/missed.hpp"
#include "contact/pair_list.hpp"
#include "effects/collisions.hpp"
#include "effects/flight.hpp"
#include "effects/friction.hpp"
#include "effects/walls.hpp"
#include "solvers/overlap_plan.hpp"
#include "solvers/solver.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/losses.hpp"
#include "state/totals.hpp"

namespace carom {

/// Method `overlap`: whole steps, numbered from the start.
///
/// In each step every ball flies freely and is sent back by the walls; then balls that overlap are
/// given their new velocities and moved apart.  First order in the step.
///
///     wall_computation    each worker: its balls               reads and writes its balls
///     neighbour_search    each worker: the neighbours of its balls, where the list has aged
///     pair_computation    each worker: its pairs               reads all balls, writes its hits
///     pair_resolution     each worker: some groups or islands of touching balls, writes those
///     attraction          each worker: the pull on its balls   reads all balls, writes its balls
///
/// Only what the scene names is there: without collisions none of the pairs, without attraction not
/// the last; without walls the first is called `flight`.  Attraction is velocity Verlet around the
/// rest of the step: half a step of the pull before the flight, half a step after the impacts, of
/// the pull where the balls are then; so one sum over all balls in a step is enough.
///
/// Work that is too little to share is done between two phases by the worker that arrives last; a
/// scene that starts too small ever to share it does not have the phase: see OverlapPlan.
///
/// Where contacts can last, balls that touch are solved island by island instead, walls included,
/// and fall asleep: see contact/lasting_contacts.hpp.  When all are asleep a step costs nothing.
///
/// Holds: no memory from step to step beside the balls: lists of pairs never change the result.
class OverlapSolver final : public Solver {
 public:
  /// Which pairs are looked at; every choice gives the same result.
  enum class Pairs { automatic, all, neighbours };

  explicit OverlapSolver(const Scene& scene, const std::vector<Ball>& balls,
                         Pairs pairs = Pairs::automatic);

  [[nodiscard]] std::vector<Phase> phases() override;
  void set_workers(std::size_t workers) override;
  [[nodiscard]] std::size_t aim(double time) override;
  void add(const Ball& ball) override;
  void remove(std::size_t ball) override;
  void set(const Effects& effects) override;
  void set_step(double step) override;
  [[nodiscard]] std::size_t balls() const override { return balls_.size(); }
  void visit_state(const BallVisitor& visit) const override { balls_.for_each(visit); }
  [[nodiscard]] std::string state_hash() const override { return carom::state_hash(balls_); }
  [[nodiscard]] double energy() const override;
  [[nodiscard]] double dissipated() const override { return losses_.sum(); }
  [[nodiscard]] std::vector<double> losses() const override { return losses_.numbers(); }
  void go_on_from_losses(const std::vector<double>& losses) override { losses_.go_on_from(losses); }
  [[nodiscard]] Vec2 momentum() const override { return carom::momentum(balls_); }
  void count(Measurements& measurements) const override;
  void save(Scene& scene) const override;
  void record_impacts(bool wanted) override;
  void take_impacts(std::vector<Impact>& impacts, bool of_all) override;

 private:
  // What one worker writes, apart from what others write.
  struct alignas(128) Desk {
    PairList neighbours;
    std::vector<Pair> touching;
    std::vector<Bullet> bullets;
    std::vector<std::uint32_t> out;  // beyond a wall, where contacts last
    contact::IslandStep island;
    contact::LastingContacts::Count lasting;
    effects::ImpactCount impacts;
    double deepest = 0;
    double moved_square = 0;  // of the ball that has moved farthest since the list was built
    EffectSeconds seconds;
    std::array<std::vector<effects::WallImpact>, 2> met;  // across each axis, by a block
  };

  void fly(Share share);
  void fly(std::size_t begin, std::size_t end, Desk& desk, effects::Struck* struck);
  void note_walls(std::size_t begin, const effects::FrictionBlock* by_friction, Desk& desk) const;
  void count_missed_hits();
  void note_moves(std::size_t begin, std::size_t end, Desk& desk) const;
  void search(Share share);
  void detect(Share share);
  void resolve(Share share);
  void pull(Share share);
  [[nodiscard]] std::size_t after_flight();
  [[nodiscard]] std::size_t after_detection();
  [[nodiscard]] std::size_t form_islands();
  [[nodiscard]] std::size_t resolve_islands();
  [[nodiscard]] std::size_t after_islands();
  [[nodiscard]] bool join_islands();
  void find_far_overlaps(std::vector<Pair>& fresh);
  void resolve_island(std::size_t island, Desk& desk);
  [[nodiscard]] std::vector<Pair> near_pairs();
  [[nodiscard]] std::size_t after_impacts();
  [[nodiscard]] std::size_t after_pull();
  [[nodiscard]] std::size_t end_step();

  [[nodiscard]] bool loses() const;
  void resolve_group(std::size_t group, effects::ImpactCount& count);
  void renew_rules();
  void forget_pairs();
  [[nodiscard]] bool collides() const { return effects_.collisions && effects_.collisions->on; }
  [[nodiscard]] bool timed() const;
  [[nodiscard]] bool many() const;
  [[nodiscard]] bool list_is_stale() const;
  void build_grid();
  void build_list();

  Box box_;
  Domain domain_;
  Effects effects_;
  Balls balls_;
  Pairs choice_;
  OverlapPlan plan_;  // as the scene started
  // The numbers of the phases; those that are not there have none.
  static constexpr std::size_t kFly = 0;
  std::size_t detect_ = 0;
  std::optional<std::size_t> search_;
  std::optional<std::size_t> resolve_;
  std::optional<std::size_t> attract_;
  double step_;
  double step_origin_ = 0;
  std::uint64_t steps_ = 0;   // since step_origin_
  std::uint64_t target_ = 0;  // the step to stop at
  std::uint64_t taken_ = 0;   // since this solver was made
  std::uint64_t missed_ = 0;  // hits that lay between two steps
  double smallest_radius_ = 0;
  bool pull_known_ = false;  // the pull is that of the present places
  bool in_step_ = false;
  bool recording_ = false;
  Turns turns_;
  Losses losses_;

  // What a step takes of the effects, worked out anew where one of them or the step changes.
  double drag_rate_ = 0;
  std::array<Glide, 2> glide_;
  std::array<effects::WallRule, 2> wall_rule_;
  effects::CollisionRule rule_;
  effects::GroupResolver resolver_{domain_, rule_, turns_};
  contact::LastingRule lasting_rule_;
  contact::LastingContacts contacts_{domain_, lasting_rule_, turns_};
  bool lasting_ = false;      // contacts that last are looked for
  bool know_asleep_ = false;  // who is asleep has been found
  int rounds_ = 0;            // of this step: how often islands have been joined
  std::vector<std::uint32_t> out_;
  PairList all_pairs_;
  CellGrid grid_;
  std::array<Balls::Column, 2> anchor_;  // where the balls were when the list was built
  double skin_ = 0;
  double stretch_ = 1;  // balls closer than this factor of their reach count as touching
  double near_ = 0;     // how far apart those are
  bool listed_ = false;
  std::vector<Pair> touching_;
  Groups groups_;
  std::vector<Desk> desks_;
};

}  // namespace carom
