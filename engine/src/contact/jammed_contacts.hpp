#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/contact_graph.hpp"
#include "contact/impulse_guess.hpp"

namespace carom::event {

/// What a contact that is not jammed misses at most, as a part of the speed that is wanted.
inline constexpr double kMissed = 0x1p-8;

/// Contacts that no motion of their group opens while the others stay closed or open, or only one
/// that takes more than `most` rounds of reflections: kPushes, by contact, in `jammed`, where
/// kHolds are those that are known to be held.
///
/// The slowest motion, by energy, is sought that opens every contact alone at its own unit speed;
/// each may miss that by a small part of the impulse that holds it.  Where balls are wedged in by a
/// self-stress, impulses >= 0 whose forces are in balance, no motion opens what carries it: the
/// impulses grow until some is missed.  Two faces of a wedge of the angle pi / most miss just
/// kMissed.
/// Holds: velocities do not matter, only how the contacts lie.
/// Source: Connelly, Rigidity and energy, Invent. Math. 66 (1982) 11; Donev, Torquato, Stillinger,
/// Connelly, J. Comput. Phys. 197 (2004) 139: what jams is what has such a stress.
template <class S>
[[nodiscard]] std::vector<char> jammed_contacts(const ContactGraph<S>& graph, int most,
                                                std::vector<char> jammed) {
  constexpr double kPi = 3.14159265358979324;
  const double angle = kPi / 2 / most;
  const double give = 2 * kMissed * angle * angle;
  const std::size_t n = graph.size();
  std::vector<double> wanted(n, 0.0);
  std::vector<char> may(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    if (!(graph.mobility(k) > 0)) continue;
    may[k] = jammed[k] == kHolds ? kHolds : kPushes;
    if (may[k] == kPushes) wanted[k] = -std::sqrt(static_cast<double>(graph.mobility(k)));
  }
  const std::vector<double> impulses =
      guess_impulses(graph.response_matrix(), wanted, may, give, 0);
  for (std::size_t k = 0; k < n; ++k) {
    if (may[k] != kPushes) continue;
    const double missed = give * static_cast<double>(graph.mobility(k)) * impulses[k];
    if (missed > -kMissed * wanted[k]) jammed[k] = kPushes;
  }
  return jammed;
}

}  // namespace carom::event
