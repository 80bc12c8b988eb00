#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "contact/event_contact_graph.hpp"
#include "contact/event_orderless_sum.hpp"

namespace carom::event {

/// The impulses >= 0 of contacts that give way a little: the least of
/// impulse . (response / 2 + give impulse / 2 + parting) over all that do not pull, where
/// `response` is how fast the impulses part the contacts.  However many contacts hold a ball,
/// there is exactly one answer, and it is found without trying which contacts push.
/// Holds: numbering, sides, mirrors and swapped axes leave the bits as they are.
/// Source: Dostal, Schoeberl, Comput. Optim. Appl. 30 (2005) 23: conjugate gradients on the
/// contacts that push, with steps onto and off the bounds (modified proportioning).
template <class S>
class CarryingForces {
 public:
  using Column = std::vector<S>;

  /// `give`: how much a contact gives way to an impulse, as a part of how its bodies do.
  CarryingForces(std::span<const Body<S>> bodies, std::span<const Contact<S>> contacts,
                 const S& give)
      : bodies_(bodies), contacts_(contacts), at_body_(bodies.size(), 0) {
    for (const Contact<S>& c : contacts) {
      const S length = root(S(c.r.x * c.r.x + c.r.y * c.r.y));
      normals_.push_back({c.r.x / length, c.r.y / length});
      ++at_body_[index(c.a)];
      if (c.b != kWall) ++at_body_[index(c.b)];
    }
    S most = 0;
    for (const Contact<S>& c : contacts) {
      const S in_a = mobility(c.a);
      const S in_b = mobility(c.b);
      give_.push_back(give * (in_a + in_b));
      most = larger(most, S(in_a * at(c.a) + in_b * at(c.b) + give_.back()));
      most_at_body_ = std::max({most_at_body_, at(c.a), at(c.b)});
    }
    step_ = most > 0 ? S(1 / most) : S(0);
  }

  [[nodiscard]] const std::vector<Vec<S>>& normals() const { return normals_; }

  /// How fast the bodies of a contact part when they move as `motion` says.
  S parting(std::size_t k, const std::vector<Vec<S>>& motion) const {
    const Contact<S>& c = contacts_[k];
    const Vec<S>& a = motion[index(c.a)];
    const Vec<S> v = c.b == kWall ? -a : motion[index(c.b)] - a;
    return normals_[k].x * v.x + normals_[k].y * v.y;
  }

  /// What impulses change the velocities of the bodies by.
  std::vector<Vec<S>> changes(const Column& impulses) const {
    std::vector<Vec<S>> result(bodies_.size(), {S(0), S(0)});
    S largest = 0;
    for (const S& impulse : impulses) largest = larger(largest, absolute(impulse));
    const OrderlessSum<S> sum(S(largest * most_at_body_));
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      if (impulses[k] == 0) continue;
      const Vec<S> p{sum.rounded(impulses[k] * normals_[k].x),
                     sum.rounded(impulses[k] * normals_[k].y)};
      Vec<S>& a = result[index(contacts_[k].a)];
      a = a - p;
      if (contacts_[k].b == kWall) continue;
      Vec<S>& b = result[index(contacts_[k].b)];
      b = b + p;
    }
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      result[k] = bodies_[k].inverse_mass * result[k];
    }
    return result;
  }

  /// Starts from `impulses`, which are those of a similar question or all 0; what remains of the
  /// gradient is at most `goal`.
  void solve(const Column& parting, const S& goal, Column& impulses) const {
    const std::size_t n = contacts_.size();
    Column slope = slopes(parting, impulses);
    Column way = inside(slope, impulses);
    Column onto(n);
    for (std::size_t round = 0; round < 40 * n + 100; ++round) {
      const Column free = inside(slope, impulses);
      S remains = 0;
      for (std::size_t k = 0; k < n; ++k) {
        onto[k] = impulses[k] == 0 && slope[k] < 0 ? slope[k] : S(0);
        remains = larger(remains, absolute(S(free[k] + onto[k])));
      }
      if (!(remains > goal)) return;
      if (product(onto, onto) > bounded(free, impulses)) {
        const Column change = times(onto);
        const S length = product(slope, onto) / product(onto, change);
        move(impulses, S(-length), onto);
        move(slope, S(-length), change);
        way = inside(slope, impulses);
      } else {
        descend(parting, slope, way, impulses);
      }
    }
  }

 private:
  static std::size_t index(int body) { return static_cast<std::size_t>(body); }
  S mobility(int body) const { return body == kWall ? S(0) : bodies_[index(body)].inverse_mass; }
  int at(int body) const { return body == kWall ? 0 : at_body_[index(body)]; }

  static S product(const Column& a, const Column& b) {
    S most_a = 0;
    S most_b = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      most_a = larger(most_a, absolute(a[k]));
      most_b = larger(most_b, absolute(b[k]));
    }
    const OrderlessSum<S> sum(S(most_a * most_b * static_cast<double>(a.size())));
    S result = 0;
    for (std::size_t k = 0; k < a.size(); ++k) result = result + sum.rounded(a[k] * b[k]);
    return result;
  }

  static void move(Column& a, const S& times, const Column& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = a[k] + times * b[k];
  }

  static Column inside(const Column& slope, const Column& impulses) {
    Column result(slope.size());
    for (std::size_t k = 0; k < slope.size(); ++k) {
      result[k] = impulses[k] > 0 ? slope[k] : S(0);
    }
    return result;
  }

  /// free . free, of which what would lead beyond the bounds counts only up to them.
  S bounded(const Column& free, const Column& impulses) const {
    Column limited(free.size());
    for (std::size_t k = 0; k < free.size(); ++k) {
      const S most = impulses[k] / step_;
      limited[k] = free[k] < most ? free[k] : most;
    }
    return product(free, limited);
  }

  Column times(const Column& impulses) const {
    const std::vector<Vec<S>> motion = changes(impulses);
    Column result(impulses.size());
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] = parting(k, motion) + give_[k] * impulses[k];
    }
    return result;
  }

  Column slopes(const Column& parting, const Column& impulses) const {
    Column result = times(impulses);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = result[k] + parting[k];
    return result;
  }

  void descend(const Column& parting, Column& slope, Column& way, Column& impulses) const {
    const Column change = times(way);
    const S curvature = product(way, change);
    const S length = product(slope, way) / curvature;
    S room = never<S>();
    for (std::size_t k = 0; k < way.size(); ++k) {
      if (!(way[k] > 0)) continue;
      const S until = impulses[k] / way[k];
      if (until < room) room = until;
    }
    if (length < room) {
      move(impulses, S(-length), way);
      move(slope, S(-length), change);
      const Column free = inside(slope, impulses);
      const S turn = product(free, change) / curvature;
      for (std::size_t k = 0; k < way.size(); ++k) way[k] = free[k] - turn * way[k];
      return;
    }
    // to the bound, and a step straight down along it
    move(impulses, S(-room), way);
    move(slope, S(-room), change);
    for (std::size_t k = 0; k < impulses.size(); ++k) {
      if (impulses[k] > 0) impulses[k] = impulses[k] - step_ * slope[k];
      if (!(impulses[k] > 0)) impulses[k] = S(0);
    }
    slope = slopes(parting, impulses);
    way = inside(slope, impulses);
  }

  std::span<const Body<S>> bodies_;
  std::span<const Contact<S>> contacts_;
  std::vector<Vec<S>> normals_;
  std::vector<int> at_body_;
  int most_at_body_ = 0;
  Column give_;
  S step_;
};

}  // namespace carom::event
