#include "view/reference_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "carom/scene_file.hpp"
#include "carom/shorter_way.hpp"

namespace carom {
namespace {

constexpr int kMoreDigits = 34;
constexpr double kShorter = 8;
constexpr double kPartOfRadius = 0.01;  // apart by so much, a run is no longer right

double smallest_radius(const std::vector<Ball>& balls) {
  double radius = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls) radius = std::min(radius, ball.radius);
  return radius;
}

/// The simulated time of what the run shows.
double moment_of(const Simulation& run) {
  if (run.method() != Method::overlap) return run.time();
  const auto stood = run.save().continuation;
  return stood ? stood->step_origin + static_cast<double>(stood->steps) * run.step() : run.time();
}

/// The scene as the run stands, for the exact method.
Scene exact_scene(const Session& session) {
  const Simulation& run = session.simulation();
  Scene scene = run.save();
  scene.balls = run.state();
  scene.continuation.reset();
  scene.script.clear();
  scene.per_ball = false;
  scene.workers = 1;
  scene.solver.method = Method::event;
  scene.solver.digits = 16;
  if (run.method() == Method::event) {
    if (scene.effects.attraction) {
      scene.solver.step = run.step() / kShorter;
    } else {
      scene.solver.digits = kMoreDigits;
    }
  }
  return scene;
}

std::string name_of(const Scene& scene) {
  return scene.effects.attraction ? fmt::format("event, step 1/{:.6g} s", 1 / scene.solver.step)
                                  : fmt::format("event, {} digits", scene.solver.digits);
}

}  // namespace

ReferenceRun::ReferenceRun(const Session& session)
    : box_(session.scene().box),
      begun_(moment_of(session.simulation())),
      balls_(session.simulation().balls()),
      energy_input_(session.simulation().measure().energy_input),
      name_(name_of(exact_scene(session))),
      simulation_(exact_scene(session)),
      radius_(smallest_radius(session.simulation().state())) {}

void ReferenceRun::follow(const Simulation& run) {
  simulation_.advance_to(std::max(simulation_.time(), moment_of(run) - begun_));
  const std::vector<Ball> here = run.state();
  const std::vector<Ball> there = simulation_.state();
  distance_ = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Vec2 way = shorter_way(here[i].position - there[i].position, box_);
    distance_ = std::max(distance_, way.norm());
  }
  span_ = moment_of(run) - begun_;
  if (!horizon_ && distance_ > kPartOfRadius * radius_) horizon_ = span_;
}

bool ReferenceRun::is_of(const Simulation& run) const {
  return run.balls() == balls_ && run.measure().energy_input == energy_input_;
}

}  // namespace carom
