#include "solvers/integrated/solver.hpp"

#include <algorithm>
#include <cmath>

#include "contact/dissipation.hpp"
#include "contact/impulse.hpp"
#include "state/stopwatch.hpp"

namespace carom {

effects::Member IntegratedSolver::member(std::uint32_t i) const {
  const Balls& balls = state_.balls;
  const std::size_t k = i;
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
  const std::size_t k = member.ball;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::size_t c = axis;
    balls.velocity[axis][k] = member.velocity[c];
    if (balls.position[axis][k] == member.position[c]) continue;
    balls.position[axis][k] = member.position[c];
    state_.pull_known = false;
  }
  if (effects_.friction) balls.spin[k] = member.spin;
}

/// `after`: the time since the step began.
void IntegratedSolver::note(const Meeting& meeting, double after, bool bounces, const Vec2& normal,
                            double distance, double impulse, const FrictionChange& by_friction) {
  if (!log_.wanted) return;
  Impact& impact = lines().emplace_back();
  impact.time = step_origin_ + static_cast<double>(steps_) * step_ + after;
  impact.kind = ImpactKind::rest;
  if (bounces) impact.kind = meeting.with_wall() ? ImpactKind::wall : ImpactKind::ball;
  impact.a = meeting.i;
  if (meeting.with_wall()) {
    const std::uint32_t side = meeting.j - Meeting::kWall;
    impact.wall = side_of(side / 2, side % 2 == 1);
  } else {
    impact.b = meeting.j;
  }
  impact.position = state_.balls.at(meeting.i);
  impact.normal = normal;
  impact.distance = distance;
  impact.impulse = impulse;
  impact.tangential = by_friction.impulse;
  impact.energy_lost = by_friction.lost;
}

LineOfCentres IntegratedSolver::line_between(const effects::Member& a,
                                             const effects::Member& b) const {
  return line_of_centres(nearest_image(b.position - a.position, domain_), b.velocity - a.velocity);
}

bool IntegratedSolver::too_often(const Meeting& meeting) {
  constexpr int kOften = 16;
  return ++struck_[meeting.who()] > kOften;
}

void IntegratedSolver::strike(const Meeting& meeting) {
  if (too_often(meeting)) {
    resting_.push_back(meeting);
    resting_.back().to_the_end = true;
  }
  const double friction_body = impacts_.of<Friction>();
  double& impacts = meeting.with_wall() ? impacts_.of<Walls>() : impacts_.of<Collisions>();
  {
    const Stopwatch stopwatch(true, impacts);
    if (meeting.with_wall()) {
      strike_wall(meeting);
    } else {
      strike_balls(meeting);
    }
  }
  impacts -= impacts_.of<Friction>() - friction_body;
}

void IntegratedSolver::strike_balls(const Meeting& meeting) {
  effects::Member a = member(meeting.i);
  effects::Member b = member(meeting.j);
  const LineOfCentres line = line_between(a, b);
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
  FrictionChange by_friction;
  if (effects_.friction && effects_.friction->balls > 0) {
    const Stopwatch stopwatch(true, impacts_.of<Friction>());
    by_friction = effects::apply_friction(a, b, line, j * line.length, effects_.friction->balls);
  }
  const double approach = -closing / line.length;
  by_friction.lost +=
      lost_to_restitution(approach, bounces ? restitution * approach : 0, inverse_masses);
  state_.losses.by_ball[meeting.i] += by_friction.lost;
  note(meeting, part_end_ - remaining_, bounces, line.r / line.length, line.distance,
       j * line.length, by_friction);
  if (bounces) {
    ++state_.ball_ball;
    // What rested against one of the two may be hit now.
    std::erase_if(resting_, [&](const Meeting& other) {
      if (other.to_the_end) return false;
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
  const std::size_t k = axis;
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
    FrictionChange by_friction;
    if (effects_.friction && effects_.friction->walls > 0) {
      const Stopwatch stopwatch(true, impacts_.of<Friction>());
      by_friction = effects::apply_wall_friction(ball, axis, outwards * (arrival + leaving),
                                                 effects_.friction->walls);
    }
    by_friction.lost += lost_to_restitution(arrival, leaving, 1);
    state_.losses.by_ball[meeting.i] += ball.mass * by_friction.lost;
    Vec2 normal{0, 0};
    normal[k] = outwards;
    note(meeting, part_end_ - remaining_, bounces, normal, ball.radius,
         ball.mass * (arrival + leaving),
         {ball.mass * by_friction.impulse, ball.mass * by_friction.lost});
    if (bounces) ++state_.ball_wall;
  }
  put_back(ball);
}

}  // namespace carom
