#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/scene.hpp"
#include "carom/scene_file.hpp"
#include "fill/disk_grid.hpp"
#include "fill/lattice.hpp"
#include "fill/random.hpp"
#include "fill/random_places.hpp"

namespace carom {

namespace {

using scene::DiskGrid;
using scene::Lattice;
using scene::Random;
using scene::RandomPlaces;
using scene::Region;

/// Random places are given up beyond so many tries a ball, on average.
constexpr std::size_t kTriesPerBall = 1000;
constexpr std::size_t kTriesAtLeast = 10'000;
/// Disks put down at random one by one jam at this packing.
/// Source: Torquato, Uche, Stillinger 2006: 0.547.
constexpr double kJammed = 0.547;

[[noreturn]] void no_room(const Scene& scene, std::size_t fill, std::string message) {
  throw SceneError(scene.source, {{fmt::format("/fill/{}/count", fill), std::move(message)}});
}

Region region_of(const Fill& fill, const Box& box) {
  Region region{box.lower(), box.upper(), {}};
  if (fill.region) {
    region.lower = (*fill.region)[0];
    region.upper = (*fill.region)[1];
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto k = axis;
    region.around[axis] = box.periodic[axis] && region.lower[k] == box.lower()[k] &&
                          region.upper[k] == box.upper()[k];
  }
  return region;
}

void place_at_random(const Scene& scene, std::size_t number, const std::vector<Ball>& before,
                     const DiskGrid& grid, std::vector<Vec2>& places) {
  const Fill& fill = scene.fills[number];
  const Region region = region_of(fill, scene.box);
  const Vec2 size = region.upper - region.lower;
  const double packing = static_cast<double>(fill.count) * std::numbers::pi * fill.radius *
                         fill.radius / (size.x() * size.y());
  if (fill.count > kTriesAtLeast && packing > 1.05 * kJammed) {
    no_room(scene, number,
            fmt::format("does not fit: random places jam when {:.1f} % of the region is covered, "
                        "and {} balls of radius {:g} cover {:.1f} %; ask for fewer or smaller "
                        "balls, or \"arrangement\": \"hexagonal\"",
                        100 * kJammed, fill.count, fill.radius, 100 * packing));
  }
  Random random(scene.seed, 2 * number);
  RandomPlaces(scene.box, region, fill.radius, fill.count, before, grid)
      .draw(random, kTriesAtLeast + kTriesPerBall * fill.count, places);
  if (places.size() < fill.count) {
    no_room(scene, number,
            fmt::format("does not fit: only {} of {} balls found room at random; ask for fewer or "
                        "smaller balls, or \"arrangement\": \"hexagonal\"",
                        places.size(), fill.count));
  }
}

/// The lattice is made finer until enough of its sites are free of earlier balls; of those, `count`
/// are taken at even distances in their order.
void place_on_lattice(const Scene& scene, std::size_t number, const DiskGrid& grid,
                      std::vector<Vec2>& places) {
  const Fill& fill = scene.fills[number];
  const Region region = region_of(fill, scene.box);
  std::size_t sites = fill.count;
  while (true) {
    const Lattice lattice = fill.arrangement == Fill::Arrangement::square
                                ? square_lattice(region, sites)
                                : hexagonal_lattice(region, sites);
    if (lattice.spacing * (1 + 0x1p-48) < 2 * fill.radius) {
      no_room(scene, number,
              fmt::format("does not fit: a lattice of {} sites has a spacing of {:.6g}, less than "
                          "the diameter {:g}; ask for fewer or smaller balls",
                          lattice.sites.size(), lattice.spacing, 2 * fill.radius));
    }
    std::vector<Vec2> free;
    for (const Vec2& site : lattice.sites) {
      if (grid.is_free(site, fill.radius)) free.push_back(site);
    }
    if (free.size() >= fill.count) {
      for (std::size_t i = 0; i < fill.count; ++i) {
        places.push_back(free[i * free.size() / fill.count]);
      }
      break;
    }
    sites = std::max(sites, lattice.sites.size()) + (fill.count - free.size());
  }
}

/// Gaussian velocities less their mean, stretched by sqrt(n / (n - 1)) so that the variance of each
/// component stays temperature / mass although the mean is taken away.
void give_velocities(const Scene& scene, std::size_t number, std::vector<Ball>& balls,
                     std::size_t first) {
  const Fill& fill = scene.fills[number];
  const std::size_t n = balls.size() - first;
  if (fill.temperature == 0 || n < 2) return;
  Random random(scene.seed, 2 * number + 1);
  Vec2 mean{0, 0};
  for (std::size_t i = first; i < balls.size(); ++i) {
    const double x = random.gaussian();
    const double y = random.gaussian();
    balls[i].velocity = {x, y};
    mean += balls[i].velocity;
  }
  const auto count = static_cast<double>(n);
  mean /= count;
  const double stretch = std::sqrt(count / (count - 1));
  const double speed = std::sqrt(fill.temperature / fill.mass);
  for (std::size_t i = first; i < balls.size(); ++i) {
    balls[i].velocity = (balls[i].velocity - mean) * stretch * speed;
  }
}

}  // namespace

std::vector<Ball> populate(const Scene& scene) {
  std::vector<Ball> balls = scene.balls;
  if (scene.fills.empty()) return balls;
  DiskGrid grid(scene.box);
  for (const Ball& ball : balls) grid.insert(ball.position, ball.radius);
  for (std::size_t number = 0; number < scene.fills.size(); ++number) {
    const Fill& fill = scene.fills[number];
    if (fill.count == 0) continue;
    std::vector<Vec2> places;
    places.reserve(fill.count);
    if (fill.arrangement == Fill::Arrangement::random) {
      place_at_random(scene, number, balls, grid, places);
    } else {
      place_on_lattice(scene, number, grid, places);
    }
    // No later fill must avoid those of the last.
    const bool last = number + 1 == scene.fills.size();
    const std::size_t first = balls.size();
    balls.reserve(first + places.size());
    for (const Vec2& place : places) {
      if (!last) grid.insert(place, fill.radius);
      Ball ball;
      ball.position = place;
      ball.radius = fill.radius;
      ball.mass = fill.mass;
      ball.glyph = fill.glyph;
      balls.push_back(ball);
    }
    give_velocities(scene, number, balls, first);
  }
  return balls;
}

}  // namespace carom
