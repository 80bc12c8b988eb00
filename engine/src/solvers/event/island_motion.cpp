#include "solvers/event/island_motion.hpp"

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

}  // namespace carom::event
