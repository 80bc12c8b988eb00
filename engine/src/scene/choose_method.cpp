#include "carom/scene.hpp"
#include "scene/available.hpp"

namespace carom {

MethodChoice choose_method(const Scene& scene) {
  if (scene.solver.method) return {*scene.solver.method, "the scene names it"};
  const std::vector<Problem> obstacles = scene::find_unavailable(scene, Method::event);
  if (obstacles.empty()) return {Method::event, "it can take the scene"};
  return {Method::overlap, "event cannot take " + obstacles.front().place};
}

}  // namespace carom
