#include "export/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace carom {
namespace {

/// In double quotes, as extended XYZ has them; a name is one line.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

}  // namespace

TrajectoryText::TrajectoryText(const Scene& scene)
    : box_(fmt::format("{} 0 0 0 {} 0 0 0", scene.box.width, scene.box.height)),
      tail_(fmt::format("scene={} seed={}", quoted(scene.name), scene.seed)),
      pbc_(fmt::format("{} {} F", scene.box.periodic[0] ? 'T' : 'F',
                       scene.box.periodic[1] ? 'T' : 'F')),
      lower_(scene.box.lower()),
      spins_(scene.effects.friction.has_value()) {}

std::string TrajectoryText::frame(const FrameRecord& record) const {
  double largest = 0;
  for (const Ball& ball : record.balls) largest = std::max(largest, ball.radius);
  const double depth = largest > 0 ? 2 * largest : 1;  // a cell has a volume
  std::string text = fmt::format(
      "{}\nLattice=\"{} {}\" Origin=\"{} {} {}\" pbc=\"{}\" "
      "Properties=species:S:1:pos:R:3:id:I:1:radius:R:1:mass:R:1:velo:R:3{} "
      "Time={} frame={} {} state_hash=\"{}\"\n",
      record.balls.size(), box_, depth, lower_.x(), lower_.y(), -depth / 2, pbc_,
      spins_ ? ":spin:R:1" : "", record.time, record.frame, tail_, record.state_hash);
  for (std::size_t i = 0; i < record.balls.size(); ++i) {
    const Ball& ball = record.balls[i];
    const Vec2 velocity = ball.fixed ? Vec2{0, 0} : ball.velocity;
    fmt::format_to(std::back_inserter(text), "{} {} {} 0 {} {} {} {} {} 0", ball.fixed ? 'X' : 'o',
                   ball.position.x(), ball.position.y(), record.ids[i], ball.radius, ball.mass,
                   velocity.x(), velocity.y());
    if (spins_) fmt::format_to(std::back_inserter(text), " {}", ball.fixed ? 0 : ball.spin);
    text += '\n';
  }
  return text;
}

}  // namespace carom
