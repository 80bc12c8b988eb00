#pragma once

#include <cstddef>

#include "numbers/scalar.hpp"
#include "trajectory/fixed_disk_time.hpp"
#include "trajectory/pair_time.hpp"
#include "trajectory/wall_time.hpp"

namespace carom::event {

/// Where a ball was and how fast it left when its last impact was over: between impacts this is
/// all there is to know of it. The time of the start is kept by the caller; only elapsed times
/// come in here.
template <class S>
struct Flight {
  Vec<S> position;
  Vec<S> velocity;
};

// A law of flight gives, besides where a flight goes: when() turns the time of pair_time() into
// time; wall_wait(), when a ball meets a wall whose normal points along `side` (1 or -1) of an
// axis, h and v along that normal, and wall_arrival(), its normal velocity then; fixed_disk_wait(),
// when it meets a fixed ball, where flights bend past it; pull(), what pulls it along an axis;
// push(), how it accelerates there at some velocity, which then fades at the rate fading() and
// keeps its sign; under(), the same law with another pull; rolling(), of a disk that rolls along a
// wall; bends(), whether flights are anything but straight. kStretches: when() does something, and
// gives no less than it is given.

/// The law of a ball that something carries along some axes: 1 for x, 2 for y.
template <class Law>
Law supported(const Law& law, unsigned axes) {
  auto pull = law.pull();
  if ((axes & 1U) != 0) pull.x = 0;
  if ((axes & 2U) != 0) pull.y = 0;
  return law.under(pull);
}

/// What is left of a pull along the wall that a uniform disk rolls on: its spin takes a third.
template <class S>
Vec<S> rolling_part(const Vec<S>& pull) {
  return {2 * pull.x / 3, 2 * pull.y / 3};
}

/// Uniform motion.
template <class S>
struct StraightLaw {
  static constexpr bool bends() { return false; }
  static constexpr bool kStretches = false;

  Vec<S> displacement(const Flight<S>& f, const S& elapsed) const {
    return {f.velocity.x * elapsed, f.velocity.y * elapsed};
  }
  Vec<S> velocity(const Flight<S>& f, const S&) const { return f.velocity; }
  const S& when(const S& straight) const { return straight; }
  S wall_wait(std::size_t, int, const S& h, const S& v) const { return wall_time(h, v); }
  S wall_arrival(std::size_t, int, const S&, const S& v, const S&) const { return v; }
  S pull(std::size_t) const { return S(0); }
  S push(std::size_t, const S&) const { return S(0); }
  S fading() const { return S(0); }
  Vec<S> pull() const { return {S(0), S(0)}; }
  StraightLaw under(const Vec<S>&) const { return {}; }
};

/// Uniform acceleration, the same for every ball.
template <class S>
struct BallisticLaw {
  static constexpr bool kStretches = false;
  Vec<S> gravity;

  [[nodiscard]] bool bends() const { return gravity.x != 0 || gravity.y != 0; }
  Vec<S> displacement(const Flight<S>& f, const S& elapsed) const {
    const S half = elapsed / 2;
    return {multiply_add(gravity.x, half, f.velocity.x) * elapsed,
            multiply_add(gravity.y, half, f.velocity.y) * elapsed};
  }
  Vec<S> velocity(const Flight<S>& f, const S& elapsed) const {
    return f.velocity + elapsed * gravity;
  }
  const S& when(const S& straight) const { return straight; }
  S wall_wait(std::size_t axis, int side, const S& h, const S& v) const {
    return wall_time(h, v, pull(axis, side));
  }
  S wall_arrival(std::size_t axis, int side, const S& h, const S& v, const S&) const {
    return wall_arrival_velocity(h, v, pull(axis, side));
  }
  S fixed_disk_wait(const Vec<S>& r, const Vec<S>& v, const S& s, bool from_contact) const {
    return fixed_disk_time(r, v, gravity, s, from_contact);
  }
  const S& pull(std::size_t axis) const { return axis == 0 ? gravity.x : gravity.y; }
  const S& push(std::size_t axis, const S&) const { return pull(axis); }
  S fading() const { return S(0); }
  const Vec<S>& pull() const { return gravity; }
  BallisticLaw under(const Vec<S>& pull) const { return {pull}; }
  BallisticLaw rolling() const { return {rolling_part(gravity)}; }

 private:
  S pull(std::size_t axis, int side) const { return side * pull(axis); }
};

/// The flight as it is `elapsed` after its start; after 0 it is itself to the last bit.
template <class S, class Law>
[[gnu::always_inline]] inline Flight<S> after(const Law& law, const Flight<S>& f,
                                              const S& elapsed) {
  return {f.position + law.displacement(f, elapsed), law.velocity(f, elapsed)};
}

/// Position and velocity of one ball as seen from another at one instant.
template <class S>
struct Relative {
  Vec<S> r;
  Vec<S> v;
};

/// The later starter as seen from the earlier one at the moment of the later start, `elapsed` >=
/// 0 after the earlier start. Whichever of two equal starters is called earlier, the result is
/// the same but for its sign, to the last bit, and every function of a pair here is even in (r,
/// v): so nothing depends on the order of the pair. Positions are subtracted before the
/// displacement is, which is exact for balls near each other.
///
/// From here on two balls under the same law move straight relative to each other: under uniform
/// acceleration in the time, under drag in the s of damped_law.hpp, which when() turns into
/// time.
template <class S>
Relative<S> relative_at_later_start(const BallisticLaw<S>& law, const Flight<S>& earlier,
                                    const S& elapsed, const Flight<S>& later) {
  const S half = elapsed / 2;
  const Vec<S> mean{multiply_add(law.gravity.x, half, earlier.velocity.x),
                    multiply_add(law.gravity.y, half, earlier.velocity.y)};
  return {{multiply_add(S(-mean.x), elapsed, later.position.x - earlier.position.x),
           multiply_add(S(-mean.y), elapsed, later.position.y - earlier.position.y)},
          {multiply_add(S(-law.gravity.x), elapsed, later.velocity.x - earlier.velocity.x),
           multiply_add(S(-law.gravity.y), elapsed, later.velocity.y - earlier.velocity.y)}};
}

/// The same in free flight.
template <class S>
Relative<S> relative_at_later_start(const StraightLaw<S>&, const Flight<S>& earlier,
                                    const S& elapsed, const Flight<S>& later) {
  return {{multiply_add(S(-earlier.velocity.x), elapsed, later.position.x - earlier.position.x),
           multiply_add(S(-earlier.velocity.y), elapsed, later.position.y - earlier.position.y)},
          later.velocity - earlier.velocity};
}

}  // namespace carom::event
