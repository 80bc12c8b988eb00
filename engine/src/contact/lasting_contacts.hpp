#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "contact/impact_log.hpp"
#include "contact/lasting_island.hpp"
#include "contact/pair_list.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// What contacts that last depend on beside the balls.
struct LastingRule {
  double step = 0;
  Vec2 acceleration{0, 0};
  std::array<double, 2> fall{0, 0};  ///< how far a ball at rest flies in a step, by axis
  std::array<double, 2> gain{0, 0};  ///< and how fast it is then
  double restitution = 1;
  double wall_restitution = 1;
  double friction = 0;
  double wall_friction = 0;
  double rest_speed = 0;
  double fading = 1;          ///< see IslandStep::Rule
  bool keeps_energy = false;  ///< see IslandStep::Rule
};

/// Whether lasting contacts are looked for: gravity presses balls together that come to rest by
/// losses, or whose masses differ so much that one lies on the other for many steps.
[[nodiscard]] bool contacts_last(const Effects& effects, const Balls& balls);

/// The islands of balls that touch in a step of method `overlap`, and which balls are asleep.
///
/// In each step every ball flies free; balls that then overlap, or are beyond a wall, form islands
/// with all that then touch or nearly do, and an island is solved as a whole from where it was at
/// the start.  Where a solution brings a ball into one that is near but of no or of another island,
/// those are put back, joined and solved again; so what is merely near costs nothing.
/// Balls that stand still and that forces within the friction cones can hold are asleep: they are
/// part of no island, until a ball that is awake comes into one of them.
///
/// Holds: nothing is remembered beside the balls: who is asleep stands still exactly, and is found
/// asleep again.  No order of balls or pairs changes a bit.
/// Threads: islands of one step are resolved at the same time; the rest by one thread.
class LastingContacts {
 public:
  /// Balls within this part of their reach of each other are near.
  static constexpr double kNear = 0.125;

  struct Count {
    std::uint64_t ball_ball = 0;
    std::uint64_t ball_wall = 0;
    double deepest = 0;  ///< overlap at the end of the step, by the smaller radius
  };

  LastingContacts(const Domain& domain, const LastingRule& rule, Turns& turns)
      : domain_(domain), rule_(rule), turns_(turns) {}
  LastingContacts(const LastingContacts&) = delete;
  LastingContacts& operator=(const LastingContacts&) = delete;

  /// Something has changed the balls or the rules: all are awake, but those that stand still among
  /// others they are near, `pairs`, and are held.
  void wake_all(const Balls& balls);
  void find_asleep(const Balls& balls, std::span<const Pair> near);
  [[nodiscard]] bool all_asleep() const { return awake_ == 0; }
  [[nodiscard]] bool asleep(std::size_t ball) const { return asleep_[ball] != 0; }

  /// Before a flight: notes where balls [begin, end) start.
  void begin(const Balls& balls, std::size_t begin, std::size_t end);
  /// After it: puts those asleep back, and notes who is beyond a wall.
  void end(Balls& balls, std::size_t begin, std::size_t end, std::vector<std::uint32_t>& out) const;

  /// Finds the islands.  `near`: pairs that are near after the flight, in order.
  void form(Balls& balls, std::span<const Pair> near, std::span<const std::uint32_t> out);
  [[nodiscard]] std::size_t islands() const { return islands_.size(); }
  /// Solves an island, unless that has been done.  May it fall asleep: this is asked at some steps
  /// only.
  void resolve(std::size_t island, Balls& balls, bool may_sleep, IslandStep& step,
               const ImpactLog& log);
  /// The farthest that a ball came to be from where it had flown.
  [[nodiscard]] double farthest_push() const;
  /// Adds the near pairs that overlap now, but are of no island or of two.
  void find_crossing(const Balls& balls, std::span<const Pair> near,
                     std::vector<Pair>& crossing) const;
  /// Whether a ball was driven beyond a wall that was not near.
  [[nodiscard]] bool any_driven() const;
  /// Puts the balls back to where they had flown whose islands are of these pairs, or have been
  /// driven beyond a wall, and finds their islands again, in which these pairs are linked.
  /// `all`: the balls of all islands, and all near pairs are linked.
  void join(Balls& balls, std::span<const Pair> near, std::span<const Pair> crossing, bool all);
  /// Ends a step: counts who has fallen asleep and what happened, and adds what each island has
  /// lost to one of its balls, unless `lost` is empty.
  void settle(std::span<double> lost, Count& count, ImpactLog& log);

 private:
  using Island = LastingIsland;
  using Member = LastingIsland::Member;

  void wake_struck(Balls& balls, std::span<const Pair> near);
  void wake(Balls& balls, std::uint32_t ball);
  [[nodiscard]] bool overlap(const Balls& balls, const Pair& pair) const {
    return closer(balls, pair, 0);
  }
  [[nodiscard]] bool closer(const Balls& balls, const Pair& pair, double gap) const;
  [[nodiscard]] bool moves(const Balls& balls, std::uint32_t ball) const {
    return !balls.fixed(ball) && asleep_[ball] == 0;
  }
  void foresee_links(const Balls& balls, std::span<const Pair> near,
                     std::span<const std::uint32_t> out, double gap);
  void assemble(const Balls& balls, std::span<const Pair> near, double gap);
  void undo(Balls& balls, const Island& island);
  void add_member(Island& island, const Balls& balls, std::uint32_t ball);
  void add_pair(Island& island, const Balls& balls, int a, int b, const Pair& pair) const;
  [[nodiscard]] bool has_walls() const { return domain_.solid(0) || domain_.solid(1); }
  void number_members(std::size_t first_island);
  [[nodiscard]] IslandStep::Rule step_rule(const Frame& frame) const;
  void put(Balls& balls, Member& member, const Vec2& place, const Vec2& velocity, double spin);

  const Domain& domain_;
  const LastingRule& rule_;
  Turns& turns_;
  std::array<std::vector<double>, 2> start_;
  std::array<std::vector<double>, 2> before_;
  std::vector<char> asleep_;
  std::vector<char> slept_;  // as it was at the start of the step
  std::vector<char>
      driven_;  // beyond a wall that was not near: then its walls are near in this step
  std::size_t awake_ = 0;
  std::size_t sleepers_ = 0;
  std::size_t woken_ = 0;  // in this step
  DisjointSets sets_;
  std::vector<int> island_of_;  // by root ball
  std::vector<int> member_of_;  // by ball: its island; less than 0: none
  std::vector<int> place_;      // by ball: its number there
  std::vector<Island> islands_;
  std::vector<std::uint32_t> seeds_;  // whose islands are to be found
  std::vector<double> pushes_;        // by ball: how far contacts may push it in this step
  std::vector<Pair> linked_;          // in this step, though they do not touch after the flight
};

}  // namespace carom::contact
