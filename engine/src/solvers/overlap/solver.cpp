#include "solvers/overlap/solver.hpp"

#include <algorithm>
#include <utility>

#include "effects/attraction.hpp"
#include "effects/energy.hpp"
#include "solvers/sampling.hpp"
#include "state/stopwatch.hpp"

namespace carom {

OverlapSolver::OverlapSolver(const Scene& scene, const std::vector<Ball>& balls, Pairs pairs)
    : box_(scene.box),
      domain_(scene.box, scene.effects.walls.has_value()),
      effects_(scene.effects),
      balls_(balls, scene.effects),
      plan_(scene.effects, balls.size(), worker_count(scene, balls.size(), count_moving(balls))),
      pairs_(balls_, domain_, pairs) {
  rules_.step = scene.solver.step;
  if (scene.continuation) {
    step_origin_ = scene.continuation->step_origin;
    steps_ = scene.continuation->steps;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] == 0) continue;
    for (double& x : balls_.position[axis]) x = domain_.wrapped(axis, x);
  }
  renew_rules();
  set_workers(1);
}

std::vector<Phase> OverlapSolver::phases() {
  std::vector<Phase> phases;
  phases.push_back({effects_.walls ? "wall_computation" : "flight",
                    [this](Share share) { fly(share); }, [this] { return after_flight(); }});
  const auto next = [&phases] { return phases.size(); };
  if (plan_.shared_search) {
    search_ = next();
    phases.push_back({"neighbour_search", [this](Share share) { pairs_.search(share); },
                      [this] { return detect_; }});
  }
  if (plan_.pairs) {
    detect_ = next();
    phases.push_back({"pair_computation", [this](Share share) { detect(share); },
                      [this] { return after_detection(); }});
  }
  if (plan_.shared_resolution) {
    resolve_ = next();
    phases.push_back({"pair_resolution", [this](Share share) { resolve(share); },
                      [this] { return rules_.contacts_last ? after_islands() : after_groups(); }});
  }
  if (plan_.attraction) {
    attract_ = next();
    phases.push_back(
        {"attraction", [this](Share share) { pull(share); }, [this] { return after_pull(); }});
  }
  return phases;
}

void OverlapSolver::set_workers(std::size_t workers) {
  // What has been counted stays counted.
  for (std::size_t k = workers; k < work_.size(); ++k) work_.front().inherit(work_[k]);
  work_.resize(workers);
  record_impacts(recording_);
  pairs_.set_workers(workers);
}

std::size_t OverlapSolver::aim(double time) {
  // Rounding of times and of their quotient must not lose a step.
  constexpr double kRounding = 0x1p-44;
  const double due = (time - step_origin_ + std::abs(time) * kRounding) / rules_.step;
  target_ = due > 0 ? static_cast<std::uint64_t>(due) : 0;
  if (target_ <= steps_) return Phase::kFrameDone;
  if (rules_.collides) pairs_.cache_all_pairs();
  if (rules_.contacts_last) {
    rounds_.find_asleep();
    if (contacts_.all_asleep()) {
      steps_ = target_;
      return Phase::kFrameDone;
    }
  }
  return attract_ && !pull_known_ ? *attract_ : kFly;
}

// --- the phases -------------------------------------------------------------------------------

void OverlapSolver::fly(Share share) {
  overlap::Work& work = work_[share.index];
  work.impacts.timed = timed();
  work.impacts.log.time = step_origin_ + static_cast<double>(steps_ + 1) * rules_.step;
  flight_.fly(share, timed(), recording_, work);
}

std::size_t OverlapSolver::after_flight() {
  if (!rules_.collides) return rules_.contacts_last ? form_islands() : after_impacts();
  std::vector<Bullet> bullets;
  for (const overlap::Work& work : work_) {
    bullets.insert(bullets.end(), work.bullets.begin(), work.bullets.end());
  }
  if (!bullets.empty()) missed_ += count_missed(balls_, domain_, rules_.step, std::move(bullets));
  if (!pairs_.uses_list() || !pairs_.is_stale()) return detect_;
  const Stopwatch stopwatch(timed(), work_.front().seconds.of<Collisions>());
  if (search_ && work_.size() > 1 && balls_.size() >= overlap::Plan::kSharedSearch) {
    pairs_.sort(rules_.step);
    return *search_;
  }
  pairs_.build(rules_.step);
  return detect_;
}

void OverlapSolver::detect(Share share) {
  overlap::Work& work = work_[share.index];
  const Stopwatch stopwatch(timed(), work.seconds.of<Collisions>());
  work.touching.clear();
  const double deepest = pairs_.find_touching(share, work.touching);
  // Where contacts last, overlaps count that are left at the end of the step.
  if (!rules_.contacts_last) work.deepest = std::max(work.deepest, deepest);
}

std::size_t OverlapSolver::after_detection() {
  const Stopwatch stopwatch(timed(), work_.front().seconds.of<Collisions>());
  touching_.clear();
  for (const overlap::Work& work : work_) {
    touching_.insert(touching_.end(), work.touching.begin(), work.touching.end());
  }
  // The order in which pairs were found depends on the list; the order they are resolved in must
  // not.
  if (!std::is_sorted(touching_.begin(), touching_.end())) {
    std::sort(touching_.begin(), touching_.end());
  }
  if (rules_.contacts_last) return form_islands();
  if (touching_.empty()) return after_impacts();
  group_rounds_.begin();
  return resolve_groups();
}

std::size_t OverlapSolver::resolve_groups() {
  for (overlap::Work& work : work_) work.impacts.push = 0;
  groups_.sort(touching_, balls_.size());
  const bool share_out = work_.size() > 1 && groups_.pairs() >= overlap::Plan::kSharedPairs &&
                         groups_.largest() * 2 < groups_.pairs();
  if (resolve_ && share_out) return *resolve_;
  for (std::size_t g = 0; g < groups_.count(); ++g) resolve_group(g, work_.front().impacts);
  return after_groups();
}

std::size_t OverlapSolver::after_groups() {
  double push = 0;
  for (const overlap::Work& work : work_) push = std::max(push, work.impacts.push);
  return group_rounds_.join(balls_.size(), push, touching_) ? resolve_groups() : after_impacts();
}

// Each ball is in one group: what a group loses is noted with its first.
void OverlapSolver::resolve_group(std::size_t group, effects::ImpactCount& count) {
  const std::span<const Pair> pairs = groups_.group(group);
  const double lost = resolver_.resolve(balls_, pairs, group_rounds_.joined(), count);
  if (!losses_.by_ball.empty()) losses_.by_ball[pairs.front().first] += lost;
}

std::size_t OverlapSolver::form_islands() {
  out_.clear();
  for (const overlap::Work& work : work_) {
    out_.insert(out_.end(), work.out.begin(), work.out.end());
  }
  if (!rules_.collides) touching_.clear();
  if (attract_) rules_.lasting.attraction = effects::strongest_pull(balls_);
  rounds_.form(touching_, out_);
  return resolve_islands();
}

std::size_t OverlapSolver::resolve_islands() {
  const bool share_out = work_.size() > 1 && contacts_.islands() > 1 &&
                         touching_.size() >= overlap::Plan::kSharedPairs;
  if (resolve_ && share_out) return *resolve_;
  for (std::size_t k = 0; k < contacts_.islands(); ++k) resolve_island(k, work_.front());
  return after_islands();
}

void OverlapSolver::resolve_island(std::size_t island, overlap::Work& work) {
  // Every few steps an island may be found to be at rest.
  constexpr std::uint64_t kAsked = 4;
  contacts_.resolve(island, balls_, rules_.sleeps && steps_ % kAsked == 0, work.island,
                    work.impacts.log);
}

std::size_t OverlapSolver::after_islands() {
  if (rounds_.join(touching_)) return resolve_islands();
  overlap::Work& work = work_.front();
  contacts_.settle(losses_.by_ball, work.lasting, work.impacts.log);
  return after_impacts();
}

void OverlapSolver::resolve(Share share) {
  overlap::Work& work = work_[share.index];
  const Stopwatch stopwatch(timed(), work.seconds.of<Collisions>());
  if (rules_.contacts_last) {
    for (std::size_t k = share.index; k < contacts_.islands(); k += share.count) {
      resolve_island(k, work);
    }
    return;
  }
  for (std::size_t g = share.begin(groups_.count()); g < share.end(groups_.count()); ++g) {
    resolve_group(g, work.impacts);
  }
}

std::size_t OverlapSolver::after_impacts() {
  if (!attract_) return end_step();
  in_step_ = true;
  return *attract_;
}

void OverlapSolver::pull(Share share) {
  const Stopwatch stopwatch(timed(), work_[share.index].seconds.of<Attraction>());
  const std::size_t begin = share.begin(balls_.size());
  const std::size_t end = share.end(balls_.size());
  effects::attract(balls_, domain_, *effects_.attraction, begin, end);
  if (in_step_) effects::kick(balls_, rules_.step / 2, begin, end);
}

std::size_t OverlapSolver::after_pull() {
  pull_known_ = true;
  return std::exchange(in_step_, false) ? end_step() : std::size_t{kFly};
}

std::size_t OverlapSolver::end_step() {
  ++taken_;
  return ++steps_ < target_ ? std::size_t{kFly} : Phase::kFrameDone;
}

bool OverlapSolver::timed() const {
  return is_sampled(taken_);
}

// --- commands ---------------------------------------------------------------------------------

void OverlapSolver::add(const Ball& ball) {
  std::vector<Ball> balls = balls_.to_vector();
  balls.push_back(ball);
  for (auto& turns : turns_) {
    if (!turns.empty()) turns.push_back(0);
  }
  renew_balls(balls);
}

void OverlapSolver::remove(std::size_t ball) {
  std::vector<Ball> balls = balls_.to_vector();
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(ball));
  losses_.remove(ball);
  for (auto& turns : turns_) {
    if (!turns.empty()) turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(ball));
  }
  renew_balls(balls);
}

void OverlapSolver::set(const Effects& effects) {
  assign(effects_, effects);
  pull_known_ = false;
  renew_rules();
}

void OverlapSolver::set_step(double step) {
  step_origin_ += static_cast<double>(steps_) * rules_.step;
  steps_ = 0;
  rules_.step = step;
  renew_rules();
}

void OverlapSolver::renew_balls(const std::vector<Ball>& balls) {
  balls_ = Balls(balls, effects_);
  pull_known_ = false;
  renew_rules();
}

void OverlapSolver::renew_rules() {
  if (effects_.walls) domain_ = Domain(box_, effects_.walls->on);
  rules_ = overlap::StepRules(effects_, balls_, rules_.step);
  // Contacts that last may hold energy where nothing else loses any.
  const bool loses = rules_.loses || rules_.contacts_last;
  if (loses || !losses_.by_ball.empty()) losses_.by_ball.resize(balls_.size(), 0.0);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double along = rules_.collision.acceleration[axis];
    if (along != 0 && domain_.period[axis] > 0) turns_[axis].resize(balls_.size(), 0);
  }
  pairs_.stretch(rules_.contacts_last ? 1 + contact::LastingContacts::kNear : 1);
  pairs_.forget();
  rounds_.forget();
}

// --- looking ----------------------------------------------------------------------------------

double OverlapSolver::energy() const {
  return effects::energy(balls_, effects_, domain_, turns_);
}

void OverlapSolver::count(Measurements& measurements) const {
  measurements.missed_hits += missed_;
  EffectSeconds seconds;
  for (const overlap::Work& work : work_) {
    measurements.ball_ball += work.impacts.ball_ball;
    measurements.ball_wall += work.impacts.ball_wall;
    measurements.missed_hits += work.impacts.missed;
    measurements.ball_ball += work.lasting.ball_ball;
    measurements.ball_wall += work.lasting.ball_wall;
    measurements.jammed += work.lasting.jammed;
    measurements.max_overlap =
        std::max({measurements.max_overlap, work.deepest, work.lasting.deepest});
    seconds += work.seconds;
    // Timed as a part of the impacts.
    seconds.of<Collisions>() -= work.impacts.friction_seconds;
    seconds.of<Friction>() += work.impacts.friction_seconds;
  }
  seconds *= scale_of_samples(taken_);
  add_seconds(effects_, seconds, measurements);
}

void OverlapSolver::record_impacts(bool wanted) {
  recording_ = wanted;
  for (overlap::Work& work : work_) work.impacts.log.wanted = wanted;
}

void OverlapSolver::take_impacts(std::vector<Impact>& impacts, bool /*of_all*/) {
  for (overlap::Work& work : work_) work.impacts.log.move_to(impacts);
}

void OverlapSolver::save(Scene& scene) const {
  scene.effects = effects_;
  scene.solver.step = rules_.step;
  scene.continuation->step_origin = step_origin_;
  scene.continuation->steps = steps_;
}

}  // namespace carom
