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

/// A straight piece of a way, in a part of a step.
struct Piece {
  Vec2 from{0, 0};
  Vec2 way{0, 0};
  double begin = 0;  // of the step
  double end = 0;
};

/// The pieces of the way of a bullet, from wall to wall.
class Way {
 public:
  Way(const Bullet& bullet, double radius, double step, const Domain& domain)
      : domain_(domain),
        radius_(radius),
        step_(step),
        at_(bullet.position),
        velocity_(bullet.velocity),
        left_(step) {}

  /// The next piece; false at the end.
  bool next(Piece& piece) {
    if (!(left_ > 0) || pieces_++ == kMostPieces) return false;
    const double x = time_to_wall(domain_, 0, radius_, at_.x(), velocity_.x());
    const double y = time_to_wall(domain_, 1, radius_, at_.y(), velocity_.y());
    const double time = std::min({x, y, left_});
    piece.from = at_;
    piece.way = velocity_ * time;
    piece.begin = 1 - left_ / step_;
    at_ += piece.way;
    left_ -= time;
    piece.end = 1 - left_ / step_;
    if (x == time) velocity_.x() = -velocity_.x();
    if (y == time) velocity_.y() = -velocity_.y();
    return true;
  }

 private:
  const Domain& domain_;
  double radius_;
  double step_;
  Vec2 at_;
  Vec2 velocity_;
  double left_;
  int pieces_ = 0;
};

/// Counts hits that were missed in the step before.
class Missed {
 public:
  Missed(const Balls& balls, const Domain& domain, double step)
      : balls_(balls), domain_(domain), step_(step) {}

  /// How often a bullet has passed through a ball.
  [[nodiscard]] std::uint64_t passes(const Bullet& bullet, std::size_t ball) const {
    const double reach = balls_.radius[bullet.ball] + balls_.radius[ball];
    const double square = reach * reach;
    const Vec2 end = balls_.at(ball);
    const Vec2 moved = straight_way(ball);
    const auto between = [&](const Vec2& from, const Vec2& to) {
      return nearest_image(to - from, domain_);
    };
    const bool touched = between(bullet.position, end - moved).squaredNorm() <= square;
    const bool touch = between(balls_.at(bullet.ball), end).squaredNorm() <= square;
    std::uint64_t passes = 0;
    Way way(bullet, balls_.radius[bullet.ball], step_, domain_);
    for (Piece piece; way.next(piece);) {
      const Vec2 before = between(piece.from, end - (1 - piece.begin) * moved);
      const Vec2 nearer = piece.way - (piece.end - piece.begin) * moved;
      if (least_square(before, nearer) >= square) continue;
      // What touches afterwards is resolved, unless it has come too far.
      const bool far = nearer.squaredNorm() > 4 * square;
      const bool passed = before.dot(before - nearer) < 0;
      if (touch ? far && passed : passed || !touched) ++passes;
    }
    return passes;
  }

 private:
  /// How a ball has moved in the step; as if it stood where it is if it met a wall.
  [[nodiscard]] Vec2 straight_way(std::size_t ball) const {
    const Vec2 way{step_ * balls_.velocity[0][ball], step_ * balls_.velocity[1][ball]};
    const Vec2 start = balls_.at(ball) - way;
    const double radius = balls_.radius[ball];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain_.solid(axis)) continue;
      const bool inside = start[axis] >= domain_.lowest(axis, radius) &&
                          start[axis] <= domain_.highest(axis, radius);
      if (!inside) return {0, 0};
    }
    return way;
  }

  const Balls& balls_;
  const Domain& domain_;
  double step_;
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
                           std::vector<Bullet> bullets) {
  std::sort(bullets.begin(), bullets.end(),
            [](const Bullet& one, const Bullet& two) { return one.ball < two.ball; });
  const Missed missed(balls, domain, step);
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < bullets.size(); ++k) {
    std::size_t next = 0;  // of the bullets
    for (std::size_t j = 0; j < balls.size(); ++j) {
      const bool bullet = next < bullets.size() && bullets[next].ball == j;
      const std::size_t other = next;
      if (bullet) ++next;
      if (bullet && other <= k) continue;  // two bullets are one pair
      std::uint64_t passes = missed.passes(bullets[k], j);
      if (bullet) passes = std::max(passes, missed.passes(bullets[other], bullets[k].ball));
      sum += passes;
    }
  }
  return sum;
}

}  // namespace carom
