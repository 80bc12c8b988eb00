#include <algorithm>
#include <thread>

#include "carom/scene.hpp"

namespace carom {

std::vector<Ball> populate(const Scene& scene) {
  return scene.balls;
}

std::size_t worker_count(const Scene& scene, std::size_t balls) {
  constexpr std::size_t kPerBallUpTo = 256;
  if (scene.workers) return *scene.workers;
  if (scene.per_ball || balls <= kPerBallUpTo) return std::max<std::size_t>(1, balls);
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

}  // namespace carom
