#include "solvers/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/skin.hpp"
#include "contact/touching.hpp"
#include "effects/attraction.hpp"
#include "effects/drag.hpp"
#include "effects/energy.hpp"
#include "effects/friction.hpp"
#include "effects/gravity.hpp"
#include "effects/periodic.hpp"
#include "effects/walls.hpp"
#include "solvers/sampling.hpp"
#include "state/stopwatch.hpp"

namespace carom {
OverlapSolver::OverlapSolver(const Scene& scene, const std::vector<Ball>& balls, Pairs pairs)
    : box_(scene.box),
      domain_(scene.box, scene.effects.walls.has_value()),
      effects_(scene.effects),
      balls_(balls, scene.effects),
      choice_(pairs),
      plan_(scene.effects, balls.size(), worker_count(scene, balls.size(), count_moving(balls))),
      step_(scene.solver.step) {
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
    phases.push_back(
        {"neighbour_search", [this](Share share) { search(share); }, [this] { return detect_; }});
  }
  if (plan_.pairs) {
    detect_ = next();
    phases.push_back({"pair_computation", [this](Share share) { detect(share); },
                      [this] { return after_detection(); }});
  }
  if (plan_.shared_resolution) {
    resolve_ = next();
    phases.push_back({"pair_resolution", [this](Share share) { resolve(share); },
                      [this] { return lasting_ ? after_islands() : after_impacts(); }});
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
  for (std::size_t k = workers; k < desks_.size(); ++k) {
    Desk& heir = desks_.front();
    const Desk& desk = desks_[k];
    heir.impacts.ball_ball += desk.impacts.ball_ball;
    heir.impacts.ball_wall += desk.impacts.ball_wall;
    heir.deepest = std::max(heir.deepest, desk.deepest);
    heir.impacts.friction_seconds += desk.impacts.friction_seconds;
    heir.lasting.ball_ball += desk.lasting.ball_ball;
    heir.lasting.ball_wall += desk.lasting.ball_wall;
    heir.lasting.deepest = std::max(heir.lasting.deepest, desk.lasting.deepest);
    heir.seconds += desk.seconds;
    desks_[k].impacts.log.move_to(heir.impacts.log.impacts);
  }
  desks_.resize(workers);
  record_impacts(recording_);
  forget_pairs();
}

std::size_t OverlapSolver::aim(double time) {
  // Rounding of times and of their quotient must not lose a step.
  constexpr double kRounding = 0x1p-44;
  const double due = (time - step_origin_ + std::abs(time) * kRounding) / step_;
  target_ = due > 0 ? static_cast<std::uint64_t>(due) : 0;
  if (target_ <= steps_) return Phase::kFrameDone;
  if (collides() && !many() && all_pairs_.count == 0) all_pairs_ = all_pairs(balls_);
  if (lasting_) {
    if (!std::exchange(know_asleep_, true)) contacts_.find_asleep(balls_, near_pairs());
    if (contacts_.all_asleep() && !attract_) {
      steps_ = target_;
      return Phase::kFrameDone;
    }
  }
  return attract_ && !pull_known_ ? *attract_ : kFly;
}

// --- the phases -------------------------------------------------------------------------------

void OverlapSolver::fly(Share share) {
  Desk& desk = desks_[share.index];
  std::vector<double>& lost = losses_.by_ball;
  desk.moved_square = 0;
  desk.impacts.timed = timed();
  desk.impacts.log.time = step_origin_ + static_cast<double>(steps_ + 1) * step_;
  const std::size_t begin = share.begin(balls_.size());
  const std::size_t end = share.end(balls_.size());
  if (attract_) {
    const Stopwatch stopwatch(timed(), desk.seconds.of<Attraction>());
    effects::kick(balls_, step_ / 2, begin, end);
  }
  desk.bullets.clear();
  desk.out.clear();
  if (lasting_) contacts_.begin(balls_, begin, end);
  if (collides()) find_bullets(balls_, begin, end, step_, smallest_radius_, desk.bullets);
  for (std::size_t i = begin; i < end; i += Flight::kBlock) {
    const std::size_t block_end = std::min(i + Flight::kBlock, end);
    if (rule_.wall_friction > 0 && !lasting_) {
      effects::Struck struck;
      fly(i, block_end, desk, &struck);
      const Stopwatch stopwatch(timed(), desk.seconds.of<Friction>());
      effects::FrictionBlock by_friction;
      effects::apply_wall_frictions(balls_, i, block_end - i, struck, rule_.wall_friction, &lost[i],
                                    recording_ ? &by_friction : nullptr);
      if (recording_) note_walls(i, &by_friction, desk);
    } else {
      std::array<double, Flight::kBlock> before{};
      const bool keeps = lasting_ && drag_rate_ > 0;
      if (keeps)
        std::copy_n(lost.begin() + static_cast<std::ptrdiff_t>(i), block_end - i, before.begin());
      fly(i, block_end, desk, nullptr);
      if (recording_) note_walls(i, nullptr, desk);
      // Who is asleep does not move: drag takes nothing.
      for (std::size_t k = i; keeps && k < block_end; ++k) {
        if (contacts_.asleep(k)) lost[k] = before[k - i];
      }
    }
    if (lasting_) contacts_.end(balls_, i, block_end, desk.out);
    if (listed_) note_moves(i, block_end, desk);
  }
}

void OverlapSolver::fly(std::size_t begin, std::size_t end, Desk& desk, effects::Struck* struck) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Glide& glide = glide_[axis];
    Flight flight;
    prepare(flight, balls_, axis, begin, end, step_, glide);
    if (!losses_.by_ball.empty()) flight.lost = losses_.by_ball.data() + begin;
    if (drag_rate_ > 0) {
      const Stopwatch stopwatch(timed(), desk.seconds.of<Drag>());
      effects::drag(flight);
    } else {
      straight(flight);
    }
    if (glide.gain != 0) {
      const Stopwatch stopwatch(timed(), desk.seconds.of<Gravity>());
      effects::gravity(flight);
    }
    land(flight);
    if (domain_.solid(axis)) {
      if (lasting_) {
        store(flight, balls_);
        continue;
      }
      const Stopwatch stopwatch(timed(), desk.seconds.of<Walls>());
      desk.impacts.ball_wall +=
          effects::walls(flight, domain_, wall_rule_[axis],
                         struck == nullptr ? nullptr : struck->normal[axis].data(),
                         recording_ ? &desk.met[axis] : nullptr);
    } else if (domain_.period[axis] > 0) {
      effects::wrap(flight, domain_, turns_[axis].empty() ? nullptr : turns_[axis].data());
    }
    store(flight, balls_);
  }
}

void OverlapSolver::note_walls(std::size_t begin, const effects::FrictionBlock* by_friction,
                               Desk& desk) const {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const effects::WallImpact& met : desk.met[axis]) {
      const std::size_t i = begin + met.k;
      effects::Member ball;
      ball.ball = static_cast<std::uint32_t>(i);
      ball.position = balls_.at(i);
      ball.radius = balls_.radius[i];
      ball.mass = balls_.mass[i];
      effects::note_wall(met, axis, ball,
                         by_friction == nullptr ? FrictionChange{} : (*by_friction)[axis][met.k],
                         desk.impacts.log);
    }
    desk.met[axis].clear();
  }
}

void OverlapSolver::note_moves(std::size_t begin, std::size_t end, Desk& desk) const {
  const Stopwatch stopwatch(timed(), desk.seconds.of<Collisions>());
  // In lanes and without branches: which way a ball has gone cannot be foreseen.
  constexpr std::size_t kLanes = 8;
  alignas(64) std::array<double, Flight::kBlock> square{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double* now = balls_.position[axis].data() + begin;
    const double* from = anchor_[axis].data() + begin;
    const double period = domain_.period[axis];
    for (std::size_t k = 0; k < end - begin; ++k) {
      const double d = std::abs(now[k] - from[k]);
      // A ball that has gone round comes back by one period; there is none where it is 0.
      const double other = std::abs(d - period);
      const double moved = other < d ? other : d;
      square[k] += moved * moved;
    }
  }
  std::array<double, kLanes> farthest{};
  for (std::size_t k = 0; k < square.size(); k += kLanes) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      farthest[l] = square[k + l] > farthest[l] ? square[k + l] : farthest[l];
    }
  }
  for (const double lane : farthest) desk.moved_square = std::max(desk.moved_square, lane);
}

void OverlapSolver::count_missed_hits() {
  for (const Desk& desk : desks_) {
    if (!desk.bullets.empty()) missed_ += count_missed(balls_, domain_, step_, desk.bullets);
  }
}

std::size_t OverlapSolver::after_flight() {
  if (!collides()) return lasting_ ? form_islands() : after_impacts();
  count_missed_hits();
  if (!many() || !list_is_stale()) return detect_;
  const Stopwatch stopwatch(timed(), desks_.front().seconds.of<Collisions>());
  if (search_ && desks_.size() > 1 && balls_.size() >= OverlapPlan::kSharedSearch) {
    build_grid();
    return *search_;
  }
  build_list();
  return detect_;
}

void OverlapSolver::search(Share share) {
  PairList& pairs = desks_[share.index].neighbours;
  pairs.clear();
  grid_.neighbours(domain_, share.begin(grid_.cells()), share.end(grid_.cells()), skin_ + near_,
                   pairs);
}

void OverlapSolver::detect(Share share) {
  Desk& desk = desks_[share.index];
  const Stopwatch stopwatch(timed(), desk.seconds.of<Collisions>());
  desk.touching.clear();
  const bool listed = many();
  const PairList& pairs = listed ? desk.neighbours : all_pairs_;
  const std::size_t begin = listed ? 0 : share.begin(pairs.count);
  const std::size_t end = listed ? pairs.count : share.end(pairs.count);
  const double deepest =
      find_touching(pairs, begin, end, balls_, domain_.period, stretch_, desk.touching);
  if (!lasting_) desk.deepest = std::max(desk.deepest, deepest);
}

std::size_t OverlapSolver::after_detection() {
  const Stopwatch stopwatch(timed(), desks_.front().seconds.of<Collisions>());
  touching_.clear();
  for (const Desk& desk : desks_) {
    touching_.insert(touching_.end(), desk.touching.begin(), desk.touching.end());
  }
  if (touching_.empty() && !lasting_) return after_impacts();
  // The order in which pairs were found depends on the list; the order they are resolved in must
  // not.
  if (!std::is_sorted(touching_.begin(), touching_.end())) {
    std::sort(touching_.begin(), touching_.end());
  }
  if (lasting_) return form_islands();
  groups_.sort(touching_, balls_.size());
  const bool share_out = desks_.size() > 1 && groups_.pairs() >= OverlapPlan::kSharedPairs &&
                         groups_.largest() * 2 < groups_.pairs();
  if (resolve_ && share_out) return *resolve_;
  for (std::size_t g = 0; g < groups_.count(); ++g) {
    resolve_group(g, desks_.front().impacts);
  }
  return after_impacts();
}

std::size_t OverlapSolver::form_islands() {
  out_.clear();
  for (const Desk& desk : desks_) out_.insert(out_.end(), desk.out.begin(), desk.out.end());
  if (!collides()) touching_.clear();
  rounds_ = 0;
  contacts_.form(balls_, touching_, out_);
  return resolve_islands();
}

std::size_t OverlapSolver::resolve_islands() {
  const bool share_out =
      desks_.size() > 1 && contacts_.islands() > 1 && touching_.size() >= OverlapPlan::kSharedPairs;
  if (resolve_ && share_out) return *resolve_;
  for (std::size_t k = 0; k < contacts_.islands(); ++k) resolve_island(k, desks_.front());
  return after_islands();
}

void OverlapSolver::resolve_island(std::size_t island, Desk& desk) {
  // Every few steps an island may be found to be at rest.
  constexpr std::uint64_t kAsked = 4;
  contacts_.resolve(island, balls_, !attract_ && steps_ % kAsked == 0, desk.island,
                    desk.impacts.log);
}

std::size_t OverlapSolver::after_islands() {
  if (join_islands()) return resolve_islands();
  Desk& desk = desks_.front();
  contacts_.settle(loses() ? std::span<double>(losses_.by_ball) : std::span<double>(), desk.lasting,
                   desk.impacts.log);
  return after_impacts();
}

// Where a solution brings balls together that it has not looked at, all are solved again with
// them: first those alone, then, rather than follow a push from ball to ball, all that are near.
bool OverlapSolver::join_islands() {
  constexpr int kRounds = 6;
  constexpr int kRoundsAlone = 2;
  if (contacts_.islands() == 0 || rounds_ >= kRounds) return false;
  std::vector<Pair> crossing;
  if (collides()) {
    contacts_.find_crossing(balls_, touching_, crossing);
    find_far_overlaps(crossing);
  }
  if (crossing.empty() && !contacts_.any_driven()) return false;
  contacts_.join(balls_, touching_, crossing, rounds_ >= kRoundsAlone);
  ++rounds_;
  return true;
}

// Balls that were pushed far may have come to others that were not near.
void OverlapSolver::find_far_overlaps(std::vector<Pair>& fresh) {
  const double slack = 2 * contact::LastingContacts::kNear * smallest_radius_;
  if (!(2 * contacts_.farthest_push() >= slack)) return;
  std::vector<Pair> found;
  const auto look = [&](const PairList& pairs) {
    find_touching(pairs, 0, pairs.count, balls_, domain_.period, 1, found);
  };
  if (!many()) {
    look(all_pairs_);
  } else {
    // The list has been looked at since the flight, not since the pushes.
    for (std::size_t i = 0; i < balls_.size(); i += Flight::kBlock) {
      note_moves(i, std::min(i + Flight::kBlock, balls_.size()), desks_.front());
    }
    if (list_is_stale()) build_list();
    for (const Desk& desk : desks_) look(desk.neighbours);
  }
  std::sort(found.begin(), found.end());
  const std::size_t crossing = fresh.size();
  std::set_difference(found.begin(), found.end(), touching_.begin(), touching_.end(),
                      std::back_inserter(fresh));
  touching_.insert(touching_.end(), fresh.begin() + static_cast<std::ptrdiff_t>(crossing),
                   fresh.end());
  std::sort(touching_.begin(), touching_.end());
}

std::vector<Pair> OverlapSolver::near_pairs() {
  std::vector<Pair> near;
  if (!collides()) return near;
  const auto look = [&](const PairList& pairs) {
    find_touching(pairs, 0, pairs.count, balls_, domain_.period, stretch_, near);
  };
  if (!many()) {
    look(all_pairs_);
  } else {
    build_list();
    for (const Desk& desk : desks_) look(desk.neighbours);
  }
  std::sort(near.begin(), near.end());
  return near;
}

void OverlapSolver::resolve(Share share) {
  Desk& desk = desks_[share.index];
  const Stopwatch stopwatch(timed(), desk.seconds.of<Collisions>());
  if (lasting_) {
    for (std::size_t k = share.index; k < contacts_.islands(); k += share.count) {
      resolve_island(k, desk);
    }
    return;
  }
  for (std::size_t g = share.begin(groups_.count()); g < share.end(groups_.count()); ++g) {
    resolve_group(g, desk.impacts);
  }
}

// Each ball is in one group: what a group loses is noted with its first.
void OverlapSolver::resolve_group(std::size_t group, effects::ImpactCount& count) {
  const std::span<const Pair> pairs = groups_.group(group);
  const double lost = resolver_.resolve(balls_, pairs, count);
  if (!losses_.by_ball.empty()) losses_.by_ball[pairs.front().first] += lost;
}

std::size_t OverlapSolver::after_impacts() {
  if (!attract_) return end_step();
  in_step_ = true;
  return *attract_;
}

void OverlapSolver::pull(Share share) {
  const Stopwatch stopwatch(timed(), desks_[share.index].seconds.of<Attraction>());
  const std::size_t begin = share.begin(balls_.size());
  const std::size_t end = share.end(balls_.size());
  effects::attract(balls_, domain_, *effects_.attraction, begin, end);
  if (in_step_) effects::kick(balls_, step_ / 2, begin, end);
}

std::size_t OverlapSolver::after_pull() {
  pull_known_ = true;
  return std::exchange(in_step_, false) ? end_step() : std::size_t{kFly};
}

std::size_t OverlapSolver::end_step() {
  ++taken_;
  return ++steps_ < target_ ? std::size_t{kFly} : Phase::kFrameDone;
}

// --- pairs ------------------------------------------------------------------------------------

bool OverlapSolver::timed() const {
  return is_sampled(taken_);
}

bool OverlapSolver::many() const {
  return choice_ == Pairs::neighbours ||
         (choice_ == Pairs::automatic && balls_.size() >= OverlapPlan::kManyBalls);
}

bool OverlapSolver::list_is_stale() const {
  if (!listed_) return true;
  // Two balls that were farther apart than reach and skin, and have each moved less than half the
  // skin, do not touch.  The rest of the half is for rounding.
  const double allowed = 0.49 * skin_;
  return std::any_of(desks_.begin(), desks_.end(), [allowed](const Desk& desk) {
    return !(desk.moved_square < allowed * allowed);
  });
}

void OverlapSolver::build_grid() {
  const Skin skin = choose_skin(balls_, domain_, step_);
  skin_ = skin.thickness;
  near_ = (stretch_ - 1) * (skin.reach - skin.thickness);
  grid_.sort(balls_, domain_, skin.reach + near_);
  anchor_ = balls_.position;
  listed_ = true;
}

void OverlapSolver::build_list() {
  build_grid();
  for (std::size_t w = 0; w < desks_.size(); ++w) search({w, desks_.size()});
}

void OverlapSolver::forget_pairs() {
  listed_ = false;
  all_pairs_.clear();
}

// --- commands ---------------------------------------------------------------------------------

void OverlapSolver::add(const Ball& ball) {
  std::vector<Ball> balls = balls_.to_vector();
  balls.push_back(ball);
  balls_ = Balls(balls, effects_);
  pull_known_ = false;
  for (auto& turns : turns_) {
    if (!turns.empty()) turns.push_back(0);
  }
  renew_rules();
}

void OverlapSolver::remove(std::size_t ball) {
  std::vector<Ball> balls = balls_.to_vector();
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(ball));
  balls_ = Balls(balls, effects_);
  losses_.remove(ball);
  pull_known_ = false;
  for (auto& turns : turns_) {
    if (!turns.empty()) turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(ball));
  }
  renew_rules();
}

void OverlapSolver::set(const Effects& effects) {
  assign(effects_, effects);
  pull_known_ = false;
  renew_rules();
}

void OverlapSolver::set_step(double step) {
  step_origin_ += static_cast<double>(steps_) * step_;
  steps_ = 0;
  step_ = step;
  renew_rules();
}

void OverlapSolver::renew_rules() {
  const Vec2 acceleration = effects_.gravity ? effects_.gravity->acceleration : Vec2{0, 0};
  drag_rate_ = effects_.drag ? effects_.drag->rate : 0;
  rule_.acceleration = acceleration;
  rule_.step = step_;
  if (effects_.collisions) {
    rule_.restitution = effects_.collisions->restitution;
  }
  if (effects_.walls) {
    rule_.wall_restitution = effects_.walls->restitution;
    domain_ = Domain(box_, effects_.walls->on);
  }
  if (effects_.friction) {
    rule_.friction = effects_.friction->balls;
    rule_.wall_friction = effects_.friction->walls;
  }
  if (loses() || !losses_.by_ball.empty()) losses_.by_ball.resize(balls_.size(), 0.0);
  forget_pairs();
  smallest_radius_ = std::numeric_limits<double>::infinity();
  for (const double radius : balls_.radius) smallest_radius_ = std::min(smallest_radius_, radius);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double along = acceleration[axis];
    wall_rule_[axis] = {rule_.wall_restitution, along, drag_rate_};
    glide_[axis] = Glide{step_};
    if (drag_rate_ > 0) {
      glide_[axis] = effects::slowed(drag_rate_, step_, along);
    } else if (along != 0) {
      glide_[axis] = effects::fall(along, step_);
    }
    if (along != 0 && domain_.period[axis] > 0) turns_[axis].resize(balls_.size(), 0);
  }
  lasting_ = contact::contacts_last(effects_, balls_);
  stretch_ = lasting_ ? 1 + contact::LastingContacts::kNear : 1;
  lasting_rule_ = {step_,
                   acceleration,
                   {glide_[0].fall, glide_[1].fall},
                   {glide_[0].gain, glide_[1].gain},
                   rule_.restitution,
                   rule_.wall_restitution,
                   rule_.friction,
                   rule_.wall_friction,
                   loses_energy(effects_) ? 2 * acceleration.norm() * step_ : 0,
                   std::sqrt(glide_[0].keep),
                   !loses()};
  know_asleep_ = false;
}

bool OverlapSolver::loses() const {
  return loses_energy(effects_) || drag_rate_ > 0 || effects_.friction;
}

// --- looking ----------------------------------------------------------------------------------

double OverlapSolver::energy() const {
  return effects::energy(balls_, effects_, domain_, turns_);
}

void OverlapSolver::count(Measurements& measurements) const {
  measurements.missed_hits += missed_;
  EffectSeconds seconds;
  for (const Desk& desk : desks_) {
    measurements.ball_ball += desk.impacts.ball_ball;
    measurements.ball_wall += desk.impacts.ball_wall;
    measurements.ball_ball += desk.lasting.ball_ball;
    measurements.ball_wall += desk.lasting.ball_wall;
    measurements.max_overlap =
        std::max({measurements.max_overlap, desk.deepest, desk.lasting.deepest});
    seconds += desk.seconds;
    // Timed as a part of the impacts.
    seconds.of<Collisions>() -= desk.impacts.friction_seconds;
    seconds.of<Friction>() += desk.impacts.friction_seconds;
  }
  seconds *= scale_of_samples(taken_);
  add_seconds(effects_, seconds, measurements);
}

void OverlapSolver::record_impacts(bool wanted) {
  recording_ = wanted;
  for (Desk& desk : desks_) desk.impacts.log.wanted = wanted;
}

void OverlapSolver::take_impacts(std::vector<Impact>& impacts, bool /*of_all*/) {
  for (Desk& desk : desks_) desk.impacts.log.move_to(impacts);
}

void OverlapSolver::save(Scene& scene) const {
  scene.effects = effects_;
  scene.solver.step = step_;
  scene.continuation->step_origin = step_origin_;
  scene.continuation->steps = steps_;
}

}  // namespace carom
