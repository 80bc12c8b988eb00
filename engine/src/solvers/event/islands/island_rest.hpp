#pragma once

#include <vector>

#include "contact/disjoint_sets.hpp"
#include "numbers/scalar.hpp"
#include "solvers/event/islands/island_motion.hpp"

namespace carom::event {

// Which balls of an island that has been stepped move on, and which come to rest: rule 4 of
// contact/rest_rules.hpp.  `sets`: of balls that carry each other; `moves`: by the number of a set.

/// What gravity does in a step of islands.
struct StepScale {
  Vec<double> pull;  ///< gravity
  double span;       ///< how far a speed of 1 goes in it, seconds; drag makes it shorter
  double speed;      ///< what gravity makes in it
};

/// What is slow comes to rest only where forces at its contacts hold it: what is pulled moves on.
/// Of many balls, which creep until all contacts carry, slowness decides, unless what they lean on
/// cannot hold up the weight of all of them.  `presses`: by contact: it closes, and can take a
/// load; what a set leans on, be it little, and does not move is as a wall.
void hold_still(const IslandMotion& island, const StepScale& step, DisjointSets& sets,
                const std::vector<char>& presses, std::vector<char>& moves);

/// What is touched by something that moves on and comes nearer moves too.
void pass_on_motion(const IslandMotion& island, DisjointSets& sets, std::vector<char>& moves);

/// The balls that would come nearer to something that they touch if they flew on as before.
[[nodiscard]] std::vector<char> met(const IslandMotion& island,
                                    const std::vector<ConeBody>& before);

}  // namespace carom::event
