#include "solvers/event/suits_domains.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "effects/domains_suit.hpp"

namespace carom::event {
namespace {

constexpr double kLeastPeriod = 8;  // radii

}  // namespace

bool suits_domains(const Effects& effects, const Domain& domain, const std::vector<Ball>& balls,
                   bool rests, const Sharing& sharing, std::size_t workers) {
  const std::size_t least = workers > 1 ? workers * sharing.balls_of_worker : 0;
  if (balls.size() < std::max(least, sharing.least_balls)) return false;
  const std::array<bool, 2> periodic{domain.period[0] > 0, domain.period[1] > 0};
  if (!domains_suit(effects, periodic, rests)) return false;
  const double least_period = std::min(periodic[0] ? domain.period[0] : HUGE_VAL,
                                       periodic[1] ? domain.period[1] : HUGE_VAL);
  return std::none_of(balls.begin(), balls.end(),
                      [&](const Ball& ball) { return least_period < kLeastPeriod * ball.radius; });
}

}  // namespace carom::event
