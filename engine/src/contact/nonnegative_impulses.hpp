#pragma once

#include <algorithm>
#include <optional>
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

/// Impulses at the `active` contacts that bring their parting speeds from `parting` to zero:
/// conjugate gradients, preconditioned by each contact's own mobility. Where more contacts hold a
/// body than it has freedoms, the equations are consistent if parting comes from a motion, and the
/// smallest solution is found; else what remains grows in the end, and the nearest is taken.
template <class S>
std::vector<S> stopping_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                 const std::vector<char>& active) {
  const std::size_t n = graph.size();
  const S u = std::numeric_limits<S>::epsilon();
  std::vector<S> impulses(n, S(0));
  for (int restart = 0; restart < 2; ++restart) {
    const std::vector<S> now = graph.response(impulses);
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
      const std::vector<S> change = graph.response(step);
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
                                   const std::vector<char>& allowed, const S& slack) {
  const std::size_t n = graph.size();
  std::vector<char> active(n, 0);
  std::vector<S> impulses(n, S(0));
  S fastest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (allowed[k] && parting[k] < 0) fastest = larger(fastest, S(-parting[k]));
  }
  for (std::size_t pass = 0; pass < 4 * n + 16; ++pass) {
    const std::vector<S> change = graph.response(impulses);
    bool enters = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (!allowed[k] || active[k] || !(parting[k] + change[k] < -slack * fastest)) continue;
      active[k] = 1;
      enters = true;
    }
    if (!enters) break;
    for (std::size_t leaving = 0; leaving < n; ++leaving) {
      const std::vector<S> goal = stopping_impulses(graph, parting, active);
      S part = 1;
      for (std::size_t k = 0; k < n; ++k) {
        if (!active[k] || !(goal[k] < 0)) continue;
        const S until = impulses[k] / (impulses[k] - goal[k]);
        if (until < part) part = until;
      }
      for (std::size_t k = 0; k < n; ++k) {
        if (!active[k]) continue;
        const bool leaves = goal[k] < 0 && !(impulses[k] / (impulses[k] - goal[k]) > part);
        impulses[k] = leaves ? S(0) : larger(S(impulses[k] + part * (goal[k] - impulses[k])), S(0));
        if (leaves) active[k] = 0;
      }
      if (!(part < 1)) break;
    }
  }
  return impulses;
}

/// The solution of the linear complementarity problem 0 <= impulse | parting + response >= 0, where
/// block pivoting finds it: all wrong signs are changed at once, so no contact is favoured. Nothing
/// where that goes round in circles, as it does where there is none.
/// Source: Portugal, Judice, Vicente, Math. Comput. 63 (1994) 625.
template <class S>
std::optional<std::vector<S>> pivoted_impulses(const ContactGraph<S>& graph,
                                               const std::vector<S>& parting,
                                               const std::vector<char>& allowed, const S& slack) {
  const std::size_t n = graph.size();
  std::vector<char> active(n, 0);
  S largest_parting = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!allowed[k]) continue;
    active[k] = parting[k] < 0 ? 1 : 0;
    if (parting[k] < 0) largest_parting = larger(largest_parting, S(-parting[k]));
  }
  std::vector<std::vector<char>> tried;
  const std::size_t most = n < 16 ? 3 * n + 16 : 64;  // most sets need a few
  while (tried.size() < most) {
    // One set leads to the next, whatever came before.
    if (std::find(tried.begin(), tried.end(), active) != tried.end()) return std::nullopt;
    tried.push_back(active);
    std::vector<S> impulses = stopping_impulses(graph, parting, active);
    const std::vector<S> change = graph.response(impulses);
    S largest = 0;
    for (const S& impulse : impulses) largest = larger(largest, absolute(impulse));
    bool changed = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (active[k] && impulses[k] < -slack * largest) {
        active[k] = 0;
        changed = true;
      } else if (!active[k] && allowed[k] && parting[k] + change[k] < -slack * largest_parting) {
        active[k] = 1;
        changed = true;
      }
    }
    if (changed) continue;
    for (S& impulse : impulses) {
      if (impulse < 0) impulse = S(0);
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

/// The least impulses >= 0 at the `allowed` contacts after which none of them approaches, as nearly
/// as there are such.
template <class S>
std::vector<S> nonnegative_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                    const std::vector<char>& allowed) {
  const S slack = slack_of_impulses<S>();
  const std::optional<std::vector<S>> found = pivoted_impulses(graph, parting, allowed, slack);
  return found ? *found : descending_impulses(graph, parting, allowed, slack);
}

}  // namespace carom::event
