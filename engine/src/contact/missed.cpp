#include "contact/missed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

constexpr int kMostPieces = 64;

/// When a ball at x with velocity v leaves the solid axis; infinite where it never does.
double time_to_wall(const Domain& domain, std::size_t axis, double radius, double x, double v) {
  if (!domain.solid(axis) || v == 0) return std::numeric_limits<double>::infinity();
  const double end = v > 0 ? domain.highest(axis, radius) : domain.lowest(axis, radius);
  return std::max((end - x) / v, 0.0);
}

/// The square of the least distance between a point that moves by `way` and one that stands `r`
/// off.
double least_square(const Vec2& r, const Vec2& way) {
  const double along = r.dot(way);
  const double length = way.squaredNorm();
  const double part = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  return (r - part * way).squaredNorm();
}

/// The pieces of the way of a bullet, from wall to wall.
class Way {
 public:
  Way(const Bullet& bullet, double radius, double step, const Domain& domain)
      : domain_(domain),
        radius_(radius),
        at_(bullet.position),
        velocity_(bullet.velocity),
        left_(step) {}

  /// The next piece; false at the end.
  bool next(Vec2& from, Vec2& piece) {
    if (!(left_ > 0) || pieces_++ == kMostPieces) return false;
    const double x = time_to_wall(domain_, 0, radius_, at_.x(), velocity_.x());
    const double y = time_to_wall(domain_, 1, radius_, at_.y(), velocity_.y());
    const double time = std::min({x, y, left_});
    from = at_;
    piece = velocity_ * time;
    at_ += piece;
    left_ -= time;
    if (x == time) velocity_.x() = -velocity_.x();
    if (y == time) velocity_.y() = -velocity_.y();
    return true;
  }

 private:
  const Domain& domain_;
  double radius_;
  Vec2 at_;
  Vec2 velocity_;
  double left_;
  int pieces_ = 0;
};

}  // namespace

void find_bullets(const Balls& balls, std::size_t begin, std::size_t end, double step,
                  double smallest_radius, std::vector<Bullet>& bullets) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t k = i;
    const double vx = balls.velocity[0][k];
    const double vy = balls.velocity[1][k];
    const double reach = balls.radius[k] + smallest_radius;
    if ((vx * vx + vy * vy) * (step * step) > reach * reach) {
      bullets.push_back({i, balls.at(i), {vx, vy}});
    }
  }
}

std::uint64_t count_missed(const Balls& balls, const Domain& domain, double step,
                           const std::vector<Bullet>& bullets) {
  std::uint64_t missed = 0;
  for (const Bullet& bullet : bullets) {
    const double radius = balls.radius[bullet.ball];
    const Vec2 arrived = balls.at(bullet.ball);
    Way way(bullet, radius, step, domain);
    Vec2 from;
    Vec2 piece;
    while (way.next(from, piece)) {
      for (std::size_t j = 0; j < balls.size(); ++j) {
        if (j == bullet.ball) continue;
        const double reach = radius + balls.radius[j];
        const double square = reach * reach;
        const auto touches = [&](const Vec2& at) {
          return nearest_image(balls.at(j) - at, domain).squaredNorm() <= square;
        };
        const Vec2 before = nearest_image(balls.at(j) - from, domain);
        if (least_square(before, piece) >= square) continue;
        // What touches afterwards is resolved, unless it has come too far.
        const bool far = piece.squaredNorm() > 4 * square;
        const bool passed = before.dot(before - piece) < 0;
        if (touches(arrived) ? far && passed : passed || !touches(bullet.position)) ++missed;
      }
    }
  }
  return missed;
}

}  // namespace carom
