#include "carom/simulation.hpp"

#include <stdexcept>

#include "carom/crew.hpp"

namespace carom {

class Simulation::Implementation {
 public:
  explicit Implementation(const Scene& scene)
      : scene_(scene),
        balls_(populate(scene)),
        crew_(worker_count(scene, balls_.size()), phases()) {}

  std::vector<Phase> phases() {
    return {{"wall_computation", [this](Share share) { fly(share); },
             [this] { return --steps_left_ > 0 ? std::size_t{0} : Phase::kFrameDone; }}};
  }

  void advance_to(double time) {
    const double due = (time / scene_.solver.step) * (1 + 0x1p-50);
    const auto target = static_cast<std::uint64_t>(due);
    steps_left_ = target - steps_;
    time_ = time;
    if (steps_left_ == 0) return;
    steps_ = target;
    crew_.do_frame();
  }

  void fly(Share share) {
    const Vec2 lower = scene_.box.lower();
    const Vec2 upper = scene_.box.upper();
    for (std::size_t i = share.begin(balls_.size()); i < share.end(balls_.size()); ++i) {
      Ball& ball = balls_[i];
      ball.position += ball.velocity * scene_.solver.step;
      for (int axis = 0; axis < 2; ++axis) {
        const double low = lower[axis] + ball.radius;
        const double high = upper[axis] - ball.radius;
        if (ball.position[axis] < low || ball.position[axis] > high) {
          ball.position[axis] = ball.position[axis] < low ? low : high;
          ball.velocity[axis] = -ball.velocity[axis];
        }
      }
    }
  }

  Scene scene_;
  std::vector<Ball> balls_;
  std::uint64_t steps_ = 0;
  std::uint64_t steps_left_ = 0;
  double time_ = 0;
  Crew crew_;
};

Simulation::Simulation(const Scene& scene)
    : implementation_(std::make_unique<Implementation>(scene)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance_to(double time) {
  implementation_->advance_to(time);
}
void Simulation::apply(const Command&) {
  throw std::logic_error("not yet");
}
double Simulation::time() const {
  return implementation_->time_;
}
std::size_t Simulation::balls() const {
  return implementation_->balls_.size();
}
std::size_t Simulation::workers() const {
  return implementation_->crew_.workers();
}
Method Simulation::method() const {
  return Method::overlap;
}
double Simulation::step() const {
  return implementation_->scene_.solver.step;
}

Frame Simulation::frame() const {
  Frame frame;
  frame.time = time();
  frame.box = implementation_->scene_.box;
  frame.walls = implementation_->scene_.effects.walls.has_value();
  for (const Ball& ball : implementation_->balls_) {
    frame.balls.push_back(
        {ball.position, ball.radius, ball.velocity.norm(), ball.fixed, ball.glyph});
  }
  return frame;
}

Measurements Simulation::measure() const {
  return {};
}
std::vector<Ball> Simulation::state() const {
  return implementation_->balls_;
}
std::string Simulation::state_hash() const {
  return "0";
}
Scene Simulation::save() const {
  return implementation_->scene_;
}

}  // namespace carom
