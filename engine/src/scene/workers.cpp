#include <algorithm>
#include <thread>

#include "carom/scene.hpp"
#include "effects/domains_suit.hpp"

namespace carom {

namespace {

// What a worker does in a phase has to outweigh what it costs to meet the others at its end, a few
// microseconds, by so much that cores which are busy with something else do not turn the gain
// into a loss.
constexpr std::size_t kManyToStep = 20'000;     // balls of overlap, some 20 ns each in a phase
constexpr std::size_t kManyToAttract = 300;     // each attracts each: some 50 us or more
constexpr std::size_t kManyToForesee = 20'000;  // balls of event, in windows that hold thousands

// Method event shares domains of the plane.  Which balls touch at the start is not known yet: those
// that gravity presses together are few, or the scene has losses.
bool has_domains(const Scene& scene) {
  const Effects& effects = scene.effects;
  const bool rests = loses_energy(scene) || (effects.gravity && (effects.friction || effects.drag));
  // Domains solve what falls only until the first ball rests; then one worker is as fast as many.
  if (rests && effects.gravity) return false;
  return scene.solver.digits == 16 && domains_suit(effects, scene.box.periodic, rests);
}

bool gains_by_sharing(const Scene& scene, std::size_t balls) {
  if (scene.effects.attraction) return balls >= kManyToAttract;
  if (choose_method(scene).method == Method::overlap) return balls >= kManyToStep;
  return balls >= kManyToForesee && has_domains(scene);
}

}  // namespace

std::size_t count_moving(const std::vector<Ball>& balls) {
  return static_cast<std::size_t>(
      std::count_if(balls.begin(), balls.end(), [](const Ball& ball) { return !ball.fixed; }));
}

std::size_t worker_count(const Scene& scene, std::size_t balls, std::size_t moving) {
  constexpr std::size_t kPerBallUpTo = 256;
  if (scene.workers) return *scene.workers;
  if (scene.per_ball) return std::max<std::size_t>(1, balls);
  if (scene.played && moving <= kPerBallUpTo) return std::max<std::size_t>(1, moving);
  if (!scene.played && !gains_by_sharing(scene, balls)) return 1;
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

}  // namespace carom
