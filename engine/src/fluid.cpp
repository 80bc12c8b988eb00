#include "carom/fluid.hpp"

#include "state/totals.hpp"

namespace carom {

Fluid FluidMeter::measure(double time, const std::vector<Ball>& balls,
                          const std::vector<Impact>& impacts) {
  Fluid fluid;
  double moving = 0;
  double mass = 0;
  Vec2 momentum{0, 0};
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    ++moving;
    mass += ball.mass;
    momentum += ball.mass * ball.velocity;
  }
  const Vec2 mean = mass > 0 ? Vec2(momentum / mass) : Vec2{0, 0};
  double thermal = 0;
  for (const Ball& ball : balls) {
    if (ball.fixed) continue;
    fluid.kinetic += kinetic_energy(ball, spins_);
    thermal += ball.mass * (ball.velocity - mean).squaredNorm() / 2;
  }
  const double free = periodic_ ? moving - 1 : moving;
  if (free > 0) fluid.temperature = thermal / free;

  double virial = 0;
  for (const Impact& impact : impacts) {
    if (impact.b != Impact::kNoBall) virial += impact.distance * impact.impulse;
  }
  const double span = since_ ? time - *since_ : 0;
  if (span > 0 && fluid.temperature) {
    const double ideal = moving * *fluid.temperature;
    fluid.pressure = (ideal + virial / (2 * span)) / area_;
    if (ideal > 0) fluid.Z = *fluid.pressure * area_ / ideal;
  }
  since_ = time;
  return fluid;
}

}  // namespace carom
