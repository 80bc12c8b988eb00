#pragma once

#include <algorithm>
#include <cmath>

#include "contact/event_pair_time.hpp"
#include "contact/event_peg_time.hpp"
#include "contact/event_rest.hpp"
#include "solvers/event/motion.hpp"

namespace carom::event {

template <class P>
void Motion<P>::add_carried_kinds() requires(P::kRests) {
  const Vec<S>& g = law_.pull();
  pull_ = root(S(g.x * g.x + g.y * g.y));
  for (unsigned axes = 1; axes <= kAsleep; ++axes) {
    for (std::size_t k = 0; k < plain_kinds_; ++k) {
      Kind kind = rules_.kinds[k];
      kind.carried = axes;
      rules_.kinds.push_back(kind);
    }
  }
}

template <class P>
void Motion<P>::lean_on_walls(Disk& disk) const requires(P::kRests) {
  const Vec<S>& g = law_.pull();
  unsigned axes = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const S& a = axis == 0 ? g.x : g.y;
    if (a == 0 || !room_.solid(axis)) continue;
    const S& radius = kind(disk).radius;
    const S stop = a < 0 ? room_.lowest(axis, radius) : room_.highest(axis, radius);
    const S& x = axis == 0 ? disk.x : disk.y;
    S& v = axis == 0 ? disk.vx : disk.vy;
    const S away = a < 0 ? v : S(-v);
    if (x != stop || away < 0) continue;
    if (away > 0 &&
        !bounces_out(away, absolute(a), S(rules_.wall_restitution), rules_.scale.resolution())) {
      continue;
    }
    v = 0;
    axes |= axis == 0 ? 1U : 2U;
  }
  set_carried(disk, axes);
}

template <class P>
bool Motion<P>::lean_on_peg(Disk& disk, const Disk& peg) const requires(P::kRests) {
  const Vec<S> r = way({peg.x, peg.y}, {disk.x, disk.y});
  const Vec<S> v{disk.vx, disk.vy};
  const Vec<S>& g = law_.pull();
  if (!straight_up(r, v, g)) return false;
  const S away = root(S(v.x * v.x + v.y * v.y));
  if (away > 0 && !bounces_out(away, pull_, S(rules_.restitution), rules_.scale.resolution())) {
    return false;
  }
  disk.vx = 0;
  disk.vy = 0;
  set_carried(disk, kAsleep);
  return true;
}

template <class P>
bool Motion<P>::stays_together(const Vec<S>& r, const Vec<S>& v, const S& reach) const
    requires(P::kRests) {
  const S distance = root(S(r.x * r.x + r.y * r.y));
  return absolute(sharp_dot(r, v)) / distance * rules_.scale.resolution() <=
         reach * std::ldexp(1.0, kTogether);
}

template <class P>
bool Motion<P>::collapses(const Disk& a, const Disk& b, At now) const requires(P::kRests) {
  const S longest = rules_.scale.resolution() * kCollapse;
  return rules_.restitution < 1 && rules_.scale.seconds(now - a.start) <= longest &&
         rules_.scale.seconds(now - b.start) <= longest;
}

template <class P>
auto Motion<P>::hop_speed(const S& reach) const -> S requires(P::kRests) {
  return kHop * root(S(pull_ * reach));
}

template <class P>
auto Motion<P>::fastest_hop(const Disk& a, const Disk& b, At now) const -> S requires(P::kRests) {
  if (!(rules_.restitution < 1)) return -1;
  const S hop = hop_speed(kind(a).radius + kind(b).radius);
  S age = 0;
  if (!fixed(a)) age = rules_.scale.seconds(now - a.start);
  if (!fixed(b)) age = larger(age, S(rules_.scale.seconds(now - b.start)));
  const S gained = age * pull_;
  if (gained <= kShock * hop) return never<S>();
  return gained <= 2 * kSlow * hop ? S(kSlow * hop) : S(-1);
}

template <class P>
void Motion<P>::hop(const Disk& a, const Disk& b, const Vec<S>& r, const S& fastest,
                    Velocities<S>& after) const requires(P::kRests) {
  const Vec<S> v{b.vx - a.vx, b.vy - a.vy};
  const S distance = root(S(r.x * r.x + r.y * r.y));
  const S speed = -sharp_dot(r, v) / distance;
  const Kind& ka = kind(a);
  const Kind& kb = kind(b);
  if (speed > fastest) return;
  const S least = hop_speed(ka.radius + kb.radius);
  // What comes straight down on a fixed ball is a ball on a floor.
  if ((ka.fixed() || kb.fixed()) && straight_up(ka.fixed() ? r : -r, v, law_.pull())) return;
  const S share = (speed + larger(speed, least)) / (distance * (ka.inverse_mass + kb.inverse_mass));
  after.a = less({a.vx, a.vy}, S(share * ka.inverse_mass), r);
  after.b = less({b.vx, b.vy}, S(-share * kb.inverse_mass), r);
}

// One of the two may be carried: then they accelerate as seen from each other.
template <class P>
auto Motion<P>::meeting_wait(const Disk& earlier, const Disk& later, const S& reach,
                             bool from_contact, At until) const -> S requires(P::kRests) {
  const auto& law = law_of(earlier);
  const S elapsed = rules_.scale.seconds(later.start - earlier.start);
  Relative<S> relative = relative_at_later_start(law, flight(earlier), elapsed, flight(later));
  const std::array<S, 2>& periods = room_.periods();
  relative.r.x = nearest(relative.r.x, periods[0], S(periods[0] / 2));
  relative.r.y = nearest(relative.r.y, periods[1], S(periods[1] / 2));
  const Vec<S> pull = law_of(later).pull() - law.pull();
  if (until != P::Clock::never()) {
    // Too far to meet before: most pairs, and this is quick.
    const S wait = rules_.scale.seconds(until - later.start);
    const S speed = absolute(relative.v.x) + absolute(relative.v.y);
    const S far = (reach + (speed + pull_ * wait / 2) * wait) * 1.0625;
    if (relative.r.x * relative.r.x + relative.r.y * relative.r.y > far * far) return never<S>();
  }
  if (pull.x == 0 && pull.y == 0) return pair_time(relative.r, relative.v, reach);
  return peg_time(relative.r, relative.v, pull, reach, from_contact);
}

}  // namespace carom::event
