#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "fill/disk_grid.hpp"
#include "fill/overlap_search.hpp"
#include "scene/judge.hpp"
#include "scene/limits.hpp"

namespace carom::scene {

namespace {

constexpr const char* kAxisNames[] = {"x", "y"};
constexpr const char* kSides[] = {"width", "height"};

/// A length and a few units in the last places of the numbers it was computed from.
double with_allowance(double length, double largest) {
  return length + 0x1p-50 * largest;
}

bool judge_inside(const Ball& ball, const Place& place, const Scene& scene, Verdict& verdict) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!has_walls(scene.effects) || scene.box.periodic[static_cast<std::size_t>(axis)]) continue;
    const double lower = scene.box.lower()[axis];
    const double upper = scene.box.upper()[axis];
    const double x = ball.position[axis];
    const double largest = std::max({std::abs(x), ball.radius, upper - lower});
    if (x >= lower && x <= upper && 2 * ball.radius > with_allowance(upper - lower, largest)) {
      verdict.add(place / "radius",
                  fmt::format("must be at most {:g} to fit between the walls in {}, got {}",
                              (upper - lower) / 2, kAxisNames[axis], ball.radius));
      return false;
    }
    if (with_allowance(x - lower, largest) < ball.radius ||
        with_allowance(upper - x, largest) < ball.radius) {
      verdict.add(
          place / "position" / axis,
          fmt::format("must keep the ball inside the walls, {} from {:g} to {:g} for its "
                      "radius of {:g}, got {}",
                      kAxisNames[axis], lower + ball.radius, upper - ball.radius, ball.radius, x));
      return false;
    }
  }
  return true;
}

/// Around a periodic axis two balls may meet through one side at a time only.
bool judge_periodic(double radius, double largest_radius, const Place& place, const Scene& scene,
                    Verdict& verdict) {
  if (!scene.effects.collisions) return true;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!scene.box.periodic[static_cast<std::size_t>(axis)]) continue;
    const double size = scene.box.size()[axis];
    const double contact = radius + largest_radius;
    if (2 * contact > with_allowance(size, size)) {
      verdict.add(place, fmt::format("is too large for the periodic box: its {} must be at least "
                                     "{:g}, twice the contact distance of two balls, got {:g}",
                                     kSides[axis], 2 * contact, size));
      return false;
    }
  }
  return true;
}

bool judge_radius(double radius, const Place& place, const Scene& scene, Verdict& verdict) {
  const double side = std::max(scene.box.width, scene.box.height);
  if (side <= kBoxToRadius * radius) return true;
  verdict.add(place, fmt::format("must be at least {:g}, the larger side of the box / {:g}, got {}",
                                 side / kBoxToRadius, kBoxToRadius, radius));
  return false;
}

/// The balls that a ball may overlap: walls are made of fixed balls, which may overlap each other.
class Overlaps {
 public:
  explicit Overlaps(const Scene& scene)
      : scene_(scene), grids_{DiskGrid(scene.box), DiskGrid(scene.box)} {}

  /// At most so many of the balls before that overlap this one.
  [[nodiscard]] std::vector<std::size_t> of(std::size_t i, std::size_t at_most) const {
    const Ball& ball = scene_.balls[i];
    std::vector<std::size_t> balls;
    for (const bool fixed : {false, true}) {
      if (fixed && ball.fixed) continue;
      for (const std::size_t k :
           grids_[fixed].overlapping(ball.position, ball.radius, at_most - balls.size())) {
        balls.push_back(numbers_[fixed][k]);
      }
      if (balls.size() >= at_most) break;
    }
    return balls;
  }

  void insert(std::size_t i) {
    const Ball& ball = scene_.balls[i];
    grids_[ball.fixed].insert(ball.position, ball.radius);
    numbers_[ball.fixed].push_back(i);
  }

 private:
  const Scene& scene_;
  std::array<DiskGrid, 2> grids_;  // of the moving balls, of the fixed ones
  std::array<std::vector<std::size_t>, 2> numbers_;
};

void judge_overlaps(const Scene& scene, const std::vector<std::size_t>& good, Verdict& verdict) {
  if (good.size() == scene.balls.size() && !may_overlap(scene.box, scene.balls)) return;
  // Large balls first, so that each looks at few of its own size and larger.
  std::vector<std::size_t> order = good;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scene.balls[a].radius > scene.balls[b].radius;
  });
  Overlaps overlaps(scene);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::size_t others = 0;
  for (const std::size_t i : order) {
    const std::size_t left = kMostOverlapsTold - pairs.size();
    const auto found = overlaps.of(i, std::max<std::size_t>(left, 1));
    if (left == 0 && !found.empty()) {
      ++others;
      continue;  // one in a heap is enough to know the rest of it
    }
    for (const std::size_t k : found) pairs.emplace_back(std::max(i, k), std::min(i, k));
    overlaps.insert(i);
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [second, first] : pairs) {
    const Ball& a = scene.balls[first];
    const Ball& b = scene.balls[second];
    verdict.add(
        Place("/balls") / second,
        fmt::format("overlaps /balls/{} by {:.3g}, move them apart or make them smaller", first,
                    overlap_depth(scene.box, a.position, a.radius, b.position, b.radius)));
  }
  if (others > 0) {
    verdict.add("/balls", fmt::format("has {} more balls that overlap others", others));
  }
}

}  // namespace

bool judge_ball(const Ball& ball, const Place& place, const Scene& scene, Verdict& verdict) {
  const bool good = verdict.numbers(place, ball);
  if (ball.fixed && good && (ball.velocity != Vec2{0, 0} || ball.spin != 0)) {
    const bool moves = ball.velocity != Vec2{0, 0};
    verdict.add(place / (moves ? "velocity" : "spin"),
                "must be 0 for a fixed ball, which never moves");
    return false;
  }
  if (!good || !has_box(scene)) return good;
  return judge_radius(ball.radius, place / "radius", scene, verdict) &&
         judge_inside(ball, place, scene, verdict);
}

void judge_fill(const Fill& fill, const Place& place, const Scene& scene, Verdict& verdict) {
  bool good = verdict.numbers(place, fill);
  if (fill.region) {
    good &= verdict.finite(place / "region" / "0", (*fill.region)[0]);
    good &= verdict.finite(place / "region" / "1", (*fill.region)[1]);
  }
  if (!good || !has_box(scene)) return;
  if (!judge_radius(fill.radius, place / "radius", scene, verdict)) return;
  const Vec2 lower = fill.region ? (*fill.region)[0] : scene.box.lower();
  const Vec2 upper = fill.region ? (*fill.region)[1] : scene.box.upper();
  if (fill.count == 0) return;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const bool periodic = scene.box.periodic[static_cast<std::size_t>(axis)];
    if (!(lower[axis] < upper[axis])) {
      verdict.add(place / "region" / "1" / axis,
                  fmt::format("must be greater than {:g}, the corners are lower left and upper "
                              "right, got {:g}",
                              lower[axis], upper[axis]));
      return;
    }
    if ((periodic || has_walls(scene.effects)) &&
        (lower[axis] < scene.box.lower()[axis] || upper[axis] > scene.box.upper()[axis])) {
      const int corner = lower[axis] < scene.box.lower()[axis] ? 0 : 1;
      verdict.add(place / "region" / (corner == 0 ? "0" : "1") / axis,
                  fmt::format("must be inside the box, {} from {:g} to {:g}, got {:g}",
                              kAxisNames[axis], scene.box.lower()[axis], scene.box.upper()[axis],
                              (*fill.region)[static_cast<std::size_t>(corner)][axis]));
      return;
    }
    if (2 * fill.radius > with_allowance(upper[axis] - lower[axis], upper[axis] - lower[axis])) {
      verdict.add(place / "radius",
                  fmt::format("must be at most {:g} to fit into the region in {}, got {}",
                              (upper[axis] - lower[axis]) / 2, kAxisNames[axis], fill.radius));
      return;
    }
  }
  const Vec2 size = upper - lower;
  const double packing = static_cast<double>(fill.count) * std::numbers::pi * fill.radius *
                         fill.radius / (size.x() * size.y());
  if (packing > std::numbers::pi / (2 * std::numbers::sqrt3) * (1 + 0x1p-40)) {
    verdict.add(place / "count",
                fmt::format("does not fit: {} balls of radius {:g} cover {:.0f} % of the region, "
                            "at most 90.7 % can be covered",
                            fill.count, fill.radius, 100 * packing));
  }
}

void judge_balls(const Scene& scene, Verdict& verdict) {
  std::vector<std::size_t> good;
  good.reserve(scene.balls.size());
  double largest = 0;
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    if (judge_ball(scene.balls[i], Place("/balls") / i, scene, verdict)) {
      good.push_back(i);
      largest = std::max(largest, scene.balls[i].radius);
    }
  }
  std::size_t balls = scene.balls.size();
  for (std::size_t i = 0; i < scene.fills.size(); ++i) {
    const Fill& fill = scene.fills[i];
    judge_fill(fill, Place("/fill") / i, scene, verdict);
    if (std::isfinite(fill.radius)) largest = std::max(largest, fill.radius);
    if (fill.count > kMostBalls || balls + fill.count > kMostBalls) {
      verdict.add(Place("/fill") / i / "count",
                  fmt::format("makes more balls than the {} a scene may have", kMostBalls));
      break;
    }
    balls += fill.count;
  }
  if (scene.balls.size() > kMostBalls) {
    verdict.add("/balls",
                fmt::format("has {} balls, a scene may have {}", scene.balls.size(), kMostBalls));
    return;
  }
  if (!has_box(scene)) return;
  const bool any_axis = scene.box.periodic[0] || scene.box.periodic[1];
  for (const std::size_t i : good) {
    if (!any_axis) break;
    if (!judge_periodic(scene.balls[i].radius, largest, Place("/balls") / i / "radius", scene,
                        verdict)) {
      return;
    }
  }
  for (std::size_t i = 0; i < scene.fills.size(); ++i) {
    const double radius = scene.fills[i].radius;
    if (radius > 0 &&
        !judge_periodic(radius, largest, Place("/fill") / i / "radius", scene, verdict)) {
      return;
    }
  }
  // A saved run may have been caught while its method was moving balls apart.
  if (has_collisions(scene.effects) && !scene.continuation) judge_overlaps(scene, good, verdict);
}

}  // namespace carom::scene
