#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/disjoint_sets.hpp"
#include "contact/foreseen_links.hpp"
#include "contact/lasting_island.hpp"
#include "contact/lasting_rule.hpp"
#include "contact/pair_list.hpp"
#include "contact/sleepers.hpp"
#include "contact/step_start.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom::contact {

/// The islands of a step: which balls are in which, and their contacts.
///
/// An island has the balls that overlap another one or are beyond a wall after the flight, or have
/// been woken, with all that are linked to them: those that then touch, or nearly do, or that a
/// push will bring together.  Its contacts are those of its balls with each other, with fixed and
/// sleeping balls and with the walls that are near.
///
/// Holds: no order of balls or pairs changes an island.
class LastingIslands {
 public:
  using Members = std::vector<LastingIsland::Member>;

  LastingIslands(const Domain& domain, const LastingRule& rule, const StepStart& start,
                 const Sleepers& sleepers, const Turns& turns)
      : domain_(domain), rule_(rule), start_(start), sleepers_(sleepers), turns_(turns) {}
  LastingIslands(const LastingIslands&) = delete;
  LastingIslands& operator=(const LastingIslands&) = delete;

  /// There are so many balls, and no islands.
  void reset(std::size_t balls);
  /// No islands.
  void clear();
  /// Finds those of a step.  `near`: pairs that are near after the flight, in order; `out`: balls
  /// beyond a wall.
  void find(const Balls& balls, std::span<const Pair> near, std::span<const std::uint32_t> out);
  /// Groups of balls that stand still and are near each other.  What moves is no contact.
  void find_still(const Balls& balls, std::span<const Pair> near);
  /// Takes out the islands of these pairs and those with a driven ball, or `all`.
  [[nodiscard]] std::vector<LastingIsland> take_out(const Balls& balls,
                                                    std::span<const Pair> crossing, bool all);
  /// Finds islands of the balls that were taken out, which are where they had flown again.  The
  /// crossing pairs are linked, and so are all near balls that are of no island.
  void find_again(const Balls& balls, std::span<const Pair> near, std::span<const Pair> crossing);

  [[nodiscard]] std::size_t size() const { return islands_.size(); }
  [[nodiscard]] LastingIsland& operator[](std::size_t k) { return islands_[k]; }
  [[nodiscard]] auto begin() { return islands_.begin(); }
  [[nodiscard]] auto end() { return islands_.end(); }
  [[nodiscard]] auto begin() const { return islands_.begin(); }
  [[nodiscard]] auto end() const { return islands_.end(); }
  [[nodiscard]] bool together(const Pair& pair) const {
    return island_of_[pair.first] == island_of_[pair.second];
  }
  /// Balls that have gone beyond a wall that was not near: all walls are near to them in this
  /// step.
  [[nodiscard]] std::vector<char>& driven() { return driven_; }

 private:
  void link(const Balls& balls, std::span<const Pair> near, double gap);
  void assemble(const Balls& balls, std::span<const Pair> near);
  void number_members(std::size_t first_island);
  void add_contacts(const Balls& balls, std::span<const Pair> near, std::size_t first_island);
  void add_pair(LastingIsland& island, const Balls& balls, int a, int b, const Pair& pair) const;
  [[nodiscard]] LastingIsland::Member member(const Balls& balls, std::uint32_t ball) const;

  const Domain& domain_;
  const LastingRule& rule_;
  const StepStart& start_;
  const Sleepers& sleepers_;
  const Turns& turns_;
  ForeseenLinks foreseen_{domain_, sleepers_};
  std::vector<LastingIsland> islands_;
  std::vector<int> island_of_;  // by ball; less than 0: none
  std::vector<int> place_;      // by ball: its number there
  std::vector<char> driven_;
  std::vector<Pair> linked_;  // in this step, though they do not touch after the flight; in order
  // What islands are assembled from.
  std::vector<std::uint32_t> seeds_;    // whose islands are to be found
  std::vector<std::uint32_t> touched_;  // the seeds, and what may be of their islands
  std::vector<Pair> links_;
  DisjointSets sets_;
  std::vector<int> island_of_root_;
};

}  // namespace carom::contact
