#pragma once

#include "numbers/monotone_root.hpp"
#include "trajectory/damping.hpp"
#include "trajectory/wall_time.hpp"

namespace carom::event {

/// The height over a wall of a ball under dv/dt = a - rate v, and how fast it rises.
template <class S>
struct DampedFall {
  S h;
  S v;
  S a;
  S rate;

  Tangent<S> at(const S& t) const {
    const auto d = damping(S(rate * t));
    return {h + t * multiply_add(S(a * t), d.fall, S(v * d.way)),
            multiply_add(v, d.remaining, S(a * t * d.way))};
  }
  /// The same for a start at the wall, divided by t: the shortest bounce keeps its digits.
  Tangent<S> from_wall(const S& t) const {
    const auto d = damping(S(rate * t));
    return {multiply_add(S(a * t), d.fall, S(v * d.way)), (d.way - d.fall) * (a - rate * v)};
  }
  /// When its velocity is zero.
  /// REQUIRES: v and a have opposite signs.
  S turn() const {
    const S without_drag = -v / a;
    return without_drag * log_1p_over(S(rate * without_drag));
  }

  /// The root after `low`, from where on it falls; `guess` is near it.
  S root_after(const S& low, S guess) const {
    guess = larger(guess, S(2 * low));
    S high = guess;
    while (!(at(high).value < 0)) high = high * 2;
    return root_between(low, high, guess);
  }
  S root_between(const S& low, const S& high, const S& guess) const {
    return monotone_root([this](const S& t) { return at(t); }, low, high, false,
                         S(4 * std::numeric_limits<S>::epsilon()), guess);
  }
};

/// wall_time() under drag, and by the same rules: when a ball reaches a wall, all along the wall's
/// normal that points to the ball's side.
///
/// Holds: the velocity changes its sign once at most, so the roots are on both sides of that; each
/// is bracketed and found.  Without acceleration the way is straight in s, and closed.
/// Error: some u of the time, as the fall's slope amplifies them.
template <class S>
S damped_wall_time(const S& h, const S& v, const S& a, const S& rate) {
  if (a == 0) return time_of_way(wall_time(h, v), rate);
  const DampedFall<S> fall{h, v, a, rate};
  if (!(h > 0)) {
    if (v < 0 || (v == 0 && a < 0)) return S(0);
    if (a > 0) return never<S>();
    if (h == 0) {
      const S longest = 2 * v / -a;  // without drag; it rises less with it
      return monotone_root([&fall](const S& t) { return fall.from_wall(t); }, S(0), S(2 * longest),
                           false, S(4 * std::numeric_limits<S>::epsilon()), longest);
    }
    const S turn = fall.turn();
    return fall.at(turn).value > 0 ? fall.root_after(turn, S(2 * turn)) : turn;
  }
  if (v < 0 && a > 0) {
    const S turn = fall.turn();
    if (!(fall.at(turn).value < 0)) return never<S>();
    return fall.root_between(S(0), turn, wall_time(h, v, a));
  }
  if (a > 0) return never<S>();
  return fall.root_after(v > 0 ? fall.turn() : S(0), wall_time(h, v, a));
}

}  // namespace carom::event
