#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event {

/// What a group may cost in one instant before the rest of it is taken inelastically, in rounds
/// times contacts squared, and how many rounds any group may take. A ball between a wall and one M
/// times as heavy needs pi sqrt(M) rounds, so without losses this is reached for M beyond 1e8, or
/// where balls are wedged in between walls and bounce for ever in no time at all.
inline constexpr double kMostWork = 1 << 18;
inline constexpr double kFewRounds = 128;
/// No wedge is waited for that may take more rounds than this.
inline constexpr int kNarrow = 1 << 12;
/// After so many bounces, divided by 1 - e, a contact of restitution e stays shut: if it is pressed
/// again it pushes together with what else of its balls reflects, and nothing of that bounces.
/// Between what bounces otherwise, as a wall of e = 1 and balls of e = 0, it would bounce for ever
/// in no time.  What comes apart, as a line of balls above its critical restitution, has done so.
inline constexpr double kBounces = 8;
/// After how many rounds it is asked what jams.
inline constexpr int kPatience = 8;
/// What jams and opens by less than this part of the fastest speed is held.
inline constexpr double kStopped = 0x1p-20;

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

/// Whether a contact that loses energy has bounced so often in this instant that it stays shut.
template <class S>
[[nodiscard]] bool stays_shut(const ContactGraph<S>& graph, std::size_t k, int bounces) {
  const auto loss = static_cast<double>(S(1 - graph.contact(k).restitution));
  return graph.mobility(k) > 0 && bounces * loss >= kBounces;
}

/// How many rounds are waited for, of a group without losses that may take `most`, until a wedge in
/// it comes apart: a row of balls takes as many as it has.
template <class S>
[[nodiscard]] int most_of_wedge(const ContactGraph<S>& graph, int most) {
  return std::min(std::max(most, 2 * static_cast<int>(graph.size())), kNarrow);
}

}  // namespace carom::event
