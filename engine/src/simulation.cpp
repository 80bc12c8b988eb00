#include "carom/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "carom/crew.hpp"
#include "carom/scene_file.hpp"
#include "scene/available.hpp"
#include "simulation_account.hpp"
#include "simulation_checks.hpp"
#include "simulation_record.hpp"
#include "solvers/make_solver.hpp"
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
        account_(*solver_),
        record_(*solver_) {
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
    check_room(add.ball, scene_, *solver_);
    record_.before_change();
    solver_->add(add.ball);
    if (!add.ball.fixed) ++moving_;
    record_.added(add.ball.position, time_);
    fit_crew();
  }
  void obey(const command::Remove& remove) {
    const std::size_t n = solver_->balls();
    if (n == 0) throw CommandError("there is no ball to remove");
    const std::size_t ball = remove.ball.value_or(n - 1);
    if (ball >= n) {
      throw CommandError(fmt::format("there is no ball {} to remove: there are {}", ball, n));
    }
    record_.removes(ball, time_);
    if (!solver_->state()[ball].fixed) --moving_;
    solver_->remove(ball);
    fit_crew();
  }
  void obey(const command::SetEffects& set) {
    for_each_effect([&](const auto& entry) {
      if (!(set.effects.*entry.slot) || scene_.effects.*entry.slot) return;
      throw CommandError(fmt::format(
          "{} cannot be set: the scene does not name it among its effects", entry.name));
    });
    check_inside(set.effects, scene_, *solver_);
    solver_->set(set.effects);
    record_.note(ImpactKind::set, time_);
    assign(scene_.effects, set.effects);
  }
  void obey(const command::SetStep& set) {
    if (!(set.step > 0) || !std::isfinite(set.step)) {
      throw CommandError(fmt::format("a step must be greater than 0, got {}", set.step));
    }
    solver_->set_step(set.step);
    record_.note(ImpactKind::set, time_);
    scene_.solver.step = set.step;
  }
  template <class Other>
  void obey(const Other&) {
    throw std::logic_error("a command of the frame clock was given to the simulation");
  }

  void apply(const Command& command) {
    const double before = solver_->energy();
    std::visit([this](const auto& c) { obey(c); }, command);
    account_.command(before, solver_->energy());
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
    account_.measure(*solver_, result);
    if (scene_.effects.gravity || scene_.effects.attraction) result.kinetic_final = kinetic();
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

  SimulationRecord& record() { return record_; }
  const SimulationRecord& record() const { return record_; }
  Bookkeeping bookkeeping() const {
    Bookkeeping result;
    record_.save(result);
    result.energy_input = account_.input();
    result.losses = solver_->losses();
    return result;
  }
  void go_on_from(const Bookkeeping& earlier) {
    record_.go_on_from(earlier);
    solver_->go_on_from_losses(earlier.losses);
    account_.go_on_from(earlier.energy_input);
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

  Scene scene_;  // without balls and script
  Method method_;
  std::size_t moving_;  // balls that are not fixed
  std::unique_ptr<Solver> solver_;
  bool per_ball_;
  double time_;
  Crew crew_;
  SimulationAccount account_;
  SimulationRecord record_;
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
  return implementation_->record().ids();
}
Bookkeeping Simulation::bookkeeping() const {
  return implementation_->bookkeeping();
}
void Simulation::go_on_from(const Bookkeeping& bookkeeping) {
  implementation_->go_on_from(bookkeeping);
}
void Simulation::record_impacts(bool wanted) {
  implementation_->record().record(wanted);
}
std::vector<Impact> Simulation::take_impacts(bool at_the_end) {
  return implementation_->record().take(at_the_end);
}
void Simulation::record_timeline(std::size_t frames) {
  implementation_->crew().record_timeline(frames);
}
Timeline Simulation::timeline(std::size_t frames) const {
  return implementation_->crew().timeline(frames);
}

}  // namespace carom
