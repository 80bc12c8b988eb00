#pragma once

#include <algorithm>

#include "solvers/event/lanes.hpp"
#include "trajectory/exit_bound.hpp"

namespace carom::event {

// Where so much sooner no push can bring a ball out, nothing more is asked: a root and a division
// would be waited for.
inline constexpr double kSooner = 1 - 0x1p-6;

/// A time before which a ball at `off` from the middle of a square of half the side `skin`, which
/// moves at v under `law`, does not leave it: little before.
template <class Law>
[[gnu::always_inline]] inline double square_exit_bound(const Law& law, TwoLanes off, TwoLanes v,
                                                       double skin) {
  const WholeTwoLanes sign = signs(v);
  const TwoLanes forward = with_signs(off, sign);
  const TwoLanes speed = with_signs(v, sign);
  const TwoLanes ahead = skin - forward;
  const TwoLanes straight = ahead / speed;
  const double wait = std::min(straight[0], straight[1]);
  if (!law.bends()) return ahead[0] > 0 && ahead[1] > 0 ? wait : 0;
  const TwoLanes back = skin + forward;
  const TwoLanes push{law.push(0, v[0]), law.push(1, v[1])};
  const double sooner = wait * kSooner;
  const TwoLanes bend = with_signs(push, signs(push)) * (wait / 2 * wait);
  const WholeTwoLanes inside = (speed * sooner + bend <= ahead) & (bend <= back);
  if ((inside[0] & inside[1]) != 0) return sooner;
  const TwoLanes along = with_signs(push, sign);
  const double fading = law.fading();
  return std::min(exit_bound<double>(ahead[0], back[0], speed[0], along[0], fading),
                  exit_bound<double>(ahead[1], back[1], speed[1], along[1], fading));
}

}  // namespace carom::event
