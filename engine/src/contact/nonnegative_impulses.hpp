#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event {

/// A product of two columns over the wanted contacts, rounded the same in any order.
template <class S>
S product(const std::vector<S>& a, const std::vector<S>& b, const std::vector<char>& wanted) {
  ExactSum<S> sum;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (wanted[k]) sum.add(a[k] * b[k]);
  }
  return sum.rounded();
}

/// What remains of equations that have a solution may grow by so much on the way to it.
inline constexpr double kGrowth = 0x1p40;

/// What contacts give way in a guess which of them carry, how often that is taken back, and how
/// small an impulse is none.
inline constexpr double kGuessGives = 0x1p-20;
inline constexpr int kGuessRefinements = 3;
inline constexpr double kGuessSlack = 0x1p-24;
/// What is left of speeds that should be stopped by so small a part is rounding.
inline constexpr double kNearly = 0x1p-20;

/// How fast impulses make each contact part, and how far it gives way to its own, `give` by
/// contact; empty: none does.
template <class S>
std::vector<S> response(const ContactGraph<S>& graph, const std::vector<S>& impulses,
                        const std::vector<S>& give) {
  std::vector<S> result = graph.response(impulses);
  for (std::size_t k = 0; k < give.size(); ++k) result[k] = result[k] + give[k] * impulses[k];
  return result;
}

/// How much of what is to be stopped remains, at a time and how often.
template <class S>
struct Accuracy {
  S part = std::numeric_limits<S>::epsilon();
  int restarts = 2;
};

/// Impulses at the `active` contacts that bring their parting speeds from `parting` to zero:
/// conjugate gradients, preconditioned by each contact's own mobility. Where more contacts hold a
/// body than it has freedoms, the equations are consistent if parting comes from a motion, and the
/// smallest solution is found; else what remains grows in the end, and the nearest is taken.
template <class S>
std::vector<S> stopping_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                 const std::vector<char>& active, const std::vector<S>& give,
                                 std::vector<S> impulses, const Accuracy<S>& accuracy = {}) {
  const std::size_t n = graph.size();
  const S& u = accuracy.part;
  for (int restart = 0; restart < accuracy.restarts; ++restart) {
    const std::vector<S> now = response(graph, impulses, give);
    std::vector<S> rest(n, S(0));
    std::vector<S> scaled(n, S(0));
    for (std::size_t k = 0; k < n; ++k) {
      if (!active[k]) continue;
      rest[k] = -(parting[k] + now[k]);
      scaled[k] = rest[k] / graph.mobility(k);
    }
    std::vector<S> step = scaled;
    S size = product(rest, scaled, active);
    const S goal = size * u * u;
    S least = size;
    std::vector<S> best = impulses;
    for (std::size_t k = 0; k < 2 * n + 4 && size > goal; ++k) {
      const std::vector<S> change = response(graph, step, give);
      const S curvature = product(step, change, active);
      if (!(curvature > 0)) break;
      const S length = size / curvature;
      for (std::size_t c = 0; c < n; ++c) {
        if (!active[c]) continue;
        impulses[c] = impulses[c] + length * step[c];
        rest[c] = rest[c] - length * change[c];
        scaled[c] = rest[c] / graph.mobility(c);
      }
      const S next = product(rest, scaled, active);
      const S turn = next / size;
      for (std::size_t c = 0; c < n; ++c) {
        if (active[c]) step[c] = scaled[c] + turn * step[c];
      }
      size = next;
      if (size < least) {
        least = size;
        best = impulses;
      } else if (!(size <= kGrowth * least)) {
        impulses = best;
        break;
      }
    }
  }
  return impulses;
}

/// Impulses >= 0 for the same problem, by descent: every contact that approaches is let in at once,
/// and the way to the stopping impulses ends where the first of them would become negative, which
/// then leaves.  Each pass takes energy, so that it ends where block pivoting goes round in
/// circles. Ties enter and leave together: no order is seen.
/// Source: Lawson and Hanson, Solving
/// Least Squares Problems (1974), ch. 23, with several at once.
template <class S>
std::vector<S> descending_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                   const std::vector<char>& allowed, const S& slack,
                                   const std::vector<S>& give) {
  const std::size_t n = graph.size();
  std::vector<char> active(n, 0);
  std::vector<S> impulses(n, S(0));
  S fastest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (allowed[k] && parting[k] < 0) fastest = larger(fastest, S(-parting[k]));
  }
  for (std::size_t pass = 0; pass < 4 * n + 16; ++pass) {
    const std::vector<S> change = response(graph, impulses, give);
    bool enters = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (pass == 0 && allowed[k] == kHolds) active[k] = 1;
      enters = enters || (pass == 0 && allowed[k] == kHolds);
      if (!allowed[k] || active[k] || !(parting[k] + change[k] < -slack * fastest)) continue;
      active[k] = 1;
      enters = true;
    }
    if (!enters) break;
    for (std::size_t leaving = 0; leaving < n; ++leaving) {
      const std::vector<S> goal =
          stopping_impulses(graph, parting, active, give, std::vector<S>(n, S(0)));
      S part = 1;
      for (std::size_t k = 0; k < n; ++k) {
        if (!active[k] || allowed[k] == kHolds || !(goal[k] < 0)) continue;
        const S until = impulses[k] / (impulses[k] - goal[k]);
        if (until < part) part = until;
      }
      for (std::size_t k = 0; k < n; ++k) {
        if (!active[k]) continue;
        if (allowed[k] == kHolds) {
          impulses[k] = impulses[k] + part * (goal[k] - impulses[k]);
          continue;
        }
        const bool leaves = goal[k] < 0 && !(impulses[k] / (impulses[k] - goal[k]) > part);
        impulses[k] = leaves ? S(0) : larger(S(impulses[k] + part * (goal[k] - impulses[k])), S(0));
        if (leaves) active[k] = 0;
      }
      if (!(part < 1)) break;
    }
  }
  return impulses;
}

/// Which contacts may carry the impulses that are looked for: a guess, in which rounding does not
/// show.
template <class S>
std::vector<char> likely_to_carry(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                  const std::vector<char>& allowed) {
  const std::size_t n = graph.size();
  std::vector<char> active(n, 0);
  std::vector<double> speeds(n);
  for (std::size_t k = 0; k < n; ++k) {
    speeds[k] = static_cast<double>(parting[k]);
    active[k] = allowed[k] == kHolds || (allowed[k] == kPushes && parting[k] < 0) ? 1 : 0;
  }
  const ResponseMatrix response = graph.response_matrix();
  std::vector<double> impulses =
      guess_impulses(response, speeds, allowed, kGuessGives, kGuessRefinements);
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    impulses[k] *= response.at(k, k);
    largest = std::max(largest, impulses[k]);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (allowed[k] == kPushes) active[k] = impulses[k] > kGuessSlack * largest ? 1 : 0;
  }
  return active;
}

/// The solution of the linear complementarity problem 0 <= impulse | parting + response >= 0, where
/// block pivoting finds it: all wrong signs are changed at once, so no contact is favoured. Nothing
/// where that goes round in circles, as it does where there is none.
/// Source: Portugal, Judice, Vicente, Math. Comput. 63 (1994) 625.
template <class S>
std::optional<std::vector<S>> pivoted_impulses(const ContactGraph<S>& graph,
                                               const std::vector<S>& parting,
                                               const std::vector<char>& allowed, const S& slack,
                                               const std::vector<S>& give = {}) {
  const std::size_t n = graph.size();
  std::vector<char> active(n, 0);
  S largest_parting = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!allowed[k]) continue;
    active[k] = allowed[k] == kHolds || parting[k] < 0 ? 1 : 0;
    if (parting[k] < 0) largest_parting = larger(largest_parting, S(-parting[k]));
  }
  std::vector<std::vector<char>> tried;
  const std::size_t most = n < 16 ? 3 * n + 16 : 64;  // most sets need a few
  while (tried.size() < most) {
    // One set leads to the next, whatever came before.
    if (std::find(tried.begin(), tried.end(), active) != tried.end()) return std::nullopt;
    tried.push_back(active);
    std::vector<S> impulses =
        stopping_impulses(graph, parting, active, give, std::vector<S>(n, S(0)));
    const std::vector<S> change = response(graph, impulses, give);
    S largest = 0;
    for (const S& impulse : impulses) largest = larger(largest, absolute(impulse));
    bool changed = false;
    for (std::size_t k = 0; k < n; ++k) {
      const S speed = parting[k] + change[k];
      if (active[k] && allowed[k] == kPushes && impulses[k] < -slack * largest) {
        active[k] = 0;
        changed = true;
      } else if (!active[k] && allowed[k] && speed < -slack * largest_parting) {
        active[k] = 1;
        changed = true;
      }
    }
    if (changed) continue;
    for (std::size_t k = 0; k < n; ++k) {
      if (allowed[k] == kPushes && impulses[k] < 0) impulses[k] = S(0);
    }
    return impulses;
  }
  return std::nullopt;
}

/// So small a part of the largest speed, or impulse, is none: 2^-40 in double.
template <class S>
S slack_of_impulses() {
  return root(std::numeric_limits<S>::epsilon()) / 16384;
}

/// What impulses leave, as parts of the largest speed of approach and of the largest impulse.
template <class S>
struct LeftWrong {
  S approach = 0;  ///< the fastest that is left
  S missed = 0;    ///< the fastest at a contact that carries
  S pull = 0;      ///< the largest
};
template <class S>
LeftWrong<S> left_wrong(const ContactGraph<S>& graph, const std::vector<S>& parting,
                        const std::vector<char>& allowed, const std::vector<char>& active,
                        const std::vector<S>& give, const std::vector<S>& impulses) {
  const std::vector<S> change = response(graph, impulses, give);
  S fastest = 0;
  S largest = 0;
  LeftWrong<S> wrong;
  for (std::size_t k = 0; k < graph.size(); ++k) {
    if (!allowed[k]) continue;
    const S speed = parting[k] + change[k];
    fastest = larger(fastest, S(-parting[k]));
    largest = larger(largest, absolute(impulses[k]));
    if (active[k]) {
      wrong.missed = larger(wrong.missed, absolute(speed));
      if (allowed[k] == kPushes) wrong.pull = larger(wrong.pull, S(-impulses[k]));
    } else {
      wrong.approach = larger(wrong.approach, S(-speed));
    }
  }
  if (largest > 0) wrong.pull = wrong.pull / largest;
  if (fastest > 0) {
    wrong.approach = wrong.approach / fastest;
    wrong.missed = wrong.missed / fastest;
  }
  return wrong;
}

/// Impulses at the contacts that carry, spread over them as in a guess, where more of them hold a
/// body than it has freedoms.
template <class S>
std::vector<S> spread_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                               const std::vector<char>& active, const std::vector<S>& give) {
  const std::size_t n = graph.size();
  std::vector<S> gives(n);
  for (std::size_t k = 0; k < n; ++k) gives[k] = S(kGuessGives) * graph.mobility(k);
  std::vector<S> impulses(n, S(0));
  for (int round = 0; round <= kGuessRefinements; ++round) {
    std::vector<S> from = parting;
    for (std::size_t k = 0; k < n; ++k) from[k] = from[k] - gives[k] * impulses[k];
    impulses = stopping_impulses(graph, from, active, gives, impulses, {S(kGuessSlack), 1});
  }
  // Of contacts that are dependent but for rounding that would be something else.
  std::vector<S> closer = stopping_impulses(graph, parting, active, give, impulses);
  S largest = 0;
  S most = 0;
  for (std::size_t k = 0; k < n; ++k) {
    largest = larger(largest, absolute(S(impulses[k] * graph.mobility(k))));
    most = larger(most, absolute(S((closer[k] - impulses[k]) * graph.mobility(k))));
  }
  return most <= largest / 1024 ? closer : impulses;
}

/// The least impulses at the `allowed` contacts, >= 0 but at those that hold, after which none of
/// them approaches.  What holds gives way a little, as it may be held where there is no room at
/// all.  Nothing where there are none; then `nearest` has those that leave least.
template <class S>
std::optional<std::vector<S>> least_impulses(const ContactGraph<S>& graph,
                                             const std::vector<S>& parting,
                                             const std::vector<char>& allowed,
                                             std::vector<S>* nearest) {
  const S slack = slack_of_impulses<S>();
  const std::size_t n = graph.size();
  std::vector<S> give;
  if (std::find(allowed.begin(), allowed.end(), kHolds) != allowed.end()) {
    give.assign(n, S(0));
    for (std::size_t k = 0; k < n; ++k) {
      if (allowed[k] == kHolds) give[k] = 64 * slack * graph.mobility(k);
    }
  }
  if (n < kLeastGuessed || n > kMostGuessed) {
    auto found = pivoted_impulses(graph, parting, allowed, slack, give);
    if (!found && nearest != nullptr) {
      *nearest = descending_impulses(graph, parting, allowed, slack, give);
    }
    return found;
  }
  const std::vector<char> active = likely_to_carry(graph, parting, allowed);
  std::vector<S> impulses =
      stopping_impulses(graph, parting, active, give, std::vector<S>(n, S(0)));
  LeftWrong<S> wrong = left_wrong(graph, parting, allowed, active, give, impulses);
  if (!(wrong.approach <= slack && wrong.missed <= S(kNearly) && wrong.pull <= slack)) {
    impulses = spread_impulses(graph, parting, active, give);
    wrong = left_wrong(graph, parting, allowed, active, give, impulses);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (allowed[k] == kPushes && impulses[k] < 0) impulses[k] = S(0);
  }
  if (wrong.approach <= S(kNearly) && wrong.missed <= S(kNearly)) return impulses;
  if (nearest != nullptr) *nearest = std::move(impulses);
  return std::nullopt;
}

/// The same, as nearly as there are such.
template <class S>
std::vector<S> nonnegative_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                    const std::vector<char>& allowed) {
  std::vector<S> nearest;
  auto found = least_impulses(graph, parting, allowed, &nearest);
  return found ? *std::move(found) : nearest;
}

}  // namespace carom::event
