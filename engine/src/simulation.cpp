#include "carom/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "carom/crew.hpp"
#include "carom/scene_file.hpp"
#include "carom/shorter_way.hpp"
#include "impact_record.hpp"
#include "scene/available.hpp"
#include "solvers/make_solver.hpp"
#include "state/domain.hpp"
#include "state/totals.hpp"

namespace carom {
namespace {

std::unique_ptr<Solver> make_checked(const Scene& scene, std::vector<Ball> balls) {
  const Method method = choose_method(scene).method;
  std::vector<Problem> problems = scene::find_unavailable(scene, method);
  if (!problems.empty()) {
    throw SceneError(scene.name.empty() ? "scene" : scene.name, std::move(problems));
  }
  return make_solver(scene, std::move(balls), method);
}

}  // namespace

class Simulation::Implementation {
 public:
  explicit Implementation(const Scene& scene) : Implementation(scene, populate(scene)) {}

  Implementation(const Scene& scene, std::vector<Ball> balls)
      : scene_(scene),
        method_(choose_method(scene).method),
        moving_(count_moving(balls)),
        solver_(make_checked(scene, std::move(balls))),
        // What starts with a thread for each ball keeps one for each ball.
        per_ball_(scene.played && !scene.workers &&
                  worker_count(scene, solver_->balls(), moving_) ==
                      std::max<std::size_t>(1, moving_)),
        time_(scene.continuation ? scene.continuation->time : 0),
        crew_(worker_count(scene, solver_->balls(), moving_), solver_->phases()),
        energy_initial_(solver_->energy()),
        energy_largest_(std::abs(energy_initial_)),
        dissipated_before_(solver_->dissipated()),
        momentum_initial_(solver_->momentum()),
        ids_(solver_->balls()),
        next_id_(solver_->balls()) {
    std::iota(ids_.begin(), ids_.end(), std::size_t{0});
    scene_.balls = std::vector<Ball>();
    scene_.fills.clear();
    scene_.script.clear();
    if (scene_.continuation) scene_.continuation->flights = std::vector<SavedFlight>();
    scene_.solver.method = method_;  // whatever the balls are that are left
    solver_->set_workers(crew_.workers());
  }

  void advance_to(double time) {
    const std::size_t first = solver_->aim(time);
    if (first != Phase::kFrameDone) crew_.do_frame(first);
    time_ = std::max(time_, time);
  }

  void obey(const command::Add& add) {
    check_room(add.ball);
    collect_impacts(true);
    solver_->add(add.ball);
    if (!add.ball.fixed) ++moving_;
    ids_.push_back(next_id_++);
    note({.kind = ImpactKind::add, .a = ids_.back(), .position = add.ball.position});
    fit_crew();
  }
  void obey(const command::Remove& remove) {
    const std::size_t n = solver_->balls();
    if (n == 0) throw CommandError("there is no ball to remove");
    const std::size_t ball = remove.ball.value_or(n - 1);
    if (ball >= n) {
      throw CommandError(fmt::format("there is no ball {} to remove: there are {}", ball, n));
    }
    collect_impacts(true);
    tell_slides(ball);
    const auto place = static_cast<std::ptrdiff_t>(ball);
    note({.kind = ImpactKind::remove, .a = ids_[ball], .position = position_of(ball)});
    if (!solver_->state()[ball].fixed) --moving_;
    solver_->remove(ball);
    ids_.erase(ids_.begin() + place);
    fit_crew();
  }
  void obey(const command::SetEffects& set) {
    for_each_effect([&](const auto& entry) {
      if (!(set.effects.*entry.slot) || scene_.effects.*entry.slot) return;
      throw CommandError(fmt::format(
          "{} cannot be set: the scene does not name it among its effects", entry.name));
    });
    check_inside(set.effects);
    solver_->set(set.effects);
    note({.kind = ImpactKind::set});
    assign(scene_.effects, set.effects);
  }
  void obey(const command::SetStep& set) {
    if (!(set.step > 0) || !std::isfinite(set.step)) {
      throw CommandError(fmt::format("a step must be greater than 0, got {}", set.step));
    }
    solver_->set_step(set.step);
    note({.kind = ImpactKind::set});
    scene_.solver.step = set.step;
  }
  template <class Other>
  void obey(const Other&) {
    throw std::logic_error("a command of the frame clock was given to the simulation");
  }

  void apply(const Command& command) {
    const double before = solver_->energy();
    std::visit([this](const auto& c) { obey(c); }, command);
    const double after = solver_->energy();
    energy_input_ += after - before;
    energy_largest_ = std::max({energy_largest_, std::abs(before), std::abs(after)});
  }

  double kinetic() const {
    const bool spins = scene_.effects.friction.has_value();
    double sum = 0;
    solver_->visit_state([&](const Ball& ball) { sum += kinetic_energy(ball, spins); });
    return sum;
  }

  Measurements measure() const {
    Measurements result;
    solver_->count(result);
    result.energy_initial = energy_initial_;
    result.energy_final = solver_->energy();
    if (scene_.effects.gravity || scene_.effects.attraction) result.kinetic_final = kinetic();
    result.energy_input = energy_input_;
    result.energy_dissipated = std::max(0.0, solver_->dissipated() - dissipated_before_);
    result.energy_largest = energy_largest_;
    result.momentum_initial = momentum_initial_;
    result.momentum_final = solver_->momentum();
    result.phases = crew_.seconds();
    const Crew::Effort effort = crew_.effort();
    result.computing = effort.computing;
    result.waiting = std::max(0.0, effort.frames - effort.computing);
    return result;
  }

  SceneStream save() const {
    SceneStream stream{
        scene_, [this](const SceneStream::Balls& visit) { solver_->visit_saved(visit); },
        [this](const SceneStream::Flights& visit) { solver_->visit_flights(visit); }};
    Scene& scene = stream.head;
    scene.continuation.emplace();
    scene.continuation->time = time_;
    scene.continuation->clock = time_;
    solver_->save(scene);
    return stream;
  }

  void record_impacts(bool wanted) {
    solver_->record_impacts(wanted);
    recording_ = wanted;
    record_ = ImpactRecord(record_.next_event());
  }
  std::vector<Impact> take_impacts(bool at_the_end) {
    collect_impacts(at_the_end);
    for (std::size_t i = 0; i < ids_.size() && at_the_end; ++i) tell_slides(i);
    return record_.take();
  }
  const std::vector<std::size_t>& ids() const { return ids_; }
  Bookkeeping bookkeeping() const {
    return {ids_, next_id_, record_.next_event(), energy_input_, solver_->losses()};
  }
  void go_on_from(const Bookkeeping& earlier) {
    ids_ = earlier.ids;
    next_id_ = earlier.next_id;
    record_ = ImpactRecord(earlier.next_event);
    solver_->go_on_from_losses(earlier.losses);
    dissipated_before_ = 0;
    energy_input_ = earlier.energy_input;
    energy_largest_ = 0;  // the energy at which it goes on is no new look
  }

  Crew& crew() { return crew_; }
  const Scene& scene() const { return scene_; }
  Method method() const { return method_; }
  const Solver& solver() const { return *solver_; }
  double time() const { return time_; }
  std::size_t workers() const { return crew_.workers(); }

 private:
  void fit_crew() {
    const std::size_t workers = per_ball_ ? std::max<std::size_t>(1, moving_)
                                          : worker_count(scene_, solver_->balls(), moving_);
    if (workers == crew_.workers()) return;
    crew_.resize(workers);
    solver_->set_workers(crew_.workers());
  }

  /// Before balls get other numbers.
  void collect_impacts(bool of_all) {
    if (!recording_) return;
    std::vector<Impact> impacts;
    solver_->take_impacts(impacts, of_all);
    record_.add(std::move(impacts), ids_);
  }
  /// Of a ball whose contacts end without an event.
  void tell_slides(std::size_t ball) {
    if (!recording_) return;
    std::vector<Impact> impacts;
    solver_->tell_slides(ball, impacts);
    record_.add(std::move(impacts), ids_);
  }
  void note(Impact command) {
    if (!recording_) return;
    collect_impacts(true);
    command.time = time_;
    record_.add(command);
  }
  Vec2 position_of(std::size_t ball) const {
    return recording_ ? solver_->state().at(ball).position : Vec2{0, 0};
  }

  /// Walls cannot come back around balls that have left.
  void check_inside(const Effects& change) const {
    if (!has_walls(change) || has_walls(scene_.effects)) return;
    const Domain domain(scene_.box, true);
    const std::vector<Ball> balls = solver_->state();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double x = balls[i].position[axis];
        if (!domain.solid(axis) || (x >= domain.lower[axis] && x <= domain.upper[axis])) continue;
        throw CommandError(fmt::format("walls stay off: ball {} is out of the box", i));
      }
    }
  }

  void check_room(const Ball& ball) const {
    if (!(ball.radius > 0) || !(ball.mass > 0) || !std::isfinite(ball.radius) ||
        !std::isfinite(ball.mass) || !ball.position.allFinite() || !ball.velocity.allFinite() ||
        !std::isfinite(ball.spin)) {
      throw CommandError("a ball needs a position, a velocity, a radius and a mass above 0");
    }
    const Domain domain(scene_.box, has_walls(scene_.effects));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double x = ball.position[axis];
      const bool outside =
          x < domain.lower[axis] + ball.radius || x > domain.upper[axis] - ball.radius;
      if (domain.solid(axis) && outside) {
        throw CommandError(fmt::format("a ball at ({}, {}) would stick out of the box",
                                       ball.position.x(), ball.position.y()));
      }
    }
    if (!has_collisions(scene_.effects)) return;
    const std::vector<Ball> balls = solver_->state();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      if (ball.fixed && balls[i].fixed) continue;
      const Vec2 r = shorter_way(balls[i].position - ball.position, scene_.box);
      const double reach = balls[i].radius + ball.radius;
      if (r.squaredNorm() < reach * reach) {
        throw CommandError(fmt::format("a ball at ({}, {}) would overlap ball {}",
                                       ball.position.x(), ball.position.y(), i));
      }
    }
  }

  Scene scene_;  // without balls and script
  Method method_;
  std::size_t moving_;  // balls that are not fixed
  std::unique_ptr<Solver> solver_;
  bool per_ball_;
  double time_;
  Crew crew_;
  double energy_initial_;
  double energy_largest_;
  double dissipated_before_;
  Vec2 momentum_initial_;
  double energy_input_ = 0;
  std::vector<std::size_t> ids_;  // of the balls, in their order
  std::size_t next_id_;
  bool recording_ = false;
  ImpactRecord record_;
};

Simulation::Simulation(const Scene& scene)
    : implementation_(std::make_unique<Implementation>(scene)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance_to(double time) {
  implementation_->advance_to(time);
}
void Simulation::apply(const Command& command) {
  implementation_->apply(command);
}
double Simulation::time() const {
  return implementation_->time();
}
std::size_t Simulation::balls() const {
  return implementation_->solver().balls();
}
std::size_t Simulation::workers() const {
  return implementation_->workers();
}
Method Simulation::method() const {
  return implementation_->method();
}
double Simulation::step() const {
  return implementation_->scene().solver.step;
}
const Effects& Simulation::effects() const {
  return implementation_->scene().effects;
}

Frame Simulation::frame() const {
  Frame frame;
  frame.time = time();
  frame.box = implementation_->scene().box;
  frame.walls = has_walls(implementation_->scene().effects);
  frame.balls.reserve(balls());
  visit_state([&frame](const Ball& ball) {
    frame.balls.push_back(
        {ball.position, ball.radius, ball.velocity.norm(), ball.fixed, ball.glyph});
  });
  return frame;
}

Measurements Simulation::measure() const {
  return implementation_->measure();
}
std::vector<Ball> Simulation::state() const {
  return implementation_->solver().state();
}
std::vector<ExactPosition> Simulation::exact_positions() const {
  return implementation_->solver().exact_positions();
}
std::string Simulation::state_hash() const {
  return implementation_->solver().state_hash();
}
void Simulation::visit_state(const std::function<void(const Ball&)>& visit) const {
  implementation_->solver().visit_state(visit);
}
Scene Simulation::save() const {
  return implementation_->save().collect();
}
SceneStream Simulation::save_stream() const {
  return implementation_->save();
}
const std::vector<std::size_t>& Simulation::ids() const {
  return implementation_->ids();
}
Bookkeeping Simulation::bookkeeping() const {
  return implementation_->bookkeeping();
}
void Simulation::go_on_from(const Bookkeeping& bookkeeping) {
  implementation_->go_on_from(bookkeeping);
}
void Simulation::record_impacts(bool wanted) {
  implementation_->record_impacts(wanted);
}
std::vector<Impact> Simulation::take_impacts(bool at_the_end) {
  return implementation_->take_impacts(at_the_end);
}
void Simulation::record_timeline(std::size_t frames) {
  implementation_->crew().record_timeline(frames);
}
Timeline Simulation::timeline(std::size_t frames) const {
  return implementation_->crew().timeline(frames);
}

}  // namespace carom
