#include "fill/random_places.hpp"

#include <algorithm>
#include <array>

namespace carom::scene {
namespace {

constexpr std::size_t kAtATime = 64;  // places drawn
constexpr std::size_t kTested = 48;   // at once, at least, of those that are not blocked
constexpr double kTooFar = 0x1p30;    // radii: rounding moves no disk by 2^-10 of its radius

/// Lower and upper bounds of the centres of balls that lie wholly in the region.
Region centres_of(const Region& region, double radius) {
  Region centres = region;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (region.around[axis]) continue;
    centres.lower[axis] = region.lower[axis] + radius;
    // A region as wide as its ball is left with one place, whatever the rounding.
    centres.upper[axis] = std::max(centres.lower[axis], region.upper[axis] - radius);
  }
  return centres;
}

}  // namespace

RandomPlaces::RandomPlaces(const Box& box, const Region& region, double radius, std::size_t count,
                           const std::vector<Ball>& before, const DiskGrid& grid)
    : region_(region),
      centres_(centres_of(region, radius)),
      radius_(radius),
      count_(count),
      grid_(grid),
      blocked_(centres_.lower, centres_.upper, radius, count, std::max(box.width, box.height)),
      far_(box) {
  for (const Ball& ball : before) blocked_.insert(ball.position, ball.radius);
  const double farthest =
      std::max({box.width, box.height, std::abs(region.lower.x()), std::abs(region.lower.y()),
                std::abs(region.upper.x()), std::abs(region.upper.y())});
  if (farthest < kTooFar * radius) taken_.emplace(box, centres_, radius, count);
}

void RandomPlaces::draw(Random& random, std::size_t tries, std::vector<Vec2>& places) {
  std::array<Vec2, kAtATime> drawn;
  std::array<Vec2, kTested + kAtATime> open;
  while (places.size() < count_ && tries > 0) {
    std::size_t opens = 0;
    while (opens < kTested && tries > 0) {
      const std::size_t count = std::min(kAtATime, tries);
      tries -= count;
      for (std::size_t k = 0; k < count; ++k) {
        drawn[k] = next(random);
        blocked_.fetch(drawn[k]);
      }
      // What is blocked now stays blocked.
      for (std::size_t k = 0; k < count; ++k) {
        open[opens] = drawn[k];
        opens += blocked_.blocked(drawn[k]) ? 0 : 1;
      }
    }
    if (taken_) {
      for (std::size_t k = 0; k < opens; ++k) taken_->fetch_cells(open[k]);
      for (std::size_t k = 0; k < opens; ++k) taken_->fetch_first(open[k]);
      for (std::size_t k = 0; k < opens; ++k) taken_->fetch_second(open[k]);
    }
    for (std::size_t k = 0; k < opens && places.size() < count_; ++k) {
      if (!has_room(open[k])) continue;
      take(open[k]);
      places.push_back(open[k]);
    }
  }
}

Vec2 RandomPlaces::next(Random& random) const {
  Vec2 place{0, 0};
  for (std::size_t k = 0; k < 2; ++k) {
    place[k] = centres_.lower[k] + random.uniform() * (centres_.upper[k] - centres_.lower[k]);
    place[k] = std::min(place[k], centres_.upper[k]);
    if (region_.around[k] && place[k] >= region_.upper[k]) place[k] = region_.lower[k];
  }
  return place;
}

bool RandomPlaces::has_room(const Vec2& place) const {
  return !blocked_.blocked(place) &&
         (taken_ ? taken_->is_free(place) : far_.is_free(place, radius_)) &&
         grid_.is_free(place, radius_);
}

void RandomPlaces::take(const Vec2& place) {
  blocked_.insert(place, radius_);
  if (taken_) {
    taken_->insert(place);
  } else {
    far_.insert(place, radius_);
  }
}

}  // namespace carom::scene
