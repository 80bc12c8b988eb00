#pragma once

#include "numbers/double_double.hpp"
#include "numbers/monotone_root.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event {

/// A ball on its parabola as seen from a fixed ball, r + v t + g t^2 / 2, and the distance s of
/// contact. gap() is |r(t)|^2 - s^2, a quartic; approach() is half its slope, the cubic
/// r(t).v(t).
template <class S>
class Parabola {
 public:
  using W = Wide<S>;

  /// from_contact: the flight began at contact with this very ball, so the gap starts at 0
  /// whatever rounding did to r; the root that makes is divided out, and the shortest bounce keeps
  /// its digits.
  Parabola(const Vec<S>& r, const Vec<S>& v, const Vec<S>& g, const S& s, bool from_contact)
      : r_(r),
        v_(v),
        g_(g),
        gap_(from_contact ? W(S(0)) : W(r.x) * W(r.x) + W(r.y) * W(r.y) - W(s) * W(s)),
        approach_(W(r.x) * W(v.x) + W(r.y) * W(v.y)),
        linear_(W(v.x) * W(v.x) + W(v.y) * W(v.y) + (W(r.x) * W(g.x) + W(r.y) * W(g.y))),
        third_((W(v.x) * W(g.x) + W(v.y) * W(g.y)) * W(S(0.5))),
        quarter_((W(g.x) * W(g.x) + W(g.y) * W(g.y)) * W(S(0.25))),
        rough_{narrow(gap_), narrow(approach_), narrow(linear_), narrow(third_), narrow(quarter_)} {
  }

  S gap_at_start() const { return rough_.gap; }

  bool approaches_at_start() const {
    if (rough_.approach != 0) return rough_.approach < 0;
    if (rough_.linear != 0) return rough_.linear < 0;
    return rough_.third < 0;
  }

  /// The gap and its slope, right to some 100 bits of their largest terms.
  Tangent<S> gap(const S& at) const {
    const auto& t = widen(at);
    const W rest = approach_ + approach_ + t * (linear_ + t * (W(S(2)) * third_ + t * quarter_));
    return {narrow(gap_ + t * rest), 2 * approach(at)};
  }
  S approach(const S& at) const {
    const auto& t = widen(at);
    return narrow(approach_ + t * (linear_ + t * (W(S(3)) * third_ + t * (quarter_ + quarter_))));
  }

  /// The same in plain arithmetic, for the first digits of a root.
  Tangent<S> rough_gap(const S& t) const {
    return {rough_.gap + t * (2 * rough_.approach +
                              t * (rough_.linear + t * (2 * rough_.third + t * rough_.quarter))),
            2 * rough_approach(t).value};
  }
  Tangent<S> rough_approach(const S& t) const {
    return {rough_.approach + t * (rough_.linear + t * (3 * rough_.third + 2 * t * rough_.quarter)),
            rough_.linear + 6 * t * (rough_.third + t * rough_.quarter)};
  }

  /// Where approach() has its local extremes: none, or two with first < second.
  bool turning_points(S& first, S& second) const {
    // linear + 6 third t + 6 quarter t^2
    const S half_b = 3 * rough_.third;
    const S a = 6 * rough_.quarter;
    const S discriminant = sum_of_products(half_b, half_b, S(-a), rough_.linear);
    if (!(discriminant > 0)) return false;
    const S q = half_b < 0 ? S(-half_b + root(discriminant)) : S(-half_b - root(discriminant));
    const S one = q / a;
    const S other = q == 0 ? S(0) : S(rough_.linear / q);
    first = one < other ? one : other;
    second = one < other ? other : one;
    return true;
  }

  /// From here on the ball only ever recedes: 4 |v| / |g| + 4 sqrt(|r| / |g|) leaves the cube the
  /// largest term.
  S beyond() const {
    const S g = root(S(g_.x * g_.x + g_.y * g_.y));
    const S v = root(S(v_.x * v_.x + v_.y * v_.y));
    const S r = root(S(r_.x * r_.x + r_.y * r_.y));
    return 4 * (v / g + root(S(r / g)));
  }

 private:
  struct Coefficients {
    S gap;
    S approach;
    S linear;
    S third;
    S quarter;
  };

  Vec<S> r_;
  Vec<S> v_;
  Vec<S> g_;
  W gap_;
  W approach_;
  W linear_;   // of approach
  W third_;    // a third of approach's quadratic coefficient
  W quarter_;  // a half of approach's cubic coefficient: all of the gap's fourth
  Coefficients rough_;
};

/// A turning point of the gap, where approach() goes through zero between two places of opposite
/// sign.
template <class S>
S gap_extreme(const Parabola<S>& path, const S& low, const S& high, bool rising) {
  const S u = std::numeric_limits<S>::epsilon();
  const S t = monotone_root([&](const S& at) { return path.rough_approach(at); }, low, high, rising,
                            S(64 * u), S(-1));
  const S better = t - path.approach(t) / path.rough_approach(t).slope;
  return low < better && better < high ? better : t;
}

/// The gap's root between two of its turning points, where it falls from above zero to below.
template <class S>
S gap_root(const Parabola<S>& path, const S& low, const S& high) {
  const S u = std::numeric_limits<S>::epsilon();
  const S rough = monotone_root([&](const S& at) { return path.rough_gap(at); }, low, high, false,
                                root(u), S(-1));
  return monotone_root([&](const S& at) { return path.gap(at); }, low, high, false, u, rough);
}

/// When a ball under uniform acceleration g touches a fixed ball: r and v of the ball as seen
/// from it. from_contact: this flight began with an impact of the two.
///
/// Holds: overlapping or touching and approaching is now (also approaching only by its
/// acceleration: the case of rest_rules.hpp); a ball that is still inside when it turns back is
/// hit when it turns. No root is missed: the cubic r.v is monotone between the roots of its
/// derivative (a quadratic), so each of its own roots is bracketed; the quartic is monotone
/// between those, so its roots are, too; signs are taken in twice the digits, where a miss or a
/// hit by 1e-28 of the squares still tells. Symmetries to the last bit as of pair_time().
/// Error: u of the time times its condition: the root is polished with residuals in twice the
/// digits.
template <class S>
S fixed_disk_time(const Vec<S>& r, const Vec<S>& v, const Vec<S>& g, const S& s,
                  bool from_contact = false) {
  if (g.x == 0 && g.y == 0) {
    return from_contact ? never<S>() : pair_time(r, v, s);
  }
  const Parabola<S> path(r, v, g, s, from_contact);
  bool falling = path.approaches_at_start();
  if (falling && !(path.gap_at_start() > 0)) {
    return S(0);
  }
  S turns[3];
  int count = path.turning_points(turns[0], turns[1]) ? 2 : 0;
  turns[count++] = path.beyond();
  S low = 0;         // approach() is monotone from here to the next turn
  S fall_start = 0;  // and the gap falls since here
  for (int k = 0; k < count; ++k) {
    const S& high = turns[k];
    if (!(high > low)) continue;
    const bool rises_after = k == count - 1 || path.approach(high) > 0;
    if (falling && rises_after) {
      const S nearest = gap_extreme(path, low, high, true);
      if (path.gap(nearest).value < 0) {
        return path.gap(fall_start).value > 0 ? gap_root(path, fall_start, nearest) : fall_start;
      }
      falling = false;
    } else if (!falling && !rises_after) {
      fall_start = gap_extreme(path, low, high, false);
      falling = true;
    }
    low = high;
  }
  return never<S>();
}

}  // namespace carom::event
