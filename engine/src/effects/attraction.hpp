#pragma once

#include "carom/effects.hpp"
#include "state/balls.hpp"
#include "state/domain.hpp"

namespace carom::effects {

/// Writes the acceleration of balls [begin, end) by all others into their `pull`:
///     a_i = strength sum_j m_j (x_j - x_i) / (|x_j - x_i|^2 + softening^2)^(3/2)
/// Across a periodic side the nearest image of a ball attracts.  Fixed balls attract and stay.
///
/// The term of a pair is the same to the last bit, but for its sign, from both sides, and the sum
/// does not depend on the order of its terms: the bits depend on neither the shares, the lanes nor
/// the order of the balls.
///
/// Threads: reads all balls, writes those of the share.
void attract(Balls& balls, const Domain& domain, const Attraction& attraction, std::size_t begin,
             std::size_t end);

/// The largest pull on a ball that can move.
[[nodiscard]] double strongest_pull(const Balls& balls);

/// Gives balls [begin, end) the velocity that their pull makes in some seconds.
void kick(Balls& balls, double seconds, std::size_t begin, std::size_t end);

/// -strength sum over pairs of m_i m_j / sqrt(|x_j - x_i|^2 + softening^2).
double attraction_energy(const Balls& balls, const Domain& domain, const Attraction& attraction);

}  // namespace carom::effects
