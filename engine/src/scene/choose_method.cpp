#include "carom/scene.hpp"

namespace carom {

MethodChoice choose_method(const Scene& scene) {
  if (scene.solver.method) return {*scene.solver.method, "the scene names it"};
  return {Method::overlap, "the only one in this version"};
}

}  // namespace carom
