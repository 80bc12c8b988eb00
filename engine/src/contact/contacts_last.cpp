#include "contact/contacts_last.hpp"

#include <algorithm>

namespace carom::contact {
namespace {

constexpr double kUnequal = 16;  // masses: the heavier ball lies on the lighter one for long

bool masses_differ(const Balls& balls) {
  double least = 0;
  double most = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls.fixed(i)) continue;
    const double mass = balls.mass[i];
    least = least == 0 ? mass : std::min(least, mass);
    most = std::max(most, mass);
  }
  return most > kUnequal * least;
}

}  // namespace

bool contacts_last(const Effects& effects, const Balls& balls) {
  const bool falls = effects.gravity && effects.gravity->acceleration != Vec2{0, 0};
  const bool attracted = effects.attraction && effects.attraction->strength > 0 && balls.size() > 1;
  const bool collide = effects.collisions && effects.collisions->on;
  const bool walls = effects.walls && effects.walls->on;
  if (!(falls || attracted) || !(collide || walls)) return false;
  if (loses_energy(effects) || (effects.friction && walls)) return true;
  return falls && collide && masses_differ(balls);
}

}  // namespace carom::contact
