#include "carom/free_place.hpp"

#include <algorithm>
#include <cmath>

#include "fill/disk_grid.hpp"
#include "fill/random.hpp"

namespace carom {

namespace {

constexpr int kTries = 1000;
constexpr double kMostPerAxis = 200;             // places that a scan tries
constexpr std::uint64_t kStream = 0x706C616365;  // apart from the streams of the fills

}  // namespace

std::optional<Vec2> find_free_place(const Scene& scene, const std::vector<Ball>& balls,
                                    double radius, std::uint64_t number) {
  Vec2 lower = scene.box.lower();
  Vec2 size = scene.box.size();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (scene.box.periodic[static_cast<std::size_t>(axis)]) continue;
    lower[axis] += radius;
    size[axis] -= 2 * radius;
    if (size[axis] < 0) return std::nullopt;
  }
  scene::DiskGrid grid(scene.box);
  for (const Ball& ball : balls) grid.insert(ball.position, ball.radius);
  scene::Random random(scene.seed, kStream + number);
  for (int i = 0; i < kTries; ++i) {
    const double x = random.uniform();
    const double y = random.uniform();
    const Vec2 place = lower + Vec2{x * size.x(), y * size.y()};
    if (grid.is_free(place, radius)) return place;
  }
  // Half a radius apart, so that only a gap a little wider than the ball is overlooked.
  const double columns = std::clamp(std::ceil(2 * size.x() / radius), 1.0, kMostPerAxis);
  const double rows = std::clamp(std::ceil(2 * size.y() / radius), 1.0, kMostPerAxis);
  for (double j = 0; j <= rows; ++j) {
    for (double i = 0; i <= columns; ++i) {
      const Vec2 place = lower + Vec2{size.x() * (i / columns), size.y() * (j / rows)};
      if (grid.is_free(place, radius)) return place;
    }
  }
  return std::nullopt;
}

}  // namespace carom
