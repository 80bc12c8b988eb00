#include "carom/scene.hpp"
#include "scene/available.hpp"

namespace carom {

namespace {

// Balls that lose energy under gravity crowd together: until they rest event steps all of a pile at
// once, again and again.
bool will_pile_up(const Scene& scene) {
  const Effects& effects = scene.effects;
  if (!effects.gravity || !effects.collisions) return false;
  std::size_t moving = 0;
  for (const Ball& ball : scene.balls) moving += ball.fixed ? 0 : 1;
  for (const Fill& fill : scene.fills) moving += fill.count;
  return loses_energy(effects) && moving > 1;
}

}  // namespace

MethodChoice choose_method(const Scene& scene) {
  if (scene.solver.method) return {*scene.solver.method, "the scene names it"};
  const bool wide = scene.solver.digits > 16;
  if (will_pile_up(scene) && !wide) {
    return {Method::overlap,
            "balls that lose energy pile up under gravity, which event pays dearly"};
  }
  const std::string why_not = obstacle(scene, Method::event);
  if (why_not.empty()) return {Method::event, "it can take the scene"};
  return {Method::overlap, why_not};
}

std::string obstacle(const Scene& scene, Method method) {
  const std::vector<Problem> obstacles = scene::find_unavailable(scene, method);
  return obstacles.empty() ? std::string() : obstacles.front().message;
}

}  // namespace carom
