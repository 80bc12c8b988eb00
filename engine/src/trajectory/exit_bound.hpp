#pragma once

#include "numbers/scalar.hpp"

namespace carom::event {

/// The uncommon part of exit_bound(): at the end, at rest, or where the ball may turn back; `least`
/// is what is left of the push.
template <class S>
[[gnu::noinline]] S exit_bound_at_length(const S& ahead, const S& back, const S& speed,
                                         const S& push, const S& least, const S& fading) {
  if (!(ahead > 0)) return S(0);
  const S square = speed * speed + 2 * least * ahead;
  if (!(push < 0)) {
    return speed == 0 && push == 0 ? never<S>() : S(2 * ahead / (speed + root(square)));
  }
  const S longest = 2 * ahead / speed;
  S front = longest;
  if (square > 0) {
    front = 2 * ahead / (speed + root(square));
  } else if (fading == 0) {
    front = never<S>();
  }
  // Drag alone only ever stops it.
  if (push == -(fading * speed)) return fading * longest > 4 ? never<S>() : front;
  const S turned =
      (speed + root(S(speed * speed - 2 * push * larger(back, S(0))))) / absolute(push);
  return turned < front ? turned : front;
}

/// A time before which a ball in an interval does not leave it: `ahead` of it is the end towards
/// which it moves at `speed`, or is pushed from rest, at its `back` the other end.
///
/// `push` is its acceleration ahead, which fades at the rate `fading` and keeps its sign: where it
/// goes is between where it would go without it, and with all of it all the time.
/// Holds: little before the ball leaves, where the push changes its way little.
template <class S>
S exit_bound(const S& ahead, const S& back, const S& speed, const S& push, const S& fading) {
  if (speed == 0 && push < 0) return exit_bound<S>(back, ahead, speed, -push, fading);
  S least = push;
  if (fading != 0 && push < 0) {
    // It is slowed down by at least what is left of the push after twice the straight way's time;
    // so long it flies to the end, if it does not turn before.
    least = larger(S(1 - 2 * fading * ahead / speed), S(0)) * push;
  }
  const S square = speed * speed + 2 * least * ahead;
  const S front = 2 * ahead / (speed + root(larger(square, S(0))));
  if (ahead > 0 && square > 0 && !(-push * front > speed)) return front;
  return exit_bound_at_length(ahead, back, speed, push, least, fading);
}

}  // namespace carom::event
