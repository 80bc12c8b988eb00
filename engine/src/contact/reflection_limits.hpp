#pragma once

#include <algorithm>
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
inline constexpr int kAnyRounds = std::numeric_limits<int>::max();

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

/// Whether the group is one body in a wedge so narrow that its pi / angle rounds are too many.
template <class S>
[[nodiscard]] bool is_too_narrow(const ContactGraph<S>& graph) {
  if (graph.size() != 2 || graph.contact(0).a != graph.contact(1).a) return false;
  for (std::size_t k = 0; k < 2; ++k) {
    const int other = graph.contact(k).b;
    if (graph.inverse_mass(other) != 0 || !(graph.mobility(k) > 0)) return false;
  }
  const S turn = cross(graph.normal(0), graph.normal(1));
  const S along = sharp_dot(graph.normal(0), graph.normal(1));
  return along < 0 && absolute(turn) * most_rounds(graph) < 3;
}

/// Whether some contact has no motion of the group that opens it while the others stay closed or
/// open: then no impulses make all part at once.
template <class S>
[[nodiscard]] bool cannot_open(const ContactGraph<S>& graph) {
  std::vector<char> all(graph.size(), 0);
  for (std::size_t k = 0; k < graph.size(); ++k) all[k] = graph.mobility(k) > 0 ? 1 : 0;
  const std::vector<S> wanted(graph.size(), S(-1));
  const std::vector<S> got = graph.response(nonnegative_impulses(graph, wanted, all));
  for (std::size_t k = 0; k < graph.size(); ++k) {
    if (all[k] && !(got[k] > 0.5)) return true;
  }
  return false;
}

}  // namespace carom::event
