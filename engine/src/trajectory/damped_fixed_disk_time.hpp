#pragma once

#include <utility>

#include "numbers/monotone_root.hpp"
#include "trajectory/damping.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event {

/// A ball under dv/dt = g - rate v as seen from a fixed ball it may touch at distance s.
///
/// With way = (1 - exp(-rate t)) / rate as the measure of time, gap' = 2 approach; approach', times
/// exp(-2 rate t), is bend; bend', times exp(-rate t), is a quadratic in way.  So the roots of each
/// separate those of the one before, from the quadratic up to the gap, with nothing divided by the
/// rate.  All are functions of t here, which grows with way.
template <class S>
class DampedPath {
 public:
  DampedPath(const Vec<S>& r, const Vec<S>& v, const Vec<S>& g, const S& s, const S& rate,
             bool from_contact)
      : r_(r),
        v_(v),
        g_(g),
        rate_(rate),
        start_gap_(from_contact ? S(0) : squared_gap(r, s)),
        pull_{multiply_add(S(-rate), v.x, g.x), multiply_add(S(-rate), v.y, g.y)} {}

  const S& start_gap() const { return start_gap_; }

  /// The gap; where the flight began at contact, divided by t.
  Tangent<S> gap(const S& t) const {
    const State state(*this, t);
    const S part = dot(state.mean, r_ + (r_ + state.moved));
    const S slope = 2 * dot(state.place, state.velocity);
    if (start_gap_ == 0) return {part, (slope - part) / t};
    return {multiply_add(t, part, start_gap_), slope};
  }
  /// r . dr/dt: it has the sign of the gap's slope, and one root where bend() keeps its sign.
  Tangent<S> approach(const S& t) const {
    const State state(*this, t);
    const Vec<S> acceleration = g_ - rate_ * state.velocity;
    return {dot(state.place, state.velocity),
            dot(state.velocity, state.velocity) + dot(state.place, acceleration)};
  }
  Tangent<S> bend(const S& t) const {
    const State state(*this, t);
    return {bend(state), quadratic(S(t * state.d.way))};
  }
  /// Where bend() turns, at most two times in order.
  int bend_turns(S* at) const {
    const S gg = dot(g_, g_);
    const S bb = dot(pull_, pull_);
    const S c = 2 * dot(pull_, v_) + dot(g_, v_);
    const S half_b = (gg + 2 * bb - rate_ * c) / 2;
    const S a = -2 * rate_ * bb;
    int count = 0;
    const auto take = [&](const S& way) {
      const S t = way > 0 ? time_of_way(way, rate_) : never<S>();
      if (t < never<S>()) at[count++] = t;
    };
    const S discriminant = sum_of_products(half_b, half_b, S(-a), c);
    if (!(discriminant > 0)) return 0;
    const S q = half_b < 0 ? S(-half_b + root(discriminant)) : S(-half_b - root(discriminant));
    if (a != 0) take(S(q / a));
    if (q != 0) take(S(c / q));
    if (count == 2 && at[1] < at[0]) std::swap(at[0], at[1]);
    return count;
  }
  /// A time after the last turn of bend() from which on the ball only ever recedes.
  S beyond(const S& last_turn) const {
    const S g = root(dot(g_, g_));
    S t = larger(S(2 * last_turn), S(4 * (root(dot(v_, v_)) / g + root(S(root(dot(r_, r_)) / g)))));
    while (!(bend(t).value > 0 && approach(t).value > 0)) t = t * 2;
    return t;
  }

 private:
  /// Of a time: the mean velocity since the start, and what follows from it.
  struct State {
    Damping<S> d;
    Vec<S> mean;
    Vec<S> moved;
    Vec<S> place;
    Vec<S> velocity;

    State(const DampedPath& path, const S& t)
        : d(damping(S(path.rate_ * t))),
          mean{multiply_add(S(path.g_.x * t), d.fall, S(path.v_.x * d.way)),
               multiply_add(S(path.g_.y * t), d.fall, S(path.v_.y * d.way))},
          moved(t * mean),
          place(path.r_ + moved),
          velocity{multiply_add(path.v_.x, d.remaining, S(path.g_.x * t * d.way)),
                   multiply_add(path.v_.y, d.remaining, S(path.g_.y * t * d.way))} {}
  };

  // (1 - rate way)^2 d approach / d way = |velocity|^2 + g . place
  S bend(const State& state) const {
    return dot(state.velocity, state.velocity) + dot(g_, state.place);
  }
  S quadratic(const S& way) const {
    const S c = 2 * dot(pull_, v_) + dot(g_, v_);
    return c * (1 - rate_ * way) + way * (2 * dot(pull_, pull_) * (1 - rate_ * way) + dot(g_, g_));
  }

  Vec<S> r_;
  Vec<S> v_;
  Vec<S> g_;
  S rate_;
  S start_gap_;
  Vec<S> pull_;  ///< the acceleration at the start
};

/// When a ball under gravity and drag touches a fixed ball; otherwise as fixed_disk_time().
///
/// Holds: every root of bend(), approach() and the gap is bracketed by the turns of the next; of a
/// near tangent decides the gap at its smallest, to the rounding of the squares.
template <class S>
S damped_fixed_disk_time(const Vec<S>& r, const Vec<S>& v, const Vec<S>& g, const S& s,
                         const S& rate, bool from_contact = false) {
  if (g.x == 0 && g.y == 0) {
    return from_contact ? never<S>() : time_of_way(pair_time(r, v, s), rate);
  }
  const S u = std::numeric_limits<S>::epsilon();
  const DampedPath<S> path(r, v, g, s, rate, from_contact);
  const Tangent<S> start = path.approach(S(0));
  bool falling = start.value < 0 || (start.value == 0 && start.slope < 0);
  if (falling && !(path.start_gap() > 0)) return S(0);

  // The ends of the intervals over which bend() is monotone, then those of approach().
  S turns[3];
  int count = path.bend_turns(turns);
  const S end = path.beyond(count > 0 ? turns[count - 1] : S(0));
  turns[count++] = end;
  S pieces[4];
  int many = 0;
  S low = 0;
  bool up = path.bend(S(0)).value > 0;
  for (int k = 0; k < count; ++k) {
    const bool up_then = path.bend(turns[k]).value > 0;
    if (up_then != up) {
      pieces[many++] = monotone_root([&](const S& t) { return path.bend(t); }, low, turns[k],
                                     up_then, S(64 * u), S(-1));
    }
    up = up_then;
    low = turns[k];
  }
  pieces[many++] = end;

  low = 0;           // approach() changes its sign once from here to the next piece
  S fall_start = 0;  // and the gap falls since here
  for (int k = 0; k < many; ++k) {
    const S& high = pieces[k];
    if (!(high > low)) continue;
    const bool rises_after = k == many - 1 || path.approach(high).value > 0;
    const auto turn = [&](bool rising) {
      return monotone_root([&](const S& t) { return path.approach(t); }, low, high, rising,
                           S(4 * u), S(-1));
    };
    if (falling && rises_after) {
      const S nearest = turn(true);
      if (path.gap(nearest).value < 0) {
        const bool outside =
            fall_start == 0 ? path.start_gap() > 0 : path.gap(fall_start).value > 0;
        if (!outside) return fall_start;
        return monotone_root([&](const S& t) { return path.gap(t); }, fall_start, nearest, false,
                             S(4 * u), S(-1));
      }
      falling = false;
    } else if (!falling && !rises_after) {
      fall_start = turn(false);
      falling = true;
    }
    low = high;
  }
  return never<S>();
}

}  // namespace carom::event
