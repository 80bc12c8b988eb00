#include "solvers/integrated/integrated_solver.hpp"

#include <algorithm>
#include <cmath>

#include "contact/impulse.hpp"
#include "effects/attraction.hpp"
#include "effects/drag.hpp"
#include "effects/gravity.hpp"
#include "effects/rest.hpp"
#include "solvers/sampling.hpp"
#include "state/stopwatch.hpp"

namespace carom {
namespace {

LineOfCentres line_between(const effects::Member& a, const effects::Member& b,
                           const Domain& domain) {
  Vec2 r = b.position - a.position;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const double period = domain.period[static_cast<std::size_t>(k)];
    if (period > 0) r[k] = nearest_image(r[k], period);
  }
  return line_of_centres(r, b.velocity - a.velocity);
}

}  // namespace

IntegratedSolver::IntegratedSolver(const Scene& scene, const std::vector<Ball>& balls)
    : box_(scene.box),
      domain_(scene.box, has_walls(scene.effects)),
      effects_(scene.effects),
      step_(scene.solver.step),
      finds_(1) {
  state_.balls = Balls(balls, scene.effects);
  if (scene.continuation) {
    step_origin_ = scene.continuation->step_origin;
    steps_ = scene.continuation->steps;
    time_ = scene.continuation->time;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] == 0) continue;
    for (double& x : state_.balls.position[axis]) x = domain_.wrapped(axis, x);
  }
  renew_rules();
  if (scene.continuation) look_ahead();
}

// A saved run goes on from its last whole step, and shows what it showed.
void IntegratedSolver::look_ahead() {
  std::size_t phase = aim(time_);
  while (phase != Phase::kFrameDone) {
    if (phase == kFly) {
      fly({});
      phase = after_stage();
    } else {
      search({});
      phase = after_search();
    }
  }
}

std::vector<Phase> IntegratedSolver::phases() {
  std::vector<Phase> phases;
  phases.push_back(
      {"attraction", [this](Share share) { fly(share); }, [this] { return after_stage(); }});
  if (effects_.collisions || effects_.walls) {
    phases.push_back({effects_.collisions ? "pair_computation" : "wall_computation",
                      [this](Share share) { search(share); }, [this] { return after_search(); }});
  }
  return phases;
}

std::size_t IntegratedSolver::aim(double time) {
  // Rounding of times and of their quotient must not lose a step, nor make one of next to nothing.
  constexpr double kRounding = 0x1p-44;
  time_ = time;
  if (whole_) {
    state_ = std::move(*whole_);
    whole_.reset();
  }
  const double rounding = std::abs(time) * kRounding;
  const double due = (time - step_origin_ + rounding) / step_;
  target_ = std::max(steps_, due > 0 ? static_cast<std::uint64_t>(due) : 0);
  extra_ = time - (step_origin_ + static_cast<double>(target_) * step_);
  if (extra_ <= rounding) extra_ = 0;
  if (steps_ < target_) return begin_step(step_);
  if (extra_ == 0) return Phase::kFrameDone;
  whole_ = state_;
  return begin_step(extra_);
}

bool IntegratedSolver::timed() const {
  return is_sampled(taken_);
}

bool IntegratedSolver::meets_anything() const {
  return collides() || domain_.solid(0) || domain_.solid(1);
}

// --- steps and pieces -------------------------------------------------------------------------

std::size_t IntegratedSolver::begin_step(double length) {
  const double part = step_ / Splitting::kInAStep;
  parts_ = Splitting::kInAStep;
  tail_ = 0;
  if (length < step_) {
    parts_ = static_cast<std::size_t>(length / part);
    tail_ = length - static_cast<double>(parts_) * part;
  }
  resting_.clear();
  struck_.clear();
  if (state_.pull_known) {
    find_resting();
    return next_part();
  }
  stage_ = kPullOnly;
  return kFly;
}

std::size_t IntegratedSolver::next_part() {
  if (parts_ > 0) {
    --parts_;
    remaining_ = step_ / Splitting::kInAStep;
  } else if (tail_ > 0) {
    remaining_ = std::exchange(tail_, 0);
  } else {
    return end_step();
  }
  return begin_piece(remaining_);
}

std::size_t IntegratedSolver::begin_piece(double length) {
  piece_ = length;
  stage_ = 0;
  start_position_ = state_.balls.position;
  start_velocity_ = state_.balls.velocity;
  for (std::size_t s = 0; s <= Splitting::kStages; ++s) {
    Stage& stage = stages_[s];
    stage.kick = Splitting::pull[s] * length;
    if (s == Splitting::kStages) break;
    stage.step = Splitting::flight[s] * length;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double along = gravity_[Balls::index(axis)];
      stage.glide[axis] = Glide{stage.step};
      if (drag_rate_ > 0) {
        stage.glide[axis] = effects::slowed(drag_rate_, stage.step, along);
      } else if (along != 0) {
        stage.glide[axis] = effects::fall(along, stage.step);
      }
    }
  }
  return kFly;
}

std::size_t IntegratedSolver::after_stage() {
  if (stage_ == kPullOnly) {
    state_.pull_known = true;
    find_resting();
    return next_part();
  }
  if (stage_ < Splitting::kStages) {
    std::swap(state_.balls.position, next_);
    ++stage_;
    return kFly;
  }
  state_.pull_known = true;
  if (planned_) {
    remaining_ -= piece_;
    strike(*std::exchange(planned_, std::nullopt));
    return go_on_after_impact();
  }
  return meets_anything() ? std::size_t{kSearch} : next_part();
}

std::size_t IntegratedSolver::after_search() {
  Meeting first;
  for (const Find& find : finds_) {
    if (find.first.before(first)) first = find.first;
  }
  for (const Find& find : finds_) {
    for (const Meeting& slow : find.slow) {
      if (slow.before(first)) resting_.push_back(slow);
    }
  }
  if (first.at > 1) return next_part();
  const double length = first.at * piece_;
  back_to_start();
  if (length > 0) {
    planned_ = first;
    return begin_piece(length);
  }
  strike(first);
  return go_on_after_impact();
}

std::size_t IntegratedSolver::go_on_after_impact() {
  return remaining_ > 0 ? begin_piece(remaining_) : next_part();
}

std::size_t IntegratedSolver::end_step() {
  settle();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] == 0) continue;
    for (std::size_t i = 0; i < balls(); ++i) {
      double& x = state_.balls.position[axis][Balls::index(i)];
      const double image = domain_.wrapped(axis, x);
      if (image == x) continue;
      if (!state_.turns[axis].empty()) {
        state_.turns[axis][i] +=
            static_cast<std::int64_t>(std::rint((x - image) / domain_.period[axis]));
      }
      x = image;
      state_.pull_known = false;
    }
  }
  if (whole_) return Phase::kFrameDone;
  ++taken_;
  ++steps_;
  if (steps_ < target_) return begin_step(step_);
  if (extra_ == 0) return Phase::kFrameDone;
  whole_ = state_;
  return begin_step(extra_);
}

void IntegratedSolver::back_to_start() {
  state_.balls.position = start_position_;
  state_.balls.velocity = start_velocity_;
  state_.balls.pull = start_pull_;
}

// --- what the workers do ----------------------------------------------------------------------

void IntegratedSolver::fly(Share share) {
  Find& find = finds_[share.index];
  Balls& balls = state_.balls;
  const std::size_t begin = share.begin(balls.size());
  const std::size_t end = share.end(balls.size());
  if (stage_ == kPullOnly) {
    const Stopwatch stopwatch(timed(), find.seconds.of<Attraction>());
    effects::attract(balls, domain_, *effects_.attraction, begin, end);
    return;
  }
  const Stage& stage = stages_[stage_];
  {
    const Stopwatch stopwatch(timed(), find.seconds.of<Attraction>());
    if (stage_ > 0 || !state_.pull_known) {
      effects::attract(balls, domain_, *effects_.attraction, begin, end);
    }
    if (stage_ == 0) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        std::copy(balls.pull[axis].data() + begin, balls.pull[axis].data() + end,
                  start_pull_[axis].data() + begin);
      }
    }
    effects::kick(balls, stage.kick, begin, end);
  }
  if (stage_ == Splitting::kStages) {
    if (meets_anything() && !planned_) draw_paths(begin, end);
    return;
  }
  for (std::size_t i = begin; i < end; i += Flight::kBlock) {
    fly_block(stage, i, std::min(i + Flight::kBlock, end), find);
  }
}

void IntegratedSolver::fly_block(const Stage& stage, std::size_t begin, std::size_t end,
                                 Find& find) {
  Balls& balls = state_.balls;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Flight flight;
    prepare(flight, balls, axis, begin, end, stage.step, stage.glide[axis]);
    if (drag_rate_ > 0) {
      const Stopwatch stopwatch(timed(), find.seconds.of<Drag>());
      effects::drag(flight);
    } else {
      straight(flight);
    }
    if (stage.glide[axis].gain != 0) {
      const Stopwatch stopwatch(timed(), find.seconds.of<Gravity>());
      effects::gravity(flight);
    }
    land(flight);
    std::copy_n(flight.moved.data(), flight.count, next_[axis].data() + begin);
    std::copy_n(flight.after.data(), flight.count, balls.velocity[axis].data() + begin);
  }
}

double IntegratedSolver::acceleration(std::size_t axis, std::uint32_t i, double velocity,
                                      double pull) const {
  if (state_.balls.fixed(i)) return 0;
  return pull + gravity_[Balls::index(axis)] - drag_rate_ * velocity;
}

Vec2 IntegratedSolver::acceleration(std::uint32_t i) const {
  const Eigen::Index k = Balls::index(i);
  const Balls& balls = state_.balls;
  return {acceleration(0, i, balls.velocity[0][k], balls.pull[0][k]),
          acceleration(1, i, balls.velocity[1][k], balls.pull[1][k])};
}

void IntegratedSolver::draw_paths(std::size_t begin, std::size_t end) {
  const Balls& balls = state_.balls;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Index k = Balls::index(i);
      const auto ball = static_cast<std::uint32_t>(i);
      const double v0 = start_velocity_[axis][k];
      const double v1 = balls.velocity[axis][k];
      const Bernstein<5> path = quintic(
          piece_, start_position_[axis][k], v0, acceleration(axis, ball, v0, start_pull_[axis][k]),
          balls.position[axis][k], v1, acceleration(axis, ball, v1, balls.pull[axis][k]));
      const auto [low, high] = std::minmax_element(path.begin(), path.end());
      low_[axis][k] = *low;
      high_[axis][k] = *high;
    }
  }
}

void IntegratedSolver::search(Share share) {
  Find& find = finds_[share.index];
  find.first = {};
  find.slow.clear();
  const auto n = static_cast<std::uint32_t>(balls());
  const auto look = [&](std::uint32_t i, std::uint32_t j, const std::optional<double>& at) {
    if (!at) return;
    const Meeting meeting{*at, i, j};
    if (!meeting.before(find.first) || rests(meeting)) return;
    if (is_slow(meeting)) {
      find.slow.push_back(meeting);
    } else {
      find.first = meeting;
    }
  };
  if (domain_.solid(0) || domain_.solid(1)) {
    const Stopwatch stopwatch(timed(), find.seconds.of<Walls>());
    for (auto i = static_cast<std::uint32_t>(share.begin(n)); i < share.end(n); ++i) {
      for (std::uint32_t side = 0; side < 4; ++side)
        look(i, Meeting::kWall + side, meet_wall(i, side));
    }
  }
  if (!collides()) return;
  const Stopwatch stopwatch(timed(), find.seconds.of<Collisions>());
  for (auto i = static_cast<std::uint32_t>(share.index); i < n;
       i += static_cast<std::uint32_t>(share.count)) {
    for (std::uint32_t j = i + 1; j < n; ++j) look(i, j, meet(i, j));
  }
}

std::optional<double> IntegratedSolver::meet_wall(std::uint32_t i, std::uint32_t side) const {
  const std::size_t axis = side / 2;
  if (!domain_.solid(axis) || state_.balls.fixed(i)) return std::nullopt;
  const Eigen::Index k = Balls::index(i);
  const double radius = state_.balls.radius[k];
  const bool upper = side % 2 == 1;
  const double wall = upper ? domain_.highest(axis, radius) : domain_.lowest(axis, radius);
  if (upper ? high_[axis][k] < wall : low_[axis][k] > wall) return std::nullopt;
  const double sign = upper ? -1 : 1;
  const double v0 = start_velocity_[axis][k];
  const double v1 = state_.balls.velocity[axis][k];
  const Bernstein<5> height = quintic(piece_, sign * (start_position_[axis][k] - wall), sign * v0,
                                      sign * acceleration(axis, i, v0, start_pull_[axis][k]),
                                      sign * (state_.balls.position[axis][k] - wall), sign * v1,
                                      sign * acceleration(axis, i, v1, state_.balls.pull[axis][k]));
  return first_landing(height, sign * v0);
}

std::optional<double> IntegratedSolver::meet(std::uint32_t i, std::uint32_t j) const {
  const Balls& balls = state_.balls;
  const Eigen::Index a = Balls::index(i);
  const Eigen::Index b = Balls::index(j);
  const double reach = balls.radius[a] + balls.radius[b];
  std::array<double, 2> shift{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (domain_.period[axis] > 0) {
      const double apart = start_position_[axis][b] - start_position_[axis][a];
      shift[axis] = nearest_image(apart, domain_.period[axis]) - apart;
    }
    if (low_[axis][b] - high_[axis][a] + shift[axis] > reach) return std::nullopt;
    if (high_[axis][b] - low_[axis][a] + shift[axis] < -reach) return std::nullopt;
  }
  if (balls.fixed(i) && balls.fixed(j)) return std::nullopt;
  std::array<Bernstein<5>, 2> path;
  Vec2 velocity;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& v0 = start_velocity_[axis];
    const auto& v1 = balls.velocity[axis];
    const auto& p0 = start_pull_[axis];
    const auto& p1 = balls.pull[axis];
    path[axis] = quintic(
        piece_, start_position_[axis][b] - start_position_[axis][a] + shift[axis], v0[b] - v0[a],
        acceleration(axis, j, v0[b], p0[b]) - acceleration(axis, i, v0[a], p0[a]),
        balls.position[axis][b] - balls.position[axis][a] + shift[axis], v1[b] - v1[a],
        acceleration(axis, j, v1[b], p1[b]) - acceleration(axis, i, v1[a], p1[a]));
    velocity[Balls::index(axis)] = v0[b] - v0[a];
  }
  return first_contact(path[0], path[1], velocity, reach);
}

// --- impacts ----------------------------------------------------------------------------------

effects::Member IntegratedSolver::member(std::uint32_t i) const {
  const Balls& balls = state_.balls;
  const Eigen::Index k = Balls::index(i);
  effects::Member member;
  member.ball = i;
  member.position = member.start = balls.at(i);
  member.velocity = {balls.velocity[0][k], balls.velocity[1][k]};
  member.radius = balls.radius[k];
  member.mass = balls.mass[k];
  member.inverse_mass = balls.inverse_mass[k];
  if (effects_.friction) member.spin = balls.spin[k];
  return member;
}

void IntegratedSolver::put_back(const effects::Member& member) {
  if (member.inverse_mass == 0) return;
  Balls& balls = state_.balls;
  const Eigen::Index k = Balls::index(member.ball);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Eigen::Index c = Balls::index(axis);
    balls.velocity[axis][k] = member.velocity[c];
    if (balls.position[axis][k] == member.position[c]) continue;
    balls.position[axis][k] = member.position[c];
    state_.pull_known = false;
  }
  if (effects_.friction) balls.spin[k] = member.spin;
}

bool IntegratedSolver::rests(const Meeting& meeting) const {
  return std::any_of(resting_.begin(), resting_.end(),
                     [&](const Meeting& other) { return other.who() == meeting.who(); });
}

double IntegratedSolver::rest_speed(std::uint32_t i, std::uint32_t j) const {
  const double size = acceleration(i).norm() + (i == j ? 0 : acceleration(j).norm());
  return effects::rest_speed(size, step_, 0);
}

// As fast as they were when the piece began, or are when it ends: whichever is more.
bool IntegratedSolver::is_slow(const Meeting& meeting) const {
  const Balls& balls = state_.balls;
  if (meeting.with_wall()) {
    if (effects_.walls->restitution == 1) return false;
    const std::size_t axis = (meeting.j - Meeting::kWall) / 2;
    const Eigen::Index k = Balls::index(meeting.i);
    const double speed =
        std::max(std::abs(start_velocity_[axis][k]), std::abs(balls.velocity[axis][k]));
    return speed <= rest_speed(meeting.i, meeting.i);
  }
  if (effects_.collisions->restitution == 1) return false;
  const Eigen::Index a = Balls::index(meeting.i);
  const Eigen::Index b = Balls::index(meeting.j);
  double before = 0;
  double after = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double v0 = start_velocity_[axis][b] - start_velocity_[axis][a];
    const double v1 = balls.velocity[axis][b] - balls.velocity[axis][a];
    before += v0 * v0;
    after += v1 * v1;
  }
  return std::sqrt(std::max(before, after)) <= rest_speed(meeting.i, meeting.j);
}

bool IntegratedSolver::too_often(const Meeting& meeting) {
  constexpr std::ptrdiff_t kOften = 16;
  struck_.push_back(meeting.who());
  return std::count(struck_.begin(), struck_.end(), meeting.who()) > kOften;
}

void IntegratedSolver::strike(const Meeting& meeting) {
  if (too_often(meeting)) resting_.push_back(meeting);
  if (meeting.with_wall()) {
    strike_wall(meeting);
  } else {
    strike_balls(meeting);
  }
}

void IntegratedSolver::strike_balls(const Meeting& meeting) {
  effects::Member a = member(meeting.i);
  effects::Member b = member(meeting.j);
  const LineOfCentres line = line_between(a, b, domain_);
  const double closing = (b.velocity - a.velocity).dot(line.r);
  if (!approaches(closing, line.length, a.velocity, b.velocity)) {
    resting_.push_back(meeting);
    return;
  }
  const double restitution = effects_.collisions->restitution;
  const bool bounces =
      restitution == 1 || -closing > line.length * rest_speed(meeting.i, meeting.j);
  if (!bounces) resting_.push_back(meeting);
  const double inverse_masses = a.inverse_mass + b.inverse_mass;
  const double j = impulse(closing, line.square, inverse_masses, bounces ? restitution : 0);
  a.velocity -= j * a.inverse_mass * line.r;
  b.velocity += j * b.inverse_mass * line.r;
  if (effects_.friction && effects_.friction->balls > 0) {
    effects::rub(a, b, line, j * line.length, effects_.friction->balls);
  }
  if (bounces) {
    ++state_.ball_ball;
    // What rested against one of the two may be hit now.
    std::erase_if(resting_, [&](const Meeting& other) {
      return other.i == a.ball || other.i == b.ball || other.j == a.ball || other.j == b.ball;
    });
  }
  const double depth = a.radius + b.radius - line.distance;
  state_.deepest = std::max(state_.deepest, depth / std::min(a.radius, b.radius));
  put_back(a);
  put_back(b);
}

void IntegratedSolver::strike_wall(const Meeting& meeting) {
  const std::uint32_t side = meeting.j - Meeting::kWall;
  const std::size_t axis = side / 2;
  const double outwards = side % 2 == 1 ? 1 : -1;
  const Eigen::Index k = Balls::index(axis);
  effects::Member ball = member(meeting.i);
  ball.position[k] =
      outwards > 0 ? domain_.highest(axis, ball.radius) : domain_.lowest(axis, ball.radius);
  const double arrival = outwards * ball.velocity[k];
  if (!(arrival > 0)) {
    resting_.push_back(meeting);
  } else {
    const double restitution = effects_.walls->restitution;
    const bool bounces = restitution == 1 || arrival > rest_speed(meeting.i, meeting.i);
    if (!bounces) resting_.push_back(meeting);
    const double leaving = bounces ? restitution * arrival : 0;
    ball.velocity[k] = -outwards * leaving;
    if (effects_.friction && effects_.friction->walls > 0) {
      effects::rub_wall(ball, axis, outwards * (arrival + leaving), effects_.friction->walls);
    }
    if (bounces) ++state_.ball_wall;
  }
  put_back(ball);
}

// The balls that rest on each other as the step begins.
void IntegratedSolver::find_resting() {
  constexpr double kClose = 1 + 0x1p-33;  // of the sum of the radii: put side by side, and rounding
  const auto n = static_cast<std::uint32_t>(balls());
  const Balls& balls = state_.balls;
  if (collides() && effects_.collisions->restitution < 1) {
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = i + 1; j < n; ++j) {
        const Eigen::Index a = Balls::index(i);
        const Eigen::Index b = Balls::index(j);
        const double far = (balls.radius[a] + balls.radius[b]) * kClose;
        double x = balls.position[0][b] - balls.position[0][a];
        if (domain_.period[0] > 0) x = nearest_image(x, domain_.period[0]);
        if (!(std::abs(x) < far) || (balls.fixed(i) && balls.fixed(j))) continue;
        const effects::Member first = member(i);
        const effects::Member second = member(j);
        const LineOfCentres line = line_between(first, second, domain_);
        if (!(line.distance < far)) continue;
        const double closing = (second.velocity - first.velocity).dot(line.r);
        if (std::abs(closing) <= line.length * rest_speed(i, j)) resting_.push_back({0, i, j});
      }
    }
  }
  if (!effects_.walls || effects_.walls->restitution == 1) return;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t side = 0; side < 4; ++side) {
      const std::size_t axis = side / 2;
      if (!domain_.solid(axis) || balls.fixed(i)) continue;
      const Eigen::Index k = Balls::index(i);
      const double radius = balls.radius[k];
      const double x = balls.position[axis][k];
      if (side % 2 == 1 ? x < domain_.highest(axis, radius) : x > domain_.lowest(axis, radius)) {
        continue;
      }
      const double outwards = side % 2 == 1 ? 1 : -1;
      const double pull = outwards * acceleration(i)[Balls::index(axis)];
      if (pull > 0 && std::abs(balls.velocity[axis][k]) <= rest_speed(i, i)) {
        resting_.push_back({0, i, Meeting::kWall + side});
      }
    }
  }
}

// What has pressed on in the step is stopped and put side by side, in passes to and fro.
void IntegratedSolver::settle() {
  constexpr int kPasses = 16;
  std::sort(resting_.begin(), resting_.end(),
            [](const Meeting& m, const Meeting& k) { return m.who() < k.who(); });
  const auto sweep = [&](auto act) {
    for (int pass = 0; pass < kPasses; ++pass) {
      bool any = false;
      for (const Meeting& meeting : resting_) any |= act(meeting);
      std::reverse(resting_.begin(), resting_.end());
      if (!any) return;
    }
  };
  sweep([this](const Meeting& meeting) { return stop(meeting); });
  sweep([this](const Meeting& meeting) { return put_apart(meeting); });
}

bool IntegratedSolver::stop(const Meeting& meeting) {
  effects::Member a = member(meeting.i);
  if (meeting.with_wall()) {
    const std::uint32_t side = meeting.j - Meeting::kWall;
    const std::size_t axis = side / 2;
    const double outwards = side % 2 == 1 ? 1 : -1;
    const Eigen::Index k = Balls::index(axis);
    const double wall =
        outwards > 0 ? domain_.highest(axis, a.radius) : domain_.lowest(axis, a.radius);
    const double pressing = outwards * a.velocity[k];
    if (outwards * (a.position[k] - wall) < 0 || !(pressing > 0)) return false;
    a.velocity[k] = 0;
    if (effects_.friction) {
      effects::rub_wall(a, axis, outwards * pressing, effects_.friction->walls);
    }
    put_back(a);
    return true;
  }
  effects::Member b = member(meeting.j);
  const LineOfCentres line = line_between(a, b, domain_);
  const double closing = (b.velocity - a.velocity).dot(line.r);
  if (line.distance >= a.radius + b.radius) return false;
  if (!approaches(closing, line.length, a.velocity, b.velocity)) return false;
  const double j = impulse(closing, line.square, a.inverse_mass + b.inverse_mass, 0);
  a.velocity -= j * a.inverse_mass * line.r;
  b.velocity += j * b.inverse_mass * line.r;
  if (effects_.friction) effects::rub(a, b, line, j * line.length, effects_.friction->balls);
  put_back(a);
  put_back(b);
  return true;
}

bool IntegratedSolver::put_apart(const Meeting& meeting) {
  constexpr double kClose = 1 - 0x1p-40;  // of the sum of the radii: as good as apart
  effects::Member a = member(meeting.i);
  if (meeting.with_wall()) {
    const std::uint32_t side = meeting.j - Meeting::kWall;
    const std::size_t axis = side / 2;
    const double outwards = side % 2 == 1 ? 1 : -1;
    double& x = a.position[Balls::index(axis)];
    const double wall =
        outwards > 0 ? domain_.highest(axis, a.radius) : domain_.lowest(axis, a.radius);
    if (outwards * (x - wall) <= 0) return false;
    x = wall;
    put_back(a);
    return true;
  }
  effects::Member b = member(meeting.j);
  const LineOfCentres line = line_between(a, b, domain_);
  const double reach = a.radius + b.radius;
  if (line.distance >= reach * kClose) return false;
  const double depth = reach - line.distance;
  const Vec2 move = depth / (line.length * (a.inverse_mass + b.inverse_mass)) * line.r;
  a.position -= a.inverse_mass * move;
  b.position += b.inverse_mass * move;
  state_.deepest = std::max(state_.deepest, depth / std::min(a.radius, b.radius));
  put_back(a);
  put_back(b);
  return true;
}

// --- commands ---------------------------------------------------------------------------------

// What is shown becomes the run, and steps are numbered from here.
void IntegratedSolver::restart_steps() {
  whole_.reset();
  step_origin_ = time_;
  steps_ = 0;
  state_.pull_known = false;
  renew_rules();
}

void IntegratedSolver::add(const Ball& ball) {
  std::vector<Ball> balls = state_.balls.to_vector();
  balls.push_back(ball);
  state_.balls = Balls(balls, effects_);
  for (auto& turns : state_.turns) {
    if (!turns.empty()) turns.push_back(0);
  }
  restart_steps();
}

void IntegratedSolver::remove(std::size_t ball) {
  std::vector<Ball> balls = state_.balls.to_vector();
  balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(ball));
  state_.balls = Balls(balls, effects_);
  for (auto& turns : state_.turns) {
    if (!turns.empty()) turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(ball));
  }
  restart_steps();
}

void IntegratedSolver::set(const Effects& effects) {
  assign(effects_, effects);
  restart_steps();
}

void IntegratedSolver::set_step(double step) {
  step_ = step;
  restart_steps();
}

void IntegratedSolver::renew_rules() {
  gravity_ = effects_.gravity ? effects_.gravity->acceleration : Vec2{0, 0};
  drag_rate_ = effects_.drag ? effects_.drag->rate : 0;
  domain_ = Domain(box_, has_walls(effects_));
  const Eigen::Index n = Balls::index(balls());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (auto* columns : {&next_, &start_pull_, &low_, &high_}) {
      (*columns)[axis] = Balls::Column::Zero(n);
    }
    if (gravity_[Balls::index(axis)] != 0 && domain_.period[axis] > 0) {
      state_.turns[axis].resize(balls(), 0);
    }
  }
}

// --- looking ----------------------------------------------------------------------------------

double IntegratedSolver::energy() const {
  const Vec2 periods{domain_.period[0], domain_.period[1]};
  double sum = kinetic_energy(state_.balls) +
               potential_energy(state_.balls, gravity_, periods, state_.turns) +
               effects::attraction_energy(state_.balls, domain_, *effects_.attraction);
  if (effects_.friction) sum += spin_energy(state_.balls);
  return sum;
}

void IntegratedSolver::count(Measurements& measurements) const {
  measurements.ball_ball += state_.ball_ball;
  measurements.ball_wall += state_.ball_wall;
  measurements.max_overlap = std::max(measurements.max_overlap, state_.deepest);
  EffectSeconds seconds;
  for (const Find& find : finds_) seconds += find.seconds;
  add_sampled_seconds(effects_, seconds, taken_, measurements);
}

void IntegratedSolver::save(Scene& scene) const {
  if (whole_) scene.balls = whole_->balls.to_vector();
  scene.effects = effects_;
  scene.solver.step = step_;
  scene.continuation->step_origin = step_origin_;
  scene.continuation->steps = steps_;
}

}  // namespace carom
