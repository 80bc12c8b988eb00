#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "contact/common_velocities.hpp"
#include "contact/dissipation.hpp"
#include "contact/kept_energy.hpp"
#include "contact/nonnegative_impulses.hpp"
#include "contact/pair_friction.hpp"
#include "contact/pair_impact.hpp"

namespace carom::event {

/// What resolving one instant took.
struct JointReport {
  int rounds = 0;    ///< generalised reflections
  int impacts = 0;   ///< contacts of balls that carried an impulse in them, counted every time
  int walls = 0;     ///< the same with walls
  int settling = 0;  ///< rounds for approaches that are rounding only
  int locked = 0;    ///< bodies that had to be given a common velocity: the last resort
  int jammed =
      0;  ///< contacts without a gap, with speed across it that no sequence of impacts ends
  /// Energy of jammed groups that nothing of theirs can move with: it counts as lost.
  double held_energy = 0;
  double lost = 0;  ///< energy that restitution took; what only mends rounding is not counted
};

/// The normal impulse of a contact in one reflection.
template <class S>
struct Stroke {
  std::size_t contact;
  S impulse;
  S approach;  ///< the speed before it
  S restitution;
};

/// What a group may cost in one instant before the rest of it is taken inelastically, in rounds
/// times contacts squared, and how many rounds any group may take. A ball between a wall and one M
/// times as heavy needs pi sqrt(M) rounds, so without losses this is reached for M beyond 1e8, or
/// where balls are wedged in between walls and bounce for ever in no time at all.
inline constexpr double kMostWork = 1 << 18;
inline constexpr double kFewRounds = 128;
inline constexpr int kAnyRounds = std::numeric_limits<int>::max();
/// A component of a normal that is smaller than this part of the other may be rounding.
inline constexpr double kRoundingOfNormal = 0x1p-40;

/// All impacts of one instant in a group of touching balls, walls and fixed balls, resolved
/// together.
///
/// Rule: All contacts that approach are reflected at once: the least impulses >= 0 that stop
/// their approach, times 1 + e; again until nothing approaches. A contact alone is a pair impact
/// to the last bit, so a cradle passes exactly as many balls on as come in; a corner reverses a
/// ball exactly. In a set of contacts that share a ball the smallest of their restitutions holds
/// (different ones could make energy). With e = 0 everywhere the whole is one inelastic impact, in
/// which each contact may push, not only those that approach.
/// Ends: A set of contacts reflects along its common impulse, whose length is set by the energy:
/// e = 1 keeps the energy to rounding, below 1 it falls. A group that can come apart does so
/// after finitely many rounds (Vouga et al. 2017); with e < 1 only in the limit, so after 8 (8 +
/// contacts) / (1 - e) rounds, or kMostWork, the rest is one inelastic impact of all contacts.
/// Approaches within 64 u of the speeds the two had in this instant are rounding: they are nudged
/// apart by the least impulses, until no contact approaches in the bits pair_time() looks at.
/// Wedged balls cannot do that: what still approaches is locked to one velocity along that axis
/// with its momentum.
/// Jammed: in a gap of exactly zero between walls or fixed balls, as that of a ball as tall as its
/// box, a speed across has no limit as a sequence of impacts, nor has a sequence that takes too
/// many rounds one that can be had. Where nothing is lost in an impact, such a group gets the
/// nearest velocities by which nothing approaches, all of them longer by one factor so that its
/// energy stays; seen from its centre of mass, if it touches nothing fixed. What vibrated in the
/// gap so drives the group apart along the ways that are open. If there is none, the energy is
/// held back, and counts as lost.
/// Holds: numbering, sides, mirrors and swapped axes leave the bits as they are: every contact
/// sees the same old velocities, every sum is rounded once. Momentum of free groups to rounding.
/// Source: Smith, Kaufman, Vouga, Tamstorf, Grinspun, Reflections on simultaneous impact, ACM TOG
/// 31 (2012) 106; Vouga, Smith, Kaufman, Tamstorf, Grinspun, All's well that ends well, ACM TOG
/// 36 (2017) 151.
template <class S>
class JointImpact {
 public:
  /// `strokes`, if there is one, is given the impulse of each contact that is counted, in turn.
  JointImpact(std::span<Body<S>> bodies, std::span<const Contact<S>> contacts,
              std::vector<Stroke<S>>* strokes = nullptr)
      : bodies_(bodies),
        strokes_(strokes),
        graph_(bodies, contacts),
        velocity_(bodies.size()),
        peak_(bodies.size()),
        gains_(contacts.size(), S(0)) {
    for (std::size_t k = 0; k < bodies.size(); ++k) velocity_[k] = bodies[k].velocity;
    note_peaks();
  }

  JointReport resolve() {
    const bool elastic = lossless();
    const int few = 16 + 4 * static_cast<int>(graph_.size());
    const int most = std::min(most_rounds(), elastic && is_too_narrow() ? few : kAnyRounds);
    const int soon = std::min(most, few);
    const std::vector<Vec<S>> start = elastic ? velocity_ : std::vector<Vec<S>>{};
    bool stopped = false;
    while (const auto approaching = choose(true)) {
      if (report_.rounds == most || (elastic && report_.rounds == soon && cannot_open())) {
        if (elastic) report_.jammed = static_cast<int>(count(*approaching));
        stop_everything();
        stopped = true;
        break;
      }
      ++report_.rounds;
      reflect(*approaching, false);
      note_peaks();
    }
    settle();
    for (int again = 0; again < 4 && elastic && (stopped || report_.locked > 0); ++again) {
      const double held = KeptEnergy<S>(bodies_, graph_).give_back(start, velocity_);
      if (again == 0) report_.held_energy += held;
      note_peaks();
      if (!choose(false)) break;
      settle();
    }
    if (elastic) report_.lost = report_.held_energy;
    for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k].velocity = velocity_[k];
    return report_;
  }

  /// The impulse along the normal that each contact carried, as the change of the speed of approach
  /// that it makes by itself; what only mends rounding is not counted.
  const std::vector<S>& gains() const { return gains_; }

 private:
  using Chosen = std::vector<char>;

  static std::size_t index(int body) { return static_cast<std::size_t>(body); }

  Vec<S> velocity(int body) const {
    return body == kWall ? Vec<S>{S(0), S(0)} : velocity_[index(body)];
  }

  bool lossless() const {
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (graph_.mobility(k) > 0 && graph_.contact(k).restitution != 1) return false;
    }
    return true;
  }

  static std::size_t count(const Chosen& chosen) {
    return static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), 1));
  }

  /// Whether the group is one body in a wedge so narrow that its pi / angle rounds are too many.
  bool is_too_narrow() const {
    if (graph_.size() != 2 || graph_.contact(0).a != graph_.contact(1).a) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const int other = graph_.contact(k).b;
      if (graph_.inverse_mass(other) != 0 || !(graph_.mobility(k) > 0)) return false;
    }
    const S turn = cross(graph_.normal(0), graph_.normal(1));
    const S along = sharp_dot(graph_.normal(0), graph_.normal(1));
    return along < 0 && absolute(turn) * most_rounds() < 3;
  }

  /// Whether some contact has no motion of the group that opens it while the others stay closed or
  /// open: then no impulses make all part at once.
  bool cannot_open() const {
    Chosen all(graph_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) all[k] = graph_.mobility(k) > 0 ? 1 : 0;
    const std::vector<S> wanted(graph_.size(), S(-1));
    const std::vector<S> got = graph_.response(nonnegative_impulses(graph_, wanted, all));
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (all[k] && !(got[k] > 0.5)) return true;
    }
    return false;
  }

  int most_rounds() const {
    S e = 0;
    for (std::size_t k = 0; k < graph_.size(); ++k) e = larger(e, graph_.contact(k).restitution);
    if (e == 0) return 0;
    const auto contacts = static_cast<double>(graph_.size());
    const auto loss = static_cast<double>(S(1 - e));
    const double most = std::max(kMostWork / (contacts * contacts), kFewRounds);
    const double lossy = 8 * (8 + contacts);
    return static_cast<int>(lossy < most * loss ? lossy / loss : most);
  }

  void note_peaks() {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const Vec<S>& v = velocity_[k];
      peak_[k] = larger(peak_[k], larger(absolute(v.x), absolute(v.y)));
    }
  }

  /// Contacts that approach, by more than rounding if so asked; nothing, if there are none.
  std::optional<Chosen> choose(bool beyond_rounding) const {
    const S noise = 64 * std::numeric_limits<S>::epsilon();
    Chosen chosen(graph_.size(), 0);
    bool any = false;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      const Contact<S>& c = graph_.contact(k);
      if (!(graph_.mobility(k) > 0)) continue;
      if (!(sharp_dot(c.r, velocity(c.b) - velocity(c.a)) < 0)) continue;
      if (beyond_rounding) {
        const S peak = peak_[index(c.a)] + (c.b == kWall ? S(0) : peak_[index(c.b)]);
        if (!(graph_.parting(k, velocity_) < -noise * peak)) continue;
      }
      chosen[k] = 1;
      any = true;
    }
    return any ? std::optional(chosen) : std::nullopt;
  }

  /// lossless: as if every restitution were 1.
  void reflect(const Chosen& chosen, bool lossless) {
    const std::vector<std::size_t> set = graph_.coupled_sets(chosen);
    std::vector<int> members(graph_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) members[set[k]] += chosen[k];
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (members[k] == 1) {
        for (std::size_t m = 0; m < graph_.size(); ++m) {
          if (chosen[m] && set[m] == k) reflect_alone(m, lossless);
        }
      } else if (members[k] > 1) {
        Chosen together(graph_.size(), 0);
        for (std::size_t m = 0; m < graph_.size(); ++m)
          together[m] = chosen[m] && set[m] == k ? 1 : 0;
        reflect_together(together, lossless);
      }
    }
  }

  void note_impact(std::size_t k) {
    ++(graph_.contact(k).b == kWall ? report_.walls : report_.impacts);
  }

  void reflect_alone(std::size_t k, bool lossless) {
    const Contact<S>& c = graph_.contact(k);
    const S e = lossless ? S(1) : c.restitution;
    if (!lossless) {
      note_impact(k);
      const S approach = approach_speed(c.r, velocity(c.b) - velocity(c.a));
      gains_[k] = gains_[k] + (1 + e) * approach;
      report_.lost +=
          lost_to_restitution(static_cast<double>(approach), static_cast<double>(S(e * approach)),
                              static_cast<double>(graph_.mobility(k)));
      if (strokes_ != nullptr) {
        strokes_->push_back({k, S((1 + e) * approach / graph_.mobility(k)), approach, e});
      }
    }
    if (c.b == kWall) {
      Vec<S>& v = velocity_[index(c.a)];
      S& component = c.r.x != 0 ? v.x : v.y;
      component = wall_impact(component, e);
      return;
    }
    const auto after = pair_impact(c.r, velocity(c.a), velocity(c.b), graph_.inverse_mass(c.a),
                                   graph_.inverse_mass(c.b), e);
    velocity_[index(c.a)] = after.a;
    velocity_[index(c.b)] = after.b;
  }

  /// One reflection along the set's common impulse P: v + (1 + e) k P / m with k = -P.v / P.P/m,
  /// by which the energy is kept (e = 1) however P was rounded.
  void reflect_together(const Chosen& together, bool lossless) {
    const std::vector<S> impulses = nonnegative_impulses(graph_, partings(), together);
    S restitution = 1;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (!(impulses[k] > 0) || lossless) continue;
      note_impact(k);
      const S& e = graph_.contact(k).restitution;
      if (e < restitution) restitution = e;
    }
    apply(impulses, 1 + restitution, !lossless);
  }

  void apply(const std::vector<S>& impulses, const S& times, bool counted) {
    const std::vector<Vec<S>> totals = graph_.totals(impulses);
    ExactSum<S> toward;
    ExactSum<S> size;
    for (std::size_t k = 0; k < totals.size(); ++k) {
      const Vec<S>& p = totals[k];
      const S& m = bodies_[k].inverse_mass;
      if (m == 0) continue;
      toward.add(p.x * velocity_[k].x);
      toward.add(p.y * velocity_[k].y);
      size.add(m * p.x * p.x);
      size.add(m * p.y * p.y);
    }
    const S needed = size.rounded();
    if (!(needed > 0)) return;
    const S factor = times * (toward.rounded() / needed);
    // The whole set reflects as one contact does, with toward / sqrt(needed) for its speed.
    report_.lost += static_cast<double>(S(times * (2 - times) * (toward.rounded() / needed))) *
                    static_cast<double>(toward.rounded()) / 2;
    if (strokes_ != nullptr && counted) {
      for (std::size_t k = 0; k < impulses.size(); ++k) {
        if (!(impulses[k] > 0)) continue;
        strokes_->push_back(
            {k, S(-factor * impulses[k]), S(-graph_.parting(k, velocity_)), S(times - 1)});
      }
    }
    for (std::size_t k = 0; k < totals.size(); ++k) {
      velocity_[k] = less(velocity_[k], S(factor * bodies_[k].inverse_mass), totals[k]);
    }
    for (std::size_t k = 0; k < gains_.size(); ++k) {
      if (impulses[k] > 0) gains_[k] = gains_[k] - factor * impulses[k] * graph_.mobility(k);
    }
  }

  std::vector<S> partings() const {
    std::vector<S> result(graph_.size());
    for (std::size_t k = 0; k < graph_.size(); ++k) result[k] = graph_.parting(k, velocity_);
    return result;
  }

  /// One inelastic impact of all contacts, also of those that would approach only through it.
  void stop_everything() {
    Chosen all(graph_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) all[k] = graph_.mobility(k) > 0 ? 1 : 0;
    const std::vector<S> impulses = nonnegative_impulses(graph_, partings(), all);
    ++report_.rounds;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (impulses[k] > 0) note_impact(k);
    }
    apply(impulses, S(1), true);
  }

  void settle() {
    S units = 2;
    while (choose(false)) {
      if (report_.settling == 12) {
        lock();
        return;
      }
      ++report_.settling;
      if (wedged_ || !nudge(units)) reflect(*choose(false), true);
      units = units * 2;
    }
  }

  /// The least impulses after which every contact parts by so many units of rounding of the
  /// speeds its two had; false, and nothing is done, if rounding is not all they would change, or
  /// if there are none: then the group is wedged, whatever the units.
  bool nudge(const S& units) {
    const S u = std::numeric_limits<S>::epsilon();
    std::vector<S> parting = partings();
    Chosen all(graph_.size(), 0);
    S fastest = 0;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      const Contact<S>& c = graph_.contact(k);
      const S peak = peak_[index(c.a)] + (c.b == kWall ? S(0) : peak_[index(c.b)]);
      parting[k] = parting[k] - units * u * peak;
      all[k] = graph_.mobility(k) > 0 ? 1 : 0;
      fastest = larger(fastest, peak);
    }
    const auto impulses = pivoted_impulses(graph_, parting, all, slack_of_impulses<S>());
    wedged_ = !impulses;
    if (wedged_) return false;
    const std::vector<Vec<S>> totals = graph_.totals(*impulses);
    std::vector<Vec<S>> nudged = velocity_;
    const S most = 1048576 * u * fastest;
    for (std::size_t k = 0; k < totals.size(); ++k) {
      nudged[k] = less(velocity_[k], S(-bodies_[k].inverse_mass), totals[k]);
      const Vec<S> change = nudged[k] - velocity_[k];
      if (!(absolute(change.x) < most && absolute(change.y) < most)) return false;
    }
    velocity_ = nudged;
    return true;
  }

  /// Balls that approach are given one velocity, along the axis where their contact lies on one,
  /// and stay one body so, until nothing approaches.
  void lock() {
    const double had = energy();
    CommonVelocities<S> common(bodies_, graph_);
    // First along the axes that a contact does not only seem to have by rounding.
    S least = kRoundingOfNormal;
    while (const auto approaching = choose(false)) {
      for (std::size_t k = 0; k < graph_.size(); ++k) {
        if ((*approaching)[k]) common.join(k, least);
      }
      least = 0;
      common.give(velocity_);
    }
    report_.locked = common.joined();
    report_.lost += had - energy();
  }

  double energy() const {
    ExactSum<double> sum;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (bodies_[k].inverse_mass == 0) continue;
      const auto mass = static_cast<double>(S(1 / bodies_[k].inverse_mass));
      const auto x = static_cast<double>(velocity_[k].x);
      const auto y = static_cast<double>(velocity_[k].y);
      sum.add(mass * (x * x) / 2);
      sum.add(mass * (y * y) / 2);
    }
    return sum.rounded();
  }

  std::span<Body<S>> bodies_;
  std::vector<Stroke<S>>* strokes_;
  ContactGraph<S> graph_;
  std::vector<Vec<S>> velocity_;
  std::vector<S> peak_;
  std::vector<S> gains_;
  bool wedged_ = false;
  JointReport report_;
};

// In double it is compiled once, in joint_impact.cpp.
extern template class JointImpact<double>;

template <class S>
JointReport joint_impact(std::span<Body<S>> bodies, std::span<const Contact<S>> contacts) {
  return JointImpact<S>(bodies, contacts).resolve();
}

}  // namespace carom::event
