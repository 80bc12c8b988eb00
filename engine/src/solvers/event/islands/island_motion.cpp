#include "solvers/event/islands/island_motion.hpp"

#include <cmath>

#include "contact/contact_graph.hpp"

namespace carom::event {

double approach(const IslandMotion& island, std::size_t contact) {
  const ConeContact& c = island.contacts[contact];
  const auto velocity = [&](int body) {
    return body == kWall ? Vec<double>{0, 0}
                         : island.bodies[static_cast<std::size_t>(body)].velocity;
  };
  return -sharp_dot(c.normal, velocity(c.b) - velocity(c.a));
}

void stop_at(ConeBody& body, const ConeContact& wall, double left) {
  const bool x = wall.normal.x != 0;
  double& v = x ? body.velocity.x : body.velocity.y;
  const double towards = x ? wall.normal.x : wall.normal.y;
  if (towards * v > left) v = left > 0 ? std::copysign(left, towards) : 0;
}

}  // namespace carom::event
