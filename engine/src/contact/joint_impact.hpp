#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "contact/contact_graph.hpp"
#include "contact/dissipation.hpp"
#include "contact/group_motion.hpp"
#include "contact/index.hpp"
#include "contact/jammed_contacts.hpp"
#include "contact/joint_report.hpp"
#include "contact/kept_energy.hpp"
#include "contact/nonnegative_impulses.hpp"
#include "contact/pair_friction.hpp"
#include "contact/pair_impact.hpp"
#include "contact/reflection_limits.hpp"
#include "contact/rounding_approaches.hpp"

namespace carom::event {

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
/// Where restitutions differ, the round that loses nothing may come again and again, so what has
/// lost energy often enough stays shut (stays_shut()), and its set no longer bounces.
/// Approaches within 64 u of the speeds the two had in this instant are rounding: they are nudged
/// apart by the least impulses, until no contact approaches in the bits pair_time() looks at.
/// Wedged balls cannot do that: what still approaches is locked to one velocity along that axis
/// with its momentum.
/// Jammed: in a gap of exactly zero between walls or fixed balls, as that of a ball as tall as its
/// box, a speed across has no limit as a sequence of impacts. Which contacts are so wedged in, or
/// come apart only in too many rounds, is told by how they lie, jammed_contacts.hpp, and asked when
/// reflections have not ended after kPatience. They then reflect with whatever else does, as one
/// face: that turns what goes into a narrow wedge, as many impacts would. What still approaches is
/// stopped, and held while the others go on; in the end the group gets the nearest velocities by
/// which nothing approaches. Where nothing is lost in an impact, all of them are longer by one
/// factor so that its energy stays; seen from its centre of mass, if it touches nothing fixed. What
/// vibrated in the gap so drives the group apart along the ways that are open. If there is none,
/// the group goes back the way it came, as far as that is open; if it is not, or it has gone back
/// in vain, the energy is held back, and counts as lost. Else it is lost, as after ever smaller
/// impacts.
/// Holds: numbering, sides, mirrors and swapped axes leave the bits as they are: every contact
/// sees the same old velocities, every sum is rounded once. Momentum of free groups to rounding.
/// Source: Smith, Kaufman, Vouga, Tamstorf, Grinspun, Reflections on simultaneous impact, ACM TOG
/// 31 (2012) 106; Vouga, Smith, Kaufman, Tamstorf, Grinspun, All's well that ends well, ACM TOG
/// 36 (2017) 151.
template <class S>
class JointImpact {
 public:
  /// `strokes`, if there is one, is given the impulse of each contact that is counted, in turn.
  /// `stops`: what reflections do not end is jammed, and does not go back.
  JointImpact(std::span<Body<S>> bodies, std::span<const Contact<S>> contacts,
              std::vector<Stroke<S>>* strokes = nullptr, bool stops = false)
      : bodies_(bodies),
        strokes_(strokes),
        stops_(stops),
        graph_(bodies, contacts),
        jammed_(contacts.size(), 0),
        turned_(contacts.size(), 0),
        bounces_(contacts.size(), 0),
        gains_(contacts.size(), S(0)) {}
  JointImpact(const JointImpact&) = delete;
  JointImpact& operator=(const JointImpact&) = delete;

  JointReport resolve() {
    const bool elastic = is_lossless(graph_);
    const int most = most_rounds(graph_);
    const std::vector<Vec<S>> start = elastic ? motion_.velocities() : std::vector<Vec<S>>{};
    bool stopped = false;
    while (const auto approaching = this->approaching()) {
      if (report_.rounds > 0 && report_.rounds % kPatience == 0 && graph_.size() <= kMostGuessed) {
        jammed_ = jammed_contacts(graph_, most_of_wedge(graph_, most), jammed_);
      }
      if (report_.rounds >= most || holds_any(*approaching)) {
        if (elastic) report_.jammed += static_cast<int>(count(*approaching));
        stopped = true;
        break;
      }
      ++report_.rounds;
      const std::size_t again = count_both(*approaching, turned_);
      if (again > 0) {
        if (elastic) report_.jammed += static_cast<int>(again);
        stopped = true;
        stop(turned_);
        hold_stopped();
      } else {
        reflect(*approaching, false);
      }
      motion_.note_peaks();
    }
    if (stopped) {
      ++report_.rounds;
      stop(motion_.mobile());
    }
    mend();
    for (int again = 0; again < 4 && elastic && (stopped || rounding_.locked() > 0); ++again) {
      const bool goes_back = again < 3 && !stops_;
      report_.held_energy =
          KeptEnergy<S>(bodies_, graph_).give_back(start, motion_.velocities(), goes_back);
      motion_.note_peaks();
      if (!motion_.approaching(false)) break;
      // What is left is rounding, and what goes back is not held.
      std::fill(jammed_.begin(), jammed_.end(), char{0});
      mend();
    }
    report_.settling = rounding_.rounds();
    report_.locked = rounding_.locked();
    report_.lost = elastic ? report_.held_energy : report_.lost + rounding_.lost();
    for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k].velocity = motion_.velocities()[k];
    return report_;
  }

  /// The impulse along the normal that each contact carried, as the change of the speed of approach
  /// that it makes by itself; what only mends rounding is not counted.
  const std::vector<S>& gains() const { return gains_; }

 private:
  using Chosen = typename GroupMotion<S>::Chosen;

  static std::size_t count(const Chosen& chosen) {
    return static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), 1));
  }

  static std::size_t count_both(const Chosen& one, const Chosen& other) {
    std::size_t both = 0;
    for (std::size_t k = 0; k < one.size(); ++k) both += one[k] != 0 && other[k] != 0 ? 1U : 0U;
    return both;
  }

  /// What is jammed reflects with what it holds.  lossless: as if every restitution were 1.
  void reflect(const Chosen& approaching, bool lossless) {
    Chosen chosen = approaching;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (jammed_[k] != 0) chosen[k] = jammed_[k];
      if (stays_shut(graph_, k, bounces_[k])) chosen[k] = 1;
    }
    const std::vector<std::size_t> set = graph_.coupled_sets(chosen);
    std::vector<int> members(graph_.size(), 0);
    std::vector<char> approaches(graph_.size(), 0);
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      members[set[k]] += chosen[k] != 0 ? 1 : 0;
      if (approaching[k] != 0) approaches[set[k]] = 1;
    }
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (approaches[set[k]] != 0 && jammed_[k] == kPushes) turned_[k] = 1;
    }
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (approaches[k] == 0) continue;
      if (members[k] == 1) {
        for (std::size_t m = 0; m < graph_.size(); ++m) {
          if (chosen[m] && set[m] == k) reflect_alone(m, lossless);
        }
      } else if (members[k] > 1) {
        Chosen together(graph_.size(), 0);
        for (std::size_t m = 0; m < graph_.size(); ++m) together[m] = set[m] == k ? chosen[m] : 0;
        reflect_together(together, lossless);
      }
    }
  }

  void note_impact(std::size_t k) {
    ++bounces_[k];
    ++(graph_.contact(k).b == kWall ? report_.walls : report_.impacts);
  }

  [[nodiscard]] S restitution_of(std::size_t k) const {
    return stays_shut(graph_, k, bounces_[k]) ? S(0) : graph_.contact(k).restitution;
  }

  void reflect_alone(std::size_t k, bool lossless) {
    const Contact<S>& c = graph_.contact(k);
    const S e = lossless ? S(1) : restitution_of(k);
    if (!lossless) {
      note_impact(k);
      const S approach = approach_speed(c.r, motion_.velocity(c.b) - motion_.velocity(c.a));
      gains_[k] = gains_[k] + (1 + e) * approach;
      report_.lost +=
          lost_to_restitution(static_cast<double>(approach), static_cast<double>(S(e * approach)),
                              static_cast<double>(graph_.mobility(k)));
      if (strokes_ != nullptr) {
        strokes_->push_back({k, S((1 + e) * approach / graph_.mobility(k)), approach, e});
      }
    }
    if (c.b == kWall) {
      Vec<S>& v = motion_.velocities()[index(c.a)];
      S& component = c.r.x != 0 ? v.x : v.y;
      component = wall_impact(component, e);
      return;
    }
    const auto after = pair_impact(c.r, motion_.velocity(c.a), motion_.velocity(c.b),
                                   graph_.inverse_mass(c.a), graph_.inverse_mass(c.b), e);
    motion_.velocities()[index(c.a)] = after.a;
    motion_.velocities()[index(c.b)] = after.b;
  }

  /// One reflection along the set's common impulse P: v + (1 + e) k P / m with k = -P.v / P.P/m,
  /// by which the energy is kept (e = 1) however P was rounded.
  void reflect_together(const Chosen& together, bool lossless) {
    const std::vector<S> impulses = nonnegative_impulses(graph_, motion_.partings(), together);
    S restitution = 1;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (!(impulses[k] > 0) || lossless || together[k] == kHolds) continue;
      note_impact(k);
      const S e = restitution_of(k);
      if (e < restitution) restitution = e;
    }
    apply(impulses, 1 + restitution, !lossless);
  }

  void apply(const std::vector<S>& impulses, const S& times, bool counted) {
    std::vector<Vec<S>>& velocities = motion_.velocities();
    const std::vector<Vec<S>> totals = graph_.totals(impulses);
    ExactSum<S> toward;
    ExactSum<S> size;
    for (std::size_t k = 0; k < totals.size(); ++k) {
      const Vec<S>& p = totals[k];
      const S& m = bodies_[k].inverse_mass;
      if (m == 0) continue;
      toward.add(p.x * velocities[k].x);
      toward.add(p.y * velocities[k].y);
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
            {k, S(-factor * impulses[k]), S(-graph_.parting(k, velocities)), S(times - 1)});
      }
    }
    for (std::size_t k = 0; k < totals.size(); ++k) {
      velocities[k] = less(velocities[k], S(factor * bodies_[k].inverse_mass), totals[k]);
    }
    for (std::size_t k = 0; k < gains_.size(); ++k) {
      if (impulses[k] > 0) gains_[k] = gains_[k] - factor * impulses[k] * graph_.mobility(k);
    }
  }

  void mend() {
    rounding_.end([this](const Chosen& chosen) { reflect(chosen, true); });
  }

  /// One inelastic impact of the contacts chosen, also of those that would approach only through
  /// it.
  void stop(const Chosen& chosen) {
    const std::vector<S> impulses = nonnegative_impulses(graph_, motion_.partings(), chosen);
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (impulses[k] > 0) note_impact(k);
    }
    apply(impulses, S(1), true);
  }

  /// Contacts that approach; what is held does, by rounding, until its end.
  [[nodiscard]] std::optional<Chosen> approaching() const {
    std::optional<Chosen> chosen = motion_.approaching(true);
    if (!chosen) return chosen;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (jammed_[k] != kHolds || (*chosen)[k] == 0) continue;
      if (graph_.parting(k, motion_.velocities()) < -S(kStopped) * motion_.peak(k)) continue;
      (*chosen)[k] = 0;
    }
    return count(*chosen) > 0 ? chosen : std::nullopt;
  }

  [[nodiscard]] bool holds_any(const Chosen& chosen) const {
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (chosen[k] != 0 && jammed_[k] == kHolds) return true;
    }
    return false;
  }

  /// What was turned and is stopped is held from now on; what opens is as others.
  void hold_stopped() {
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      if (turned_[k] == 0) continue;
      const S most = S(kStopped) * motion_.peak(k);
      jammed_[k] = graph_.parting(k, motion_.velocities()) > most ? 0 : kHolds;
      turned_[k] = 0;
    }
  }

  std::span<Body<S>> bodies_;
  std::vector<Stroke<S>>* strokes_;
  bool stops_;
  ContactGraph<S> graph_;
  GroupMotion<S> motion_{bodies_, graph_};
  RoundingApproaches<S> rounding_{bodies_, graph_, motion_};
  Chosen jammed_;             ///< known after kPatience rounds
  Chosen turned_;             ///< those that have been reflected with what they hold
  std::vector<int> bounces_;  ///< by contact
  std::vector<S> gains_;
  JointReport report_;
};

// In double it is compiled once, in joint_impact.cpp.
extern template class JointImpact<double>;

template <class S>
JointReport joint_impact(std::span<Body<S>> bodies, std::span<const Contact<S>> contacts,
                         bool stops = false) {
  return JointImpact<S>(bodies, contacts, nullptr, stops).resolve();
}

}  // namespace carom::event
