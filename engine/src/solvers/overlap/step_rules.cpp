#include "solvers/overlap/step_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "effects/drag.hpp"
#include "effects/gravity.hpp"

namespace carom::overlap {

StepRules::StepRules(const Effects& effects, const Balls& balls, double length)
    : step(length),
      drag_rate(effects.drag ? effects.drag->rate : 0),
      smallest_radius(std::numeric_limits<double>::infinity()),
      collides(effects.collisions && effects.collisions->on),
      contacts_last(contact::contacts_last(effects, balls)),
      sleeps(contacts_last && !effects.attraction),
      loses(loses_energy(effects) || drag_rate > 0 || effects.friction) {
  for (const double radius : balls.radius) smallest_radius = std::min(smallest_radius, radius);
  const Vec2 acceleration = effects.gravity ? effects.gravity->acceleration : Vec2{0, 0};
  collision.acceleration = acceleration;
  collision.step = step;
  if (effects.collisions) collision.restitution = effects.collisions->restitution;
  if (effects.walls) collision.wall_restitution = effects.walls->restitution;
  if (effects.friction) {
    collision.friction = effects.friction->balls;
    collision.wall_friction = effects.friction->walls;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double along = acceleration[axis];
    wall[axis] = {collision.wall_restitution, along, drag_rate};
    glide[axis] = Glide{step};
    if (drag_rate > 0) {
      glide[axis] = carom::effects::slowed(drag_rate, step, along);
    } else if (along != 0) {
      glide[axis] = carom::effects::fall(along, step);
    }
  }
  lasting = {step,
             acceleration,
             0,
             {glide[0].fall, glide[1].fall},
             {glide[0].gain, glide[1].gain},
             collision.restitution,
             collision.wall_restitution,
             collision.friction,
             collision.wall_friction,
             loses_energy(effects),
             std::sqrt(glide[0].keep),
             !loses};
}

}  // namespace carom::overlap
