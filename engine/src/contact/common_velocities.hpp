#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event {

/// Bodies that are joined to one along an axis: they get one velocity along it, with their
/// momentum, or none where they are joined to what never moves.
template <class S>
class CommonVelocities {
 public:
  CommonVelocities(std::span<const Body<S>> bodies, const ContactGraph<S>& graph)
      : bodies_(bodies), graph_(graph), joined_(bodies.size(), 0) {
    for (DisjointSets& axis : sets_) axis.reset(bodies.size() + 1);
  }

  /// Joins the two of a contact along the axes of which its normal has a part, one larger than
  /// `least` of the other.
  void join(std::size_t contact, const S& least) {
    const Contact<S>& c = graph_.contact(contact);
    for (const int body : {c.a, c.b}) {
      if (graph_.inverse_mass(body) != 0) joined_[static_cast<std::size_t>(body)] = 1;
    }
    const S x = absolute(c.r.x);
    const S y = absolute(c.r.y);
    if (x > least * y) sets_[0].merge(number(c.a), number(c.b));
    if (y > least * x) sets_[1].merge(number(c.a), number(c.b));
  }
  void give(std::vector<Vec<S>>& velocities) const {
    give(sets_[0], &Vec<S>::x, velocities);
    give(sets_[1], &Vec<S>::y, velocities);
  }
  /// Whether one of the two of a contact never moves, or is joined to what never does along both
  /// axes.
  [[nodiscard]] bool is_beside_still(std::size_t contact) const {
    const Contact<S>& c = graph_.contact(contact);
    return is_still(c.a) || is_still(c.b);
  }
  /// How fast an impulse parts the two of a contact, if each of them is joined to nothing or never
  /// moves.  Else 0; also at walls, and for a contact on an axis: its two can be joined along that.
  [[nodiscard]] S free_mobility(std::size_t contact) const {
    const Contact<S>& c = graph_.contact(contact);
    if (c.b == kWall || c.r.x == 0 || c.r.y == 0) return S(0);
    S sum = 0;
    for (const int body : {c.a, c.b}) {
      if (is_still(body)) continue;
      if (!is_free(body)) return S(0);
      sum = sum + graph_.inverse_mass(body);
    }
    return sum;
  }
  [[nodiscard]] bool is_free(int body) const {
    return graph_.inverse_mass(body) != 0 && joined_[static_cast<std::size_t>(body)] == 0;
  }
  /// How many bodies have been joined to others.
  [[nodiscard]] int joined() const {
    int count = 0;
    for (const char joined : joined_) count += joined;
    return count;
  }

 private:
  // In the sets, a body is its number and one more.
  static constexpr std::uint32_t kStill = 0;

  [[nodiscard]] bool is_still(int body) const {
    return sets_[0].look_up(number(body)) == kStill && sets_[1].look_up(number(body)) == kStill;
  }
  [[nodiscard]] std::uint32_t number(int body) const {
    return graph_.inverse_mass(body) == 0 ? kStill : static_cast<std::uint32_t>(body) + 1;
  }

  void give(const DisjointSets& sets, S Vec<S>::*along, std::vector<Vec<S>>& velocities) const {
    for (std::uint32_t set = 0; set <= bodies_.size(); ++set) {
      if (sets.look_up(set) != set) continue;
      ExactSum<S> mass;
      ExactSum<S> momentum;
      std::vector<std::size_t> members;
      sets.each(set, [&](std::uint32_t k) {
        if (k == kStill || bodies_[k - 1].inverse_mass == 0) return;
        members.push_back(k - 1);
        mass.add(1 / bodies_[k - 1].inverse_mass);
        momentum.add(velocities[k - 1].*along / bodies_[k - 1].inverse_mass);
      });
      const bool stops = set == kStill;
      if (members.empty() || (members.size() == 1 && !stops)) continue;
      const S common = stops ? S(0) : S(momentum.rounded() / mass.rounded());
      for (const std::size_t k : members) velocities[k].*along = common;
    }
  }

  std::span<const Body<S>> bodies_;
  const ContactGraph<S>& graph_;
  std::array<DisjointSets, 2> sets_;  ///< by axis
  std::vector<char> joined_;
};

}  // namespace carom::event
