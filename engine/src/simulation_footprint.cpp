#include "carom/footprint.hpp"

#include <algorithm>
#include <numbers>

#include "contact/cell_grid.hpp"
#include "solvers/event/event_memory.hpp"
#include "solvers/overlap/plan.hpp"

namespace carom {

namespace {

constexpr std::size_t kNumber = sizeof(double);
/// Neighbours are looked for out to about one and a half contact distances.
std::size_t listed_pairs(const Scene& scene, const std::vector<Ball>& balls) {
  double radii = 0;
  for (const Ball& ball : balls) radii += ball.radius;
  const auto n = static_cast<double>(balls.size());
  const double reach = 3 * radii / n;
  const double around = n * std::numbers::pi * reach * reach / (scene.box.width * scene.box.height);
  return static_cast<std::size_t>(n * std::min(around, n - 1) / 2);
}

void describe_event(const Scene& scene, const std::vector<Ball>& balls, Footprint& result) {
  const event::EventMemory memory = event::event_memory(scene, balls, result.workers);
  result.columns = {{"ball", balls.size() * sizeof(Ball)}, {"flight", memory.flights}};
  const auto add = [&result](const char* name, std::size_t bytes) {
    if (bytes > 0) result.lists.emplace_back(name, bytes);
  };
  add("neighbours", memory.neighbours);
  add("event queue", memory.queue);
  add("domains", memory.domains);
  result.barriers = {"do_frame", scene.effects.walls ? "wall_computation" : "flight"};
  if (scene.effects.collisions) {
    result.barriers.insert(result.barriers.end(), {"pair_computation", "pair_resolution"});
  }
  result.barriers.emplace_back("frame_done");
}

}  // namespace

std::size_t Footprint::bytes() const {
  std::size_t sum = 0;
  for (const auto& [name, bytes] : columns) sum += bytes;
  for (const auto& [name, bytes] : lists) sum += bytes;
  return sum;
}

Footprint footprint(const Scene& scene, const std::vector<Ball>& balls) {
  Footprint result;
  const std::size_t n = balls.size();
  result.balls = n;
  if (scene.effects.collisions) {
    const auto fixed = static_cast<std::size_t>(
        std::count_if(balls.begin(), balls.end(), [](const Ball& ball) { return ball.fixed; }));
    const auto unique = [](std::size_t k) { return k == 0 ? 0 : k * (k - 1) / 2; };
    result.pairs = unique(n) - unique(fixed);
  }
  result.workers = worker_count(scene, n, count_moving(balls));
  if (choose_method(scene).method == Method::event) {
    describe_event(scene, balls, result);
    return result;
  }
  result.columns = {{"position", 2 * n * kNumber}, {"velocity", 2 * n * kNumber},
                    {"radius", n * kNumber},       {"mass", n * kNumber},
                    {"inverse_mass", n * kNumber}, {"glyph", n}};
  if (scene.effects.friction) result.columns.emplace_back("spin", n * kNumber);
  if (scene.effects.attraction) result.columns.emplace_back("pull", 2 * n * kNumber);
  result.barriers = {"do_frame", scene.effects.walls ? "wall_computation" : "flight"};
  const overlap::Plan plan(scene.effects, n, result.workers);
  if (plan.pairs) {
    if (plan.neighbour_list) {
      result.lists.emplace_back("pairs", listed_pairs(scene, balls) * PairList::kBytesOfPair);
      result.lists.emplace_back("cells", n * CellGrid::kBytesOfBall);
      result.lists.emplace_back("anchors", 2 * n * kNumber);
    } else {
      result.lists.emplace_back("pairs", result.pairs * PairList::kBytesOfPair);
    }
    if (plan.shared_search) result.barriers.emplace_back("neighbour_search");
    result.barriers.emplace_back("pair_computation");
    if (plan.shared_resolution) result.barriers.emplace_back("pair_resolution");
  }
  if (plan.attraction) result.barriers.emplace_back("attraction");
  result.barriers.emplace_back("frame_done");
  return result;
}

}  // namespace carom
