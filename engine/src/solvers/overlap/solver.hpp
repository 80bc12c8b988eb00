#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact/groups.hpp"
#include "contact/lasting_contacts.hpp"
#include "effects/collisions.hpp"
#include "solvers/overlap/group_rounds.hpp"
#include "solvers/overlap/island_rounds.hpp"
#include "solvers/overlap/pair_search.hpp"
#include "solvers/overlap/plan.hpp"
#include "solvers/overlap/step_flight.hpp"
#include "solvers/overlap/step_rules.hpp"
#include "solvers/overlap/work.hpp"
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
/// scene that starts too small ever to share it does not have the phase: see overlap::Plan.
///
/// Where contacts can last, balls that touch are solved island by island instead, walls included,
/// and, without attraction, fall asleep: see contact/lasting_contacts.hpp.  When all are asleep a
/// step costs nothing.  There attraction is a force of the whole step for what touches, of which
/// half a step is put right by what the pull is at the end.
///
/// Holds: no memory from step to step beside the balls: lists of pairs never change the result.
class OverlapSolver final : public Solver {
 public:
  using Pairs = overlap::PairSearch::Pairs;

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
  // The phases.
  void fly(Share share);
  void detect(Share share);
  void resolve(Share share);
  void pull(Share share);
  // What is done between two phases; each gives the next one.
  [[nodiscard]] std::size_t after_flight();
  [[nodiscard]] std::size_t after_detection();
  [[nodiscard]] std::size_t resolve_groups();
  [[nodiscard]] std::size_t after_groups();
  [[nodiscard]] std::size_t form_islands();
  [[nodiscard]] std::size_t resolve_islands();
  [[nodiscard]] std::size_t after_islands();
  [[nodiscard]] std::size_t after_impacts();
  [[nodiscard]] std::size_t after_pull();
  [[nodiscard]] std::size_t end_step();

  void resolve_group(std::size_t group, effects::ImpactCount& count);
  void resolve_island(std::size_t island, overlap::Work& work);
  void renew_rules();
  void renew_balls(const std::vector<Ball>& balls);
  [[nodiscard]] bool timed() const;

  Box box_;
  Domain domain_;
  Effects effects_;
  Balls balls_;
  overlap::Plan plan_;  // as the scene started
  // The numbers of the phases; those that are not there have none.
  static constexpr std::size_t kFly = 0;
  std::size_t detect_ = 0;
  std::optional<std::size_t> search_;
  std::optional<std::size_t> resolve_;
  std::optional<std::size_t> attract_;
  double step_origin_ = 0;
  std::uint64_t steps_ = 0;   // since step_origin_
  std::uint64_t target_ = 0;  // the step to stop at
  std::uint64_t taken_ = 0;   // since this solver was made
  std::uint64_t missed_ = 0;  // hits that lay between two steps
  bool pull_known_ = false;   // the pull is that of the present places
  bool in_step_ = false;
  bool recording_ = false;
  Turns turns_;
  Losses losses_;
  overlap::StepRules rules_;
  overlap::PairSearch pairs_;
  effects::GroupResolver resolver_{domain_, rules_.collision, turns_};
  contact::LastingContacts contacts_{domain_, rules_.lasting, turns_};
  overlap::GroupRounds group_rounds_{rules_, pairs_};
  overlap::IslandRounds rounds_{balls_, rules_, pairs_, contacts_};
  overlap::StepFlight flight_{balls_, domain_, rules_, contacts_, pairs_, losses_, turns_};
  std::vector<std::uint32_t> out_;
  std::vector<Pair> touching_;
  Groups groups_;
  std::vector<overlap::Work> work_;
};

}  // namespace carom
