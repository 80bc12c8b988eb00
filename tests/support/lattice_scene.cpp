#include "support/lattice_scene.hpp"

#include <cmath>
#include <cstddef>
#include <initializer_list>

#include "support/random_numbers.hpp"

namespace carom::test {
namespace {

class LatticeMaker {
 public:
  explicit LatticeMaker(std::uint64_t seed) : random_(seed) {
    scene_.name = "lattice";
    scene_.seed = seed;
    scene_.workers = 1;
    scene_.duration = 0.5;
    scene_.solver.method = Method::event;
    scene_.solver.digits = random_.below(8) == 0 ? 34 : 16;
  }

  Scene take() {
    columns_ = 1 + random_.below(5);
    rows_ = 1 + random_.below(6);
    hexagonal_ = random_.below(5) < 2;
    radius_ = pick({0.25, 0.5, 1});
    box();
    effects();
    balls();
    if (random_.below(4) == 0) {
      Effects turned;
      turned.gravity = Gravity{{0, 9.81}};
      scene_.script.push_back({0.25, command::SetEffects{turned}});
    }
    return scene_;
  }

 private:
  double pick(std::initializer_list<double> values) {
    return values.begin()[random_.below(static_cast<int>(values.size()))];
  }

  void box() {
    const double diameter = 2 * radius_;
    scene_.box.width = diameter * (columns_ + pick({0, 0, 0.5, 1, 2.5})) + shift(1);
    scene_.box.height = diameter * (rows_ + pick({0, 1, 3}));
    scene_.box.periodic[0] = random_.below(10) == 0 && scene_.box.width > 4 * radius_;
  }

  void effects() {
    Effects& effects = scene_.effects;
    const double restitution = pick({0, 0.3, 0.5, 0.9, 1, 1});
    effects.walls = Walls{restitution};
    effects.collisions = Collisions{pick({restitution, restitution, 1, 0.5})};
    const Vec2 pulls[] = {{0, -9.81}, {0, -9.81}, {1, -9.81}, {0, 0}, {-9.81, 0}, {3, -4}};
    effects.gravity = Gravity{pulls[random_.below(6)]};
    if (random_.below(3) > 0) {
      effects.friction = Friction{pick({0.1, 0.5, 0.8, 2}), pick({0, 0.3, 0.8})};
    }
    if (random_.below(4) == 0) effects.drag = Drag{0.1};
  }

  /// How far odd rows of a hexagonal lattice stand to the right.
  [[nodiscard]] double shift(int row) const { return hexagonal_ && row % 2 == 1 ? radius_ : 0; }

  void balls() {
    const double decades = pick({0, 0, 2, 4, 6});
    const bool move = random_.below(2) == 0;
    // So much that no two of them overlap by rounding.
    const double height = hexagonal_ ? radius_ * std::sqrt(3.0) * (1 + 1e-12) : 2 * radius_;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        Ball ball;
        ball.radius = radius_;
        ball.position = {radius_ + 2 * radius_ * column + shift(row), radius_ + height * row};
        ball.mass = std::pow(10.0, random_.between(-decades / 2, decades / 2));
        ball.fixed = random_.below(12) == 0;
        if (!ball.fixed && move && random_.below(2) == 0) {
          ball.velocity = {random_.below(4) - 1.0, random_.below(3) - 1.0};
        }
        if (random_.below(7) == 0 || ball.position.x() + radius_ > scene_.box.width) continue;
        scene_.balls.push_back(ball);
      }
    }
  }

  RandomNumbers random_;
  Scene scene_;
  int columns_ = 0;
  int rows_ = 0;
  bool hexagonal_ = false;
  double radius_ = 0;
};

}  // namespace

Scene lattice_scene(std::uint64_t seed) {
  return LatticeMaker(seed).take();
}

}  // namespace carom::test
