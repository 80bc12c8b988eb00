#include "warnings.hpp"

#include <fmt/format.h>

#include "standard_streams.hpp"

namespace carom {

void print_warnings(const Scene& scene, double seconds) {
  const double step = scene.solver.step;
  const bool whole_steps = choose_method(scene).method == Method::overlap;
  if (!whole_steps || !(seconds > 0) || !(step > seconds)) return;
  print_error(
      fmt::format("carom: warning: {}: /solver/step: {:.4g} s is longer than the run of {:.4g} s: "
                  "overlap takes whole steps, so nothing moves; use a shorter step\n",
                  scene.source.empty() ? "the scene" : scene.source, step, seconds));
}

}  // namespace carom
