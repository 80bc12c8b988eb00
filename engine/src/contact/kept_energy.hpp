#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "contact/contact_graph.hpp"
#include "contact/nonnegative_impulses.hpp"
#include "contact/pair_impact.hpp"

namespace carom::event {

/// What goes back the way it came can do so with at least this part of its energy; and how often
/// what is closed of that way is taken off, as that is rounded.
inline constexpr double kWayBack = 0x1p-20;
inline constexpr int kTurnsBack = 3;

/// Gives groups of touching bodies the energy back that they had before they were stopped: by one
/// factor for the velocities of all bodies of a group, seen from its centre of mass unless it
/// touches something fixed.
template <class S>
class KeptEnergy {
 public:
  KeptEnergy(std::span<const Body<S>> bodies, const ContactGraph<S>& graph)
      : bodies_(bodies), graph_(graph) {}

  /// `start`: the velocities before.  Gives the energy of groups that nothing of theirs can move
  /// with.  `goes_back`: if no other way is open, a group may go back the way it came; what it then
  /// meets is for the caller to end, who asks once more.
  double give_back(const std::vector<Vec<S>>& start, std::vector<Vec<S>>& velocities,
                   bool goes_back = true) {
    find_groups();
    ExactSum<double> held;
    for (std::uint32_t group = 0; group < bodies_.size(); ++group) {
      if (groups_.look_up(group) != group) continue;
      ExactSum<S> mass;
      ExactSum<S> x;
      ExactSum<S> y;
      Members members;
      groups_.each(group, [&](std::uint32_t k) {
        if (bodies_[k].inverse_mass == 0) return;
        members.push_back(k);
        mass.add(1 / bodies_[k].inverse_mass);
        x.add(velocities[k].x / bodies_[k].inverse_mass);
        y.add(velocities[k].y / bodies_[k].inverse_mass);
      });
      if (members.empty()) continue;
      const Vec<S> centre = held_[group] != 0 ? Vec<S>{S(0), S(0)}
                                              : Vec<S>{S(x.rounded() / mass.rounded()),
                                                       S(y.rounded() / mass.rounded())};
      const S had = energy(members, start, centre);
      const S has = energy(members, velocities, centre);
      if (!(had > 0) || had == has) continue;
      const S noise = std::numeric_limits<S>::epsilon() * had;
      if (has > noise) {
        const S factor = root(S(had / has));
        for (const std::size_t k : members)
          velocities[k] = centre + factor * (velocities[k] - centre);
      } else if (had - has > noise && !(goes_back && go_back(members, start, centre, velocities))) {
        held.add(static_cast<double>(S((had - has) / 2)));
      }
    }
    return held.rounded();
  }

 private:
  using Members = std::vector<std::size_t>;

  [[nodiscard]] bool moves(int body) const { return graph_.inverse_mass(body) != 0; }

  // Those that touch, over bodies that can move; which of them touch something fixed.
  void find_groups() {
    groups_.reset(bodies_.size());
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      const Contact<S>& c = graph_.contact(k);
      if (!moves(c.a) || !moves(c.b)) continue;
      groups_.merge(static_cast<std::uint32_t>(c.a), static_cast<std::uint32_t>(c.b));
    }
    held_.assign(bodies_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      const Contact<S>& c = graph_.contact(k);
      if (moves(c.a) == moves(c.b)) continue;
      held_[groups_.find(static_cast<std::uint32_t>(moves(c.a) ? c.a : c.b))] = 1;
    }
  }

  // A group that no other way is open to goes back the way it came, as out of a wedge, as far as
  // that is open, with all of its energy.
  bool go_back(const Members& members, const std::vector<Vec<S>>& start, const Vec<S>& centre,
               std::vector<Vec<S>>& velocities) const {
    std::vector<Vec<S>> back = velocities;
    for (const std::size_t k : members) back[k] = centre + (centre - start[k]);
    std::vector<char> mobile(graph_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) mobile[k] = graph_.mobility(k) > 0 ? 1 : 0;
    for (int turn = 0; turn < kTurnsBack; ++turn) {
      std::vector<S> parting(graph_.size());
      for (std::size_t k = 0; k < graph_.size(); ++k) parting[k] = graph_.parting(k, back);
      const std::vector<Vec<S>> totals =
          graph_.totals(nonnegative_impulses(graph_, parting, mobile));
      for (const std::size_t k : members) {
        back[k] = less(back[k], S(-bodies_[k].inverse_mass), totals[k]);
      }
    }
    const S had = energy(members, start, centre);
    const S has = energy(members, back, centre);
    if (!(has > S(kWayBack) * had)) return false;
    const S factor = root(S(had / has));
    for (const std::size_t k : members) velocities[k] = centre + factor * (back[k] - centre);
    return true;
  }

  [[nodiscard]] S energy(const Members& members, const std::vector<Vec<S>>& velocities,
                         const Vec<S>& centre) const {
    ExactSum<S> sum;
    for (const std::size_t k : members) {
      const Vec<S> v = velocities[k] - centre;
      sum.add(v.x * v.x / bodies_[k].inverse_mass);
      sum.add(v.y * v.y / bodies_[k].inverse_mass);
    }
    return sum.rounded();
  }

  std::span<const Body<S>> bodies_;
  const ContactGraph<S>& graph_;
  DisjointSets groups_;
  std::vector<char> held_;  ///< by root
};

}  // namespace carom::event
