#include "effects/energy.hpp"

#include "effects/attraction.hpp"

namespace carom::effects {

double energy(const Balls& balls, const Effects& effects, const Domain& domain,
              const Turns& turns) {
  const Vec2 gravity = effects.gravity ? effects.gravity->acceleration : Vec2{0, 0};
  const Vec2 periods{domain.period[0], domain.period[1]};
  double sum = kinetic_energy(balls) + potential_energy(balls, gravity, periods, turns);
  if (effects.friction) sum += spin_energy(balls);
  if (effects.attraction) sum += attraction_energy(balls, domain, *effects.attraction);
  return sum;
}

}  // namespace carom::effects
