#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "solvers/event/disk.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/jam_level.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/nearing.hpp"
#include "solvers/event/prediction.hpp"
#include "solvers/event/resolutions.hpp"
#include "solvers/event/simultaneous_pairs.hpp"
#include "solvers/event/ties.hpp"

namespace carom::event {

/// Impacts of one ball at one instant of which later ones are not resolved together with the
/// earlier ones.
inline constexpr int kManyAtOnce = 256;

/// Which impacts of one instant are resolved alone, which with all that touches, and which are
/// over: what has been resolved, and is only pressed together from then on.
///
/// Holds: what it says does not depend on the order in which impacts were found.
template <class P>
class SimultaneousChoice {
 public:
  using At = typename P::At;
  using Disk = typename P::Disk;

  struct Balls {
    const HugeVector<Disk>& disks;
    const Prediction<P>& prediction;
  };
  /// What is known of the instant.
  struct Instant {
    SimultaneousPairs& pairs;
    const Resolutions& resolutions;
    Ties<typename P::Clock>& ties;
    const JamLevel& jam;
  };

  /// All must outlive this.
  SimultaneousChoice(const Motion<P>& motion, const Balls& balls, const Instant& instant)
      : motion_(motion),
        disks_(balls.disks),
        prediction_(balls.prediction),
        pairs_(instant.pairs),
        resolutions_(instant.resolutions),
        ties_(instant.ties),
        jam_(instant.jam) {}

  enum class Way { alone, together, over };
  [[nodiscard]] Way way_of(Index i, Index partner, At now) const {
    const bool ball = moves(partner);
    const bool again = resolutions_.contains(i) || (ball && resolutions_.contains(partner));
    const int hits = std::max(pairs_.hits(i), ball ? pairs_.hits(partner) : 0);
    if (again &&
        (pairs_.is_resolved(i, partner) || hits > kManyAtOnce || !comes_nearer(i, partner, now))) {
      return Way::over;
    }
    const bool together =
        again || jam_.jammed() || tied(i, partner, now) ||
        (motion_.clusters() && ball && motion_.collapses(disks_[i], disks_[partner], now));
    return together ? Way::together : Way::alone;
  }

  /// A ball that has been hit at this instant may be sent into several at once, of which its event
  /// is only one: to be linked whichever that is, all of them wait.
  void add_all_met(At now) {
    const std::size_t known = pairs_.waiting().size();
    const auto add = [&](Index i, Index j) {
      if (has_pair(pairs_.waiting(), i, j) || pairs_.is_resolved(i, j)) return;
      if (comes_nearer(i, j, now)) pairs_.wait(i, j);
    };
    for (std::size_t k = 0; k < known; ++k) {
      const Pair pair = pairs_.waiting()[k];
      for (const Index i : {pair.first, pair.second}) {
        if (!moves(i) || !resolutions_.contains(i)) continue;
        prediction_.each_met(i, now, [&](Index partner) { add(i, partner); });
      }
    }
  }

  struct Sorted {
    std::vector<Pair> alone;
    std::vector<Pair> together;
  };
  /// Takes all that wait: what shares a ball is together, and what is over is pressed.
  [[nodiscard]] Sorted take_waiting(At now) {
    Sorted sorted;
    std::vector<Index> balls;
    for (const Pair& pair : pairs_.take_waiting()) {
      const Way way = way_of(pair.first, pair.second, now);
      if (way == Way::over) {
        pairs_.press(pair);
        continue;
      }
      (way == Way::together ? sorted.together : sorted.alone).push_back(pair);
      balls.push_back(pair.first);
      if (moves(pair.second)) balls.push_back(pair.second);
    }
    std::sort(balls.begin(), balls.end());
    const auto shares = [&](Index k) {
      const auto [first, last] = std::equal_range(balls.begin(), balls.end(), k);
      return last - first > 1;
    };
    std::erase_if(sorted.alone, [&](const Pair& pair) {
      if (!shares(pair.first) && !(moves(pair.second) && shares(pair.second))) return false;
      sorted.together.push_back(pair);
      return true;
    });
    return sorted;
  }

 private:
  [[nodiscard]] bool moves(Index partner) const {
    return partner < kFirstMark && !motion_.fixed(disks_[partner]);
  }
  [[nodiscard]] bool comes_nearer(Index i, Index partner, At now) const {
    if (partner >= kWalls) return nears_wall(motion_, disks_[i], partner, now);
    return nears_ball(motion_, disks_[i], disks_[partner], now);
  }
  [[nodiscard]] bool tied(Index i, Index partner, At now) const {
    if (!ties_.any(now, i, partner)) return false;
    // A tie may be of what was known of a ball before: whether it was noted depends on what was
    // looked at when.
    return meets_another(i, partner, now) || (moves(partner) && meets_another(partner, i, now));
  }
  [[nodiscard]] bool meets_another(Index i, Index partner, At now) const {
    bool meets = false;
    prediction_.each_met(i, now, [&](Index other) { meets = meets || other != partner; });
    return meets;
  }

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  const Prediction<P>& prediction_;
  SimultaneousPairs& pairs_;
  const Resolutions& resolutions_;
  Ties<typename P::Clock>& ties_;
  const JamLevel& jam_;
};

}  // namespace carom::event
