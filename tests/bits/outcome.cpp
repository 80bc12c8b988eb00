#include "bits/outcome.hpp"

#include <stdexcept>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/session.hpp"

namespace carom::bits {

std::string outcome(const std::filesystem::path& file, Method method, double seconds) {
  Scene scene = read_scene(file);
  scene.solver.method = method;
  if (method == Method::overlap) scene.solver.digits = 16;
  scene.workers = 1;
  scene.per_ball = false;
  try {
    Session session(std::move(scene));
    session.advance_clock_to(session.clock() + seconds);
    return session.simulation().state_hash();
  } catch (const SceneError&) {
    return "refused";
  } catch (const std::runtime_error&) {
    return "failed";
  }
}

}  // namespace carom::bits
