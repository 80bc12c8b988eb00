#pragma once

#include <cstddef>

#include "trajectory/damped_fixed_disk_time.hpp"
#include "trajectory/damped_wall_time.hpp"
#include "trajectory/damping.hpp"
#include "trajectory/flight.hpp"

namespace carom::event {

/// dv/dt = gravity - rate v, the same for every ball; gravity may be zero, and so may the rate.
template <class S>
struct DampedLaw {
  static constexpr bool kStretches = true;
  Vec<S> gravity;
  S rate;

  static constexpr bool bends() { return true; }
  Vec<S> displacement(const Flight<S>& f, const S& elapsed) const {
    return displacement(f, elapsed, damping(S(rate * elapsed)));
  }
  Vec<S> velocity(const Flight<S>& f, const S& elapsed) const {
    return velocity(f, elapsed, damping(S(rate * elapsed)));
  }
  Flight<S> after(const Flight<S>& f, const S& elapsed) const {
    const auto d = damping(S(rate * elapsed));
    return {f.position + displacement(f, elapsed, d), velocity(f, elapsed, d)};
  }
  /// The later starter as seen from the earlier one.
  Relative<S> relative(const Flight<S>& earlier, const S& elapsed, const Flight<S>& later) const {
    const auto d = damping(S(rate * elapsed));
    return {(later.position - earlier.position) - displacement(earlier, elapsed, d),
            later.velocity - velocity(earlier, elapsed, d)};
  }
  S when(const S& straight) const { return time_of_way(straight, rate); }
  S wall_wait(std::size_t axis, int side, const S& h, const S& v) const {
    return damped_wall_time(h, v, pull(axis, side), rate);
  }
  S wall_arrival(std::size_t axis, int side, const S& h, const S& v, const S& elapsed) const {
    if (!(h > 0) && v < 0) return v;
    const S arrival = DampedFall<S>{h, v, pull(axis, side), rate}.at(elapsed).slope;
    return arrival < 0 ? arrival : S(0);
  }
  S fixed_disk_wait(const Vec<S>& r, const Vec<S>& v, const S& s, bool from_contact) const {
    return damped_fixed_disk_time(r, v, gravity, s, rate, from_contact);
  }
  const S& pull(std::size_t axis) const { return axis == 0 ? gravity.x : gravity.y; }
  const Vec<S>& pull() const { return gravity; }
  DampedLaw under(const Vec<S>& pull) const { return {pull, rate}; }
  DampedLaw rolling() const { return {rolling_part(gravity), S(2 * rate / 3)}; }
  S push(std::size_t axis, const S& v) const { return multiply_add(S(-rate), v, pull(axis)); }
  const S& fading() const { return rate; }

 private:
  Vec<S> displacement(const Flight<S>& f, const S& elapsed, const Damping<S>& d) const {
    return {elapsed * multiply_add(S(gravity.x * elapsed), d.fall, S(f.velocity.x * d.way)),
            elapsed * multiply_add(S(gravity.y * elapsed), d.fall, S(f.velocity.y * d.way))};
  }
  Vec<S> velocity(const Flight<S>& f, const S& elapsed, const Damping<S>& d) const {
    return {multiply_add(f.velocity.x, d.remaining, S(gravity.x * elapsed * d.way)),
            multiply_add(f.velocity.y, d.remaining, S(gravity.y * elapsed * d.way))};
  }
  S pull(std::size_t axis, int side) const { return side * pull(axis); }
};

template <class S>
Flight<S> after(const DampedLaw<S>& law, const Flight<S>& f, const S& elapsed) {
  return law.after(f, elapsed);
}

/// From here on they move straight relative to each other in s = (1 - exp(-rate t)) / rate.
template <class S>
Relative<S> relative_at_later_start(const DampedLaw<S>& law, const Flight<S>& earlier,
                                    const S& elapsed, const Flight<S>& later) {
  return law.relative(earlier, elapsed, later);
}

}  // namespace carom::event
