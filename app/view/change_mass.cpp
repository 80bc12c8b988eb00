#include "view/change_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "carom/effects.hpp"
#include "carom/shorter_way.hpp"

namespace carom {
namespace {

constexpr double kLightest = 1e-6;
constexpr double kHeaviest = 1e6;

bool is_free(const Session& session, const std::vector<Ball>& balls, std::size_t ball) {
  const Box& box = session.scene().box;
  const Effects& effects = session.simulation().effects();
  const Ball& own = balls[ball];
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double x = own.position[axis];
    if (effects.walls && effects.walls->on && !box.periodic[axis] &&
        (x < box.lower()[axis] + own.radius || x > box.upper()[axis] - own.radius))
      return false;
  }
  if (!effects.collisions || !effects.collisions->on) return true;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (i == ball || (balls[i].fixed && own.fixed)) continue;
    const Vec2 apart = shorter_way(balls[i].position - own.position, box);
    const double reach = balls[i].radius + own.radius;
    if (apart.squaredNorm() < reach * reach) return false;
  }
  return true;
}

}  // namespace

std::string change_mass(Session& session, std::size_t ball, double factor) {
  const std::vector<Ball> balls = session.simulation().state();
  Ball changed = balls.at(ball);
  changed.mass = std::clamp(changed.mass * factor, std::min(kLightest, changed.mass),
                            std::max(kHeaviest, changed.mass));
  if (changed.mass == balls[ball].mass) return fmt::format("the mass stays {:.6g}", changed.mass);
  if (!is_free(session, balls, ball)) return "it touches something: try while it flies";
  session.apply(command::Remove{ball});
  session.apply(command::Add{changed});
  return "";
}

}  // namespace carom
