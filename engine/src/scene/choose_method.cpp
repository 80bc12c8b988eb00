#include "carom/scene.hpp"
#include "scene/available.hpp"

namespace carom {

namespace {

// Under gravity balls that lose energy come to lie on each other: event steps all of a pile at once
// until it rests, which takes long where they are many.
bool can_pile_up(const Scene& scene) {
  constexpr std::size_t kFew = 300;
  const Effects& effects = scene.effects;
  if (!effects.gravity || !effects.collisions) return false;
  if (!loses_energy(scene) && !effects.drag && !effects.friction) return false;
  std::size_t moving = count_moving(scene.balls);
  for (const Fill& fill : scene.fills) moving += fill.count;
  return moving > kFew;
}

}  // namespace

MethodChoice choose_method(const Scene& scene) {
  if (scene.solver.method) return {*scene.solver.method, "the scene names it"};
  const std::string why_not = obstacle(scene, Method::event);
  if (!why_not.empty()) return {Method::overlap, why_not};
  const bool wide = scene.solver.digits > 16;
  if (can_pile_up(scene) && !wide) return {Method::overlap, kPilesUp, true};
  return {Method::event, "it can take the scene"};
}

std::string obstacle(const Scene& scene, Method method) {
  const std::vector<Problem> obstacles = scene::find_unavailable(scene, method);
  return obstacles.empty() ? std::string() : obstacles.front().message;
}

}  // namespace carom
