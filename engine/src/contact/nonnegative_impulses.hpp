#pragma once

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

/// Impulses at the `active` contacts that bring their parting speeds from `parting` to zero:
/// conjugate gradients, preconditioned by each contact's own mobility. Where more contacts hold a
/// body than it has freedoms, the equations are consistent all the same (parting comes from a
/// motion) and the smallest solution is found.
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
    }
  }
  return impulses;
}

/// The least impulses >= 0 at the `allowed` contacts after which none of them approaches: the
/// solution of the linear complementarity problem 0 <= impulse | parting + response >= 0. All
/// wrong signs are changed at once, so no contact is favoured; should that not end (it may go
/// round in circles), what is negative is left out, and the remaining approach shows in the
/// parting speeds.
/// Source: block principal pivoting, Portugal, Judice, Vicente, Math. Comput. 63
/// (1994) 625.
template <class S>
std::vector<S> nonnegative_impulses(const ContactGraph<S>& graph, const std::vector<S>& parting,
                                    const std::vector<char>& allowed) {
  const std::size_t n = graph.size();
  std::vector<char> active(n, 0);
  S largest_parting = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!allowed[k]) continue;
    active[k] = parting[k] < 0 ? 1 : 0;
    if (parting[k] < 0) largest_parting = larger(largest_parting, S(-parting[k]));
  }
  const S slack = root(std::numeric_limits<S>::epsilon()) / 16384;  // 2^-40 in double
  std::vector<S> impulses;
  for (std::size_t round = 0; round < 3 * n + 16; ++round) {
    impulses = stopping_impulses(graph, parting, active);
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
    if (!changed) break;
  }
  for (S& impulse : impulses) {
    if (impulse < 0) impulse = S(0);
  }
  return impulses;
}

}  // namespace carom::event
