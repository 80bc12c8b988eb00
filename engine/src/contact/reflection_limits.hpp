#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "contact/contact_graph.hpp"
#include "contact/nonnegative_impulses.hpp"

namespace carom::event {

/// What a group may cost in one instant before the rest of it is taken inelastically, in rounds
/// times contacts squared, and how many rounds any group may take. A ball between a wall and one M
/// times as heavy needs pi sqrt(M) rounds, so without losses this is reached for M beyond 1e8, or
/// where balls are wedged in between walls and bounce for ever in no time at all.
inline constexpr double kMostWork = 1 << 18;
inline constexpr double kFewRounds = 128;
/// What may take more rounds than this, and than it may cost, is not waited for.
inline constexpr int kNarrow = 1 << 12;

/// After how many rounds the angle of a group's wedge is asked.  In more digits than those of a
/// double groups come apart out of narrower wedges, in more rounds.
template <class S>
[[nodiscard]] int patience(std::size_t contacts) {
  const int rounds = 16 + 4 * static_cast<int>(contacts);
  return kIsDouble<S> ? rounds : 16 * rounds;
}

/// Whether nothing is lost in any impact of the group.
template <class S>
[[nodiscard]] bool is_lossless(const ContactGraph<S>& graph) {
  for (std::size_t k = 0; k < graph.size(); ++k) {
    if (graph.mobility(k) > 0 && graph.contact(k).restitution != 1) return false;
  }
  return true;
}

/// How many rounds of reflections a group may take.
template <class S>
[[nodiscard]] int most_rounds(const ContactGraph<S>& graph) {
  S e = 0;
  for (std::size_t k = 0; k < graph.size(); ++k) e = larger(e, graph.contact(k).restitution);
  if (e == 0) return 0;
  const auto contacts = static_cast<double>(graph.size());
  const auto loss = static_cast<double>(S(1 - e));
  const double most = std::max(kMostWork / (contacts * contacts), kFewRounds);
  const double lossy = 8 * (8 + contacts);
  return static_cast<int>(lossy < most * loss ? lossy / loss : most);
}

/// How many rounds a group may take to come apart: pi over the angle of its wedge, in the space of
/// its velocities by energy, where contacts are faces and an impact is a reflection. Infinite, if
/// some contact has no motion of the group that opens it while the others stay closed or open.
template <class S>
[[nodiscard]] double rounds_to_open(const ContactGraph<S>& graph) {
  constexpr double kPi = 3.14159265358979324;
  std::vector<char> all(graph.size(), 0);
  std::vector<S> wanted(graph.size(), S(0));
  for (std::size_t k = 0; k < graph.size(); ++k) {
    if (!(graph.mobility(k) > 0)) continue;
    all[k] = 1;
    wanted[k] = -root(S(graph.mobility(k)));
  }
  const std::vector<S> impulses = nonnegative_impulses(graph, wanted, all);
  const std::vector<S> got = graph.response(impulses);
  ExactSum<S> square;  // of the slowest motion that opens all of them by 1
  for (std::size_t k = 0; k < graph.size(); ++k) {
    if (!all[k]) continue;
    if (!(got[k] > -wanted[k] / 2)) return std::numeric_limits<double>::infinity();
    square.add(-impulses[k] * wanted[k]);
  }
  return kPi / 2 * std::sqrt(static_cast<double>(square.rounded()));
}

/// Whether a group without losses, which may take `most` rounds, is not waited for.
template <class S>
[[nodiscard]] bool is_too_narrow(const ContactGraph<S>& graph, int most) {
  return rounds_to_open(graph) > std::max(most, kNarrow);
}

}  // namespace carom::event
