#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "contact/common_velocities.hpp"
#include "contact/contact_graph.hpp"
#include "contact/group_motion.hpp"
#include "contact/nonnegative_impulses.hpp"
#include "contact/pair_impact.hpp"

namespace carom::event {

/// A component of a normal that is smaller than this part of the other may be rounding.
inline constexpr double kRoundingOfNormal = 0x1p-40;

/// How often approaches that are rounding are reflected or nudged apart, of wedged bodies and of
/// others.
inline constexpr int kFewRounding = 3;
inline constexpr int kMostRounding = 12;

/// Ends approaches that are rounding only, until no contact of a group approaches in the bits that
/// pair_time() looks at.
///
/// The least impulses nudge the bodies apart; where these would do more than mend rounding, the
/// contacts are reflected.  Wedged bodies come apart by neither: what still approaches after a
/// few rounds is locked to one velocity along that axis, with its momentum.
template <class S>
class RoundingApproaches {
 public:
  /// All must outlive it.
  RoundingApproaches(std::span<const Body<S>> bodies, const ContactGraph<S>& graph,
                     GroupMotion<S>& motion)
      : bodies_(bodies), graph_(graph), motion_(motion) {}

  /// `reflect` reflects some contacts, given by contact, as if every restitution were 1.
  template <class Reflect>
  void end(Reflect reflect) {
    S units = 2;
    bool failed = false;  // to nudge them apart
    for (int round = 0; motion_.approaching(false); ++round) {
      if (round >= (failed ? kFewRounding : kMostRounding)) {
        lock();
        return;
      }
      ++rounds_;
      failed = failed || !nudge(units);
      if (failed) reflect(*motion_.approaching(false));
      units = units * 2;
    }
  }

  [[nodiscard]] int rounds() const { return rounds_; }
  /// Bodies that had to be given a common velocity: the last resort.
  [[nodiscard]] int locked() const { return locked_; }
  /// The energy that locking took.
  [[nodiscard]] double lost() const { return lost_; }

 private:
  /// The least impulses after which every contact parts by so many units of rounding of the
  /// speeds its two had; false, and nothing is done, if rounding is not all they would change, or
  /// if there are none.
  bool nudge(const S& units) {
    const S u = std::numeric_limits<S>::epsilon();
    std::vector<S> parting = motion_.partings();
    S fastest = 0;
    for (std::size_t k = 0; k < graph_.size(); ++k) {
      const S peak = motion_.peak(k);
      parting[k] = parting[k] - units * u * peak;
      fastest = larger(fastest, peak);
    }
    const auto impulses = least_impulses<S>(graph_, parting, motion_.mobile(), nullptr);
    if (!impulses) return false;
    const std::vector<Vec<S>> totals = graph_.totals(*impulses);
    const std::vector<Vec<S>>& old = motion_.velocities();
    std::vector<Vec<S>> nudged = old;
    const S most = 1048576 * u * fastest;
    for (std::size_t k = 0; k < totals.size(); ++k) {
      nudged[k] = less(old[k], S(-bodies_[k].inverse_mass), totals[k]);
      const Vec<S> change = nudged[k] - old[k];
      if (!(absolute(change.x) < most && absolute(change.y) < most)) return false;
    }
    motion_.velocities() = std::move(nudged);
    return true;
  }

  /// Balls that approach are given one velocity, along the axis where their contact lies on one,
  /// and stay one body so, until nothing approaches.  That begins at what never moves, and what is
  /// no part of such a body is only stopped along the contact, as long as that helps.
  void lock() {
    const double had = motion_.energy();
    CommonVelocities<S> common(bodies_, graph_);
    // First along the axes that a contact does not only seem to have by rounding.
    S least = kRoundingOfNormal;
    std::vector<int> stops(graph_.size(), 0);
    while (const auto approaching = motion_.approaching(false)) {
      std::vector<char> chosen(graph_.size(), 0);
      for (std::size_t k = 0; k < graph_.size(); ++k) {
        if ((*approaching)[k] != 0 && common.is_beside_still(k)) chosen[k] = 1;
      }
      if (std::find(chosen.begin(), chosen.end(), 1) == chosen.end()) chosen = *approaching;
      std::vector<S> impulses(graph_.size(), S(0));
      std::vector<char> joins(graph_.size(), 0);
      for (std::size_t k = 0; k < graph_.size(); ++k) {
        if (chosen[k] == 0) continue;
        const S mobility = common.free_mobility(k);
        if (mobility > 0 && stops[k] < kFewRounding) {
          const S noise = S(2 << stops[k]) * std::numeric_limits<S>::epsilon() * motion_.peak(k);
          impulses[k] = (noise - graph_.parting(k, motion_.velocities())) / mobility;
          ++stops[k];
        } else {
          joins[k] = 1;
        }
      }
      push(impulses, common);
      for (std::size_t k = 0; k < graph_.size(); ++k) {
        if (joins[k] != 0) common.join(k, least);
      }
      least = 0;
      common.give(motion_.velocities());
    }
    locked_ = common.joined();
    lost_ += had - motion_.energy();
  }

  /// What is joined to nothing takes them.
  void push(const std::vector<S>& impulses, const CommonVelocities<S>& common) {
    const std::vector<Vec<S>> totals = graph_.totals(impulses);
    for (std::size_t k = 0; k < totals.size(); ++k) {
      if ((totals[k].x == 0 && totals[k].y == 0) || !common.is_free(static_cast<int>(k))) continue;
      Vec<S>& v = motion_.velocities()[k];
      v = less(v, S(-bodies_[k].inverse_mass), totals[k]);
    }
  }

  std::span<const Body<S>> bodies_;
  const ContactGraph<S>& graph_;
  GroupMotion<S>& motion_;
  int rounds_ = 0;
  int locked_ = 0;
  double lost_ = 0;
};

}  // namespace carom::event
