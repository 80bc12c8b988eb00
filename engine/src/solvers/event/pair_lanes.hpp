#pragma once

#include <limits>

#include "solvers/event/lanes.hpp"

namespace carom::event {

/// a b + c d as sum_of_products() has it, lane by lane.
[[gnu::always_inline]] inline Lanes sum_of_products(Lanes a, Lanes b, Lanes c, Lanes d) {
  const Lanes p = a * b;
  const Lanes q = c * d;
  return (p + q) + (fused(a, b, -p) + fused(c, d, -q));
}

/// pair_time() of trajectory/pair_time.hpp for four pairs side by side, with the same bits:
/// seconds until disks at (dx, dy) from each other and moving at (vx, vy) to each other come within
/// `reach`, infinite where they never do.  A lane that is not wanted may hold anything finite.
[[gnu::always_inline]] inline Lanes pair_times(Lanes dx, Lanes dy, Lanes vx, Lanes vy,
                                               Lanes reach) {
  const Lanes zero{};
  const Lanes never = all(std::numeric_limits<double>::infinity());
  const auto two_sum_lost = [](Lanes a, Lanes b, Lanes sum) {
    const Lanes b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part);
  };

  const Lanes p = dx * vx;
  const Lanes q = dy * vy;
  const Lanes pq = p + q;
  const Lanes b = pq + (two_sum_lost(p, q, pq) + (fused(dx, vx, -p) + fused(dy, vy, -q)));

  const Lanes xx = dx * dx;
  const Lanes yy = dy * dy;
  const Lanes ss = reach * reach;
  const Lanes squares_lost = fused(dx, dx, -xx) + fused(dy, dy, -yy);
  const Lanes s_lost = fused(reach, reach, -ss);
  const Lanes sum = xx + yy;
  const Lanes difference = sum - ss;
  const Lanes c = difference + ((two_sum_lost(sum, -ss, difference) + two_sum_lost(xx, yy, sum)) +
                                (squares_lost - s_lost));

  const Lanes l = sum_of_products(dx, vy, -dy, vx);
  const Lanes vv = vx * vx + vy * vy;
  const Lanes ll = l * l;
  const Lanes discriminant = fused(vv, ss, -ll) + fused(-l, l, ll);

  const Lanes speed = square_root(discriminant > zero ? discriminant : zero);
  const Lanes time = c / (speed - b);
  const Lanes ahead = discriminant > zero ? time : never;
  const Lanes approaching = c > zero ? ahead : zero;
  return b < zero ? approaching : never;
}

}  // namespace carom::event
