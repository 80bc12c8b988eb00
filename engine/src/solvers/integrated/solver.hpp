#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "contact/first_contact.hpp"
#include "contact/impulse.hpp"
#include "effects/flight.hpp"
#include "effects/friction.hpp"
#include "solvers/integrated/splitting.hpp"
#include "solvers/solver.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/losses.hpp"
#include "state/totals.hpp"

namespace carom {

/// Method `event` where attraction leaves no closed-form flight: all balls are integrated together,
/// up to each impact.
///
/// Steps are numbered from the start; a frame looks at a step begun beside the run and thrown away.
/// A step is cut into pieces: one piece flies on, as far as the step goes, in the stages of
/// Splitting; its ends give every ball a quintic path, and on those the first contact is looked
/// for. If there is one, the piece is flown again, just up to it, the impact changes velocities,
/// and the next piece begins.  Fourth order, and so are the times of the impacts.
///
///     attraction          each worker: its balls, one stage    reads all places, writes new ones
///     pair_computation    each worker: its pairs and walls     reads all paths, writes its find
///
/// Contacts that cannot part would be met again and again.  With a restitution below 1, balls that
/// touch, are drawn together and approach slower than what two steps of their acceleration make
/// rest on each other; so do two whose approach rounding swallows, or that have met too often in a
/// step. Until the end of the step they are not looked at; there they are stopped and put side by
/// side, see settling.cpp and lifting.cpp. Which balls rest follows from the state at the beginning
/// of the step and from the impacts in it.
class IntegratedSolver final : public Solver {
 public:
  IntegratedSolver(const Scene& scene, const std::vector<Ball>& balls);

  [[nodiscard]] std::vector<Phase> phases() override;
  void set_workers(std::size_t workers) override { finds_.resize(workers); }
  [[nodiscard]] std::size_t aim(double time) override;
  void add(const Ball& ball) override;
  void remove(std::size_t ball) override;
  void set(const Effects& effects) override;
  void set_step(double step) override;
  [[nodiscard]] std::size_t balls() const override { return state_.balls.size(); }
  void visit_state(const BallVisitor& visit) const override { state_.balls.for_each(visit); }
  /// As they were at the last whole step.
  void visit_saved(const BallVisitor& visit) const override {
    (whole_ ? whole_->balls : state_.balls).for_each(visit);
  }
  [[nodiscard]] std::string state_hash() const override { return carom::state_hash(state_.balls); }
  [[nodiscard]] double energy() const override;
  [[nodiscard]] double dissipated() const override { return state_.losses.sum(); }
  [[nodiscard]] std::vector<double> losses() const override { return state_.losses.numbers(); }
  void go_on_from_losses(const std::vector<double>& losses) override {
    state_.losses.go_on_from(losses);
  }
  [[nodiscard]] Vec2 momentum() const override { return carom::momentum(state_.balls); }
  void count(Measurements& measurements) const override;
  void save(Scene& scene) const override;
  void record_impacts(bool wanted) override { log_.wanted = wanted; }
  void take_impacts(std::vector<Impact>& impacts, bool of_all) override;

 private:
  // What meets: balls i < j, or ball i and a wall, j = kWall + 2 axis + (1 at the upper end).
  struct Meeting {
    static constexpr std::uint32_t kWall = 0xfffffff0U;
    double at = 2;  // of the piece; beyond 1: there is none
    std::uint32_t i = 0;
    std::uint32_t j = 0;
    double closing = 0;       // how fast the two come together when the piece begins
    bool to_the_end = false;  // of the step it rests, whatever happens

    [[nodiscard]] bool with_wall() const { return j >= kWall; }
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> who() const { return {i, j}; }
    // Of two at the same time the faster one is first: the numbers of the balls decide only between
    // meetings that are alike.
    [[nodiscard]] bool before(const Meeting& other) const {
      if (at != other.at) return at < other.at;
      return closing != other.closing ? closing > other.closing : who() < other.who();
    }
  };
  // All that a run goes on from.
  struct State {
    Balls balls;
    Turns turns;
    std::uint64_t ball_ball = 0;
    std::uint64_t ball_wall = 0;
    double deepest = 0;
    Losses losses;
    bool pull_known = false;
  };
  // The lengths of a piece's stages.
  struct Stage {
    double kick = 0;
    double step = 0;
    std::array<Glide, 2> glide;
  };
  struct alignas(128) Find {
    Meeting first;
    std::vector<Meeting> slow;  // too slow to bounce
    EffectSeconds seconds;
  };

  void fly(Share share);
  void fly_block(const Stage& stage, std::size_t begin, std::size_t end, Find& find);
  void draw_paths(std::size_t begin, std::size_t end);
  void search(Share share);
  [[nodiscard]] std::size_t after_stage();
  [[nodiscard]] std::size_t after_search();
  [[nodiscard]] std::size_t begin_step(double length);
  [[nodiscard]] std::size_t next_part();
  [[nodiscard]] std::size_t begin_piece(double length);
  [[nodiscard]] std::size_t go_on_after_impact();
  [[nodiscard]] std::size_t end_step();

  [[nodiscard]] std::optional<double> meet(std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] std::optional<double> meet_wall(std::uint32_t i, std::uint32_t wall) const;
  /// Of gravity, drag and attraction on a ball with this velocity and pull.
  [[nodiscard]] double acceleration(std::size_t axis, std::uint32_t i, double velocity,
                                    double pull) const;
  [[nodiscard]] Vec2 acceleration(std::uint32_t i) const;
  [[nodiscard]] effects::Member member(std::uint32_t i) const;
  void put_back(const effects::Member& member);
  void note(const Meeting& meeting, double after, bool bounces, const Vec2& normal, double distance,
            double impulse, const FrictionChange& by_friction);
  [[nodiscard]] LineOfCentres line_between(const effects::Member& a,
                                           const effects::Member& b) const;
  [[nodiscard]] std::vector<Impact>& lines() { return whole_ ? shown_ : log_.impacts; }
  void back_to_start();
  void look_ahead();
  void strike(const Meeting& meeting);
  void strike_balls(const Meeting& meeting);
  void strike_wall(const Meeting& meeting);
  void find_resting();
  void settle();
  void stop_and_put_apart();
  // What acts on one contact at the end of a step, on copies of its balls; nothing where it does
  // not act.
  struct Act {
    Vec2 normal{0, 0};
    double distance = 0;
    double impulse = 0;
    double depth = 0;
    FrictionChange by_friction;
  };
  // What a stop took from a ball, and the line of the log that tells of it.
  struct Stopped {
    std::uint32_t ball = 0;
    double lost = 0;
    std::size_t line = 0;
  };
  using Acting = std::optional<Act> (IntegratedSolver::*)(const Meeting&, effects::Member&,
                                                          effects::Member&) const;
  [[nodiscard]] std::optional<Act> stop(const Meeting& meeting, effects::Member& a,
                                        effects::Member& b) const;
  [[nodiscard]] std::optional<Act> put_apart(const Meeting& meeting, effects::Member& a,
                                             effects::Member& b) const;
  void sweep(std::vector<Meeting>& meetings, Acting acting);
  bool act_on(std::span<const Meeting> alike, Acting acting);
  bool put_inside(effects::Member& ball) const;
  [[nodiscard]] double lift(std::uint32_t i, const std::array<Balls::Column, 2>& from) const;
  void pay_for_lifts(const std::array<Balls::Column, 2>& from);
  void book(const Stopped& stopped, double energy);
  [[nodiscard]] double rounding_of_fall(std::uint32_t i) const;
  bool slow_down(std::uint32_t i, double energy);
  [[nodiscard]] double closing_speed(const Meeting& meeting,
                                     const std::array<Balls::Column, 2>& position,
                                     const std::array<Balls::Column, 2>& velocity) const;
  /// Balls whose centres are nearer than this times the sum of their radii, in their order.
  [[nodiscard]] std::vector<Meeting> near_pairs(double within) const;
  [[nodiscard]] bool rests(const Meeting& meeting) const;
  [[nodiscard]] bool is_slow(const Meeting& meeting) const;
  /// What is too slow to bounce off another ball, or off a wall (i = j).
  [[nodiscard]] double rest_speed(std::uint32_t i, std::uint32_t j) const;
  [[nodiscard]] bool too_often(const Meeting& meeting);
  void renew_rules();
  void restart_steps();
  [[nodiscard]] bool meets_anything() const;
  [[nodiscard]] bool timed() const;
  [[nodiscard]] bool collides() const { return has_collisions(effects_); }

  static constexpr std::size_t kFly = 0;
  static constexpr std::size_t kSearch = 1;
  static constexpr std::size_t kPullOnly = Splitting::kStages + 1;  // a stage that moves nothing

  Box box_;
  Domain domain_;
  Effects effects_;
  State state_;
  std::optional<State> whole_;  // the state at the last whole step, while a part of one is shown
  Vec2 gravity_{0, 0};
  double drag_rate_ = 0;
  double step_;
  double step_origin_ = 0;
  std::uint64_t steps_ = 0;  // whole ones since step_origin_
  std::uint64_t target_ = 0;
  double extra_ = 0;  // part of a step to show beyond the target
  double time_ = 0;   // that was aimed at
  std::uint64_t taken_ = 0;
  EffectSeconds impacts_;  // what they took, all of them

  std::size_t parts_ = 0;  // of the step, still to come: whole ones, and the length of a last one
  double tail_ = 0;
  double remaining_ = 0;  // of the present part, with the piece that is flown
  double piece_ = 0;
  double part_end_ = 0;  // since the step began
  std::size_t stage_ = 0;
  std::array<Stage, Splitting::kStages + 1> stages_;
  std::optional<Meeting> planned_;  // the piece ends with this impact
  std::array<Balls::Column, 2> next_;
  std::array<Balls::Column, 2> start_position_;
  std::array<Balls::Column, 2> start_velocity_;
  std::array<Balls::Column, 2> start_pull_;
  std::vector<double> start_lost_;
  std::array<Balls::Column, 2> low_;  // what a ball's path stays within
  std::array<Balls::Column, 2> high_;
  std::vector<Meeting> resting_;  // until the end of the step
  std::vector<Stopped> stopped_;
  std::vector<unsigned char> linked_;  // 1: settled with another that can move
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> struck_;  // in this step, how often
  std::vector<Find> finds_;
  ImpactLog log_;
  std::vector<Impact> shown_;  // of the part of a step that is shown, which will be done again
};

}  // namespace carom
