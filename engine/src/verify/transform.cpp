#include "verify/transform.hpp"

#include <numeric>
#include <utility>

#include "fill/random.hpp"

namespace carom::hard {

Scene listed(const Scene& scene) {
  Scene result = scene;
  result.balls = populate(scene);
  result.fills.clear();
  return result;
}

std::vector<Ball> scaled(std::vector<Ball> balls, double length, double time, double mass) {
  for (Ball& ball : balls) {
    ball.position *= length;
    ball.velocity *= length / time;
    ball.radius *= length;
    ball.mass *= mass;
    ball.spin /= time;
  }
  return balls;
}

Scene scaled(const Scene& scene, double length, double time, double mass) {
  Scene result = listed(scene);
  result.box.width *= length;
  result.box.height *= length;
  result.balls = scaled(std::move(result.balls), length, time, mass);
  if (result.effects.gravity) result.effects.gravity->acceleration *= length / time / time;
  if (result.effects.drag) result.effects.drag->rate /= time;
  result.solver.step *= time;
  result.duration *= time;
  result.frame_rate /= time;
  return result;
}

std::vector<Ball> mirrored(std::vector<Ball> balls, Mirror mirror) {
  const auto turn = [mirror](Vec2& v) {
    if (mirror == Mirror::x) v.x() = -v.x();
    if (mirror == Mirror::y) v.y() = -v.y();
    if (mirror == Mirror::diagonal) std::swap(v.x(), v.y());
  };
  for (Ball& ball : balls) {
    turn(ball.position);
    turn(ball.velocity);
    ball.spin = -ball.spin;
  }
  return balls;
}

Scene mirrored(const Scene& scene, Mirror mirror) {
  Scene result = listed(scene);
  result.balls = mirrored(std::move(result.balls), mirror);
  if (mirror == Mirror::diagonal) {
    std::swap(result.box.width, result.box.height);
    std::swap(result.box.periodic[0], result.box.periodic[1]);
  }
  if (result.effects.gravity) {
    Vec2& g = result.effects.gravity->acceleration;
    if (mirror == Mirror::x) g.x() = -g.x();
    if (mirror == Mirror::y) g.y() = -g.y();
    if (mirror == Mirror::diagonal) std::swap(g.x(), g.y());
  }
  return result;
}

Shuffle::Shuffle(std::size_t balls, std::uint64_t seed) : from_(balls) {
  std::iota(from_.begin(), from_.end(), std::size_t{0});
  scene::Random random(seed, 1);
  for (std::size_t i = balls; i > 1; --i) {
    const auto j = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
    std::swap(from_[i - 1], from_[j]);
  }
}

std::vector<Ball> Shuffle::there(const std::vector<Ball>& balls) const {
  std::vector<Ball> result;
  for (const std::size_t i : from_) result.push_back(balls[i]);
  return result;
}

std::vector<Ball> Shuffle::back(const std::vector<Ball>& balls) const {
  std::vector<Ball> result = balls;
  for (std::size_t k = 0; k < from_.size(); ++k) result[from_[k]] = balls[k];
  return result;
}

}  // namespace carom::hard
