// How the contacts that last are ended at the end of a step: one after another, in an order that
// follows from how the balls are and move.
//
// Of contacts that are alike none is first: each is worked out from the same state, with its share
// of the mass of every ball that takes part in several, and the ball takes the mean of what they
// make of it.  So no order of the balls shows, and energy never grows.
// Source: Tonge, Benevolenski, Voroshilov, Mass splitting for jitter-free parallel rigid body
// simulation, ACM Trans. Graph. 31 (2012) 105.
#include <algorithm>
#include <cmath>

#include "contact/dissipation.hpp"
#include "contact/impulse.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/integrated/solver.hpp"

namespace carom {
namespace {

double mean(const std::vector<double>& values) {
  event::ExactSum<double> sum;
  for (const double value : values) sum.add(value);
  return sum.rounded() / static_cast<double>(values.size());
}

// A ball, with what each of the contacts that act on it would make of it.
struct Shared {
  std::uint32_t ball = 0;
  std::vector<effects::Member> made;

  [[nodiscard]] effects::Member together(effects::Member ball_before) const {
    const auto of = [this](auto part) {
      std::vector<double> values;
      values.reserve(made.size());
      for (const effects::Member& member : made) values.push_back(part(member));
      return mean(values);
    };
    for (std::size_t axis = 0; axis < 2; ++axis) {
      ball_before.position[axis] = of([axis](const auto& m) { return m.position[axis]; });
      ball_before.velocity[axis] = of([axis](const auto& m) { return m.velocity[axis]; });
    }
    ball_before.spin = of([](const auto& m) { return m.spin; });
    return ball_before;
  }
};

// What the parts of a ball lose when they move on together, by one of them.
double lost_by_joining(const effects::Member& part, const effects::Member& whole) {
  const double turn = part.radius * (part.spin - whole.spin);
  return part.mass * ((part.velocity - whole.velocity).squaredNorm() + turn * turn / 2) / 2;
}

}  // namespace

// What has pressed on in the step is stopped and put side by side, in passes to and fro.
void IntegratedSolver::settle() {
  if (!meets_anything()) return;
  const std::array<Balls::Column, 2> from = state_.balls.position;
  linked_.assign(balls(), 0);
  stopped_.clear();
  stop_and_put_apart();
  pay_for_lifts(from);
}

void IntegratedSolver::stop_and_put_apart() {
  const auto once = [](std::vector<Meeting>& meetings) {
    std::sort(meetings.begin(), meetings.end(),
              [](const Meeting& m, const Meeting& k) { return m.who() < k.who(); });
    const auto same = [](const Meeting& m, const Meeting& k) { return m.who() == k.who(); };
    meetings.erase(std::unique(meetings.begin(), meetings.end(), same), meetings.end());
  };
  once(resting_);
  for (Meeting& meeting : resting_) {
    meeting.closing = closing_speed(meeting, state_.balls.position, state_.balls.velocity);
  }
  sweep(resting_, &IntegratedSolver::stop);
  for (std::uint32_t i = 0; i < balls(); ++i) {
    effects::Member ball = member(i);
    if (put_inside(ball)) put_back(ball);
  }
  if (resting_.empty() || !collides()) return;
  // Putting two apart may push others together that have not met in this step.
  constexpr double kNear = 1.25;  // of the sum of the radii
  std::vector<Meeting> near = near_pairs(kNear);
  for (Meeting& meeting : near) {
    const LineOfCentres line = line_between(member(meeting.i), member(meeting.j));
    meeting.closing =
        state_.balls.radius[meeting.i] + state_.balls.radius[meeting.j] - line.distance;
  }
  sweep(near, &IntegratedSolver::put_apart);
}

void IntegratedSolver::sweep(std::vector<Meeting>& meetings, Acting acting) {
  constexpr int kPasses = 64;
  std::stable_sort(meetings.begin(), meetings.end(),
                   [](const Meeting& m, const Meeting& k) { return m.closing > k.closing; });
  std::vector<std::span<const Meeting>> order;
  for (auto begin = meetings.begin(); begin != meetings.end();) {
    const auto end = std::find_if(begin, meetings.end(),
                                  [&](const Meeting& m) { return m.closing != begin->closing; });
    order.emplace_back(begin, end);
    begin = end;
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    bool any = false;
    for (const std::span<const Meeting> alike : order) any |= act_on(alike, acting);
    if (!any) return;
    std::reverse(order.begin(), order.end());
  }
}

bool IntegratedSolver::act_on(std::span<const Meeting> alike, Acting acting) {
  std::vector<Meeting> active;
  std::vector<Shared> shared;
  const auto share_of = [&](std::uint32_t ball) -> Shared& {
    const auto found = std::find_if(shared.begin(), shared.end(),
                                    [&](const Shared& share) { return share.ball == ball; });
    return found != shared.end() ? *found : shared.emplace_back(Shared{ball, {}});
  };
  for (const Meeting& meeting : alike) {
    effects::Member a = member(meeting.i);
    effects::Member b = meeting.with_wall() ? a : member(meeting.j);
    if (!(this->*acting)(meeting, a, b)) continue;
    active.push_back(meeting);
    share_of(meeting.i).made.push_back(a);
    if (!meeting.with_wall()) share_of(meeting.j).made.push_back(b);
  }
  if (active.empty()) return false;

  // Again, where a ball takes part in several.
  const auto part_of = [&](std::uint32_t ball, double parts) {
    effects::Member part = member(ball);
    part.inverse_mass *= parts;
    part.mass /= parts;
    return part;
  };
  std::vector<double> parts;
  for (Shared& share : shared) {
    parts.push_back(static_cast<double>(share.made.size()));
    share.made.clear();
  }
  struct Made {
    effects::Member a;
    effects::Member b;
    Act act;
  };
  std::vector<Made> made;
  for (const Meeting& meeting : active) {
    const auto parts_of = [&](std::uint32_t ball) {
      return parts[static_cast<std::size_t>(&share_of(ball) - shared.data())];
    };
    effects::Member a = part_of(meeting.i, parts_of(meeting.i));
    effects::Member b = meeting.with_wall() ? a : part_of(meeting.j, parts_of(meeting.j));
    const Act act = (this->*acting)(meeting, a, b).value_or(Act{});
    share_of(meeting.i).made.push_back(a);
    if (!meeting.with_wall()) share_of(meeting.j).made.push_back(b);
    made.push_back({a, b, act});
  }
  std::vector<effects::Member> together;
  for (const Shared& share : shared) {
    together.push_back(share.made.size() == 1 ? share.made.front()
                                              : share.together(member(share.ball)));
    effects::Member& whole = together.back();
    const effects::Member before = member(share.ball);
    whole.mass = before.mass;
    whole.inverse_mass = before.inverse_mass;
  }
  for (std::size_t k = 0; k < made.size(); ++k) {
    const Meeting& meeting = active[k];
    Act& act = made[k].act;
    const auto join = [&](const effects::Member& part) {
      if (part.inverse_mass == 0) return;
      const auto place = static_cast<std::size_t>(&share_of(part.ball) - shared.data());
      act.by_friction.lost += lost_by_joining(part, together[place]);
    };
    if (!meeting.with_wall() && made[k].a.inverse_mass > 0 && made[k].b.inverse_mass > 0) {
      linked_[meeting.i] = linked_[meeting.j] = 1;
    }
    join(made[k].a);
    if (!meeting.with_wall()) join(made[k].b);
    const double smaller =
        meeting.with_wall() ? made[k].a.radius : std::min(made[k].a.radius, made[k].b.radius);
    state_.deepest = std::max(state_.deepest, act.depth / smaller);
    if (act.impulse == 0) continue;
    const bool first_pays = meeting.with_wall() || made[k].a.inverse_mass > 0;
    stopped_.push_back({first_pays ? meeting.i : meeting.j, act.by_friction.lost, lines().size()});
    note(meeting, part_end_, false, act.normal, act.distance, act.impulse, act.by_friction);
  }
  for (effects::Member& whole : together) {
    put_inside(whole);
    put_back(whole);
  }
  return true;
}

std::optional<IntegratedSolver::Act> IntegratedSolver::stop(const Meeting& meeting,
                                                            effects::Member& a,
                                                            effects::Member& b) const {
  Act act;
  if (meeting.with_wall()) {
    const std::uint32_t side = meeting.j - Meeting::kWall;
    const std::size_t axis = side / 2;
    const double outwards = side % 2 == 1 ? 1 : -1;
    const double wall =
        outwards > 0 ? domain_.highest(axis, a.radius) : domain_.lowest(axis, a.radius);
    const double pressing = outwards * a.velocity[axis];
    if (outwards * (a.position[axis] - wall) < 0 || !(pressing > 0)) return std::nullopt;
    a.velocity[axis] = 0;
    FrictionChange by_friction;
    if (effects_.friction) {
      by_friction =
          effects::apply_wall_friction(a, axis, outwards * pressing, effects_.friction->walls);
    }
    by_friction.lost += lost_to_restitution(pressing, 0, 1);
    act.normal[axis] = outwards;
    act.distance = a.radius;
    act.impulse = a.mass * pressing;
    act.by_friction = {a.mass * by_friction.impulse, a.mass * by_friction.lost};
    return act;
  }
  const LineOfCentres line = line_between(a, b);
  const double closing = (b.velocity - a.velocity).dot(line.r);
  if (line.distance >= a.radius + b.radius) return std::nullopt;
  if (!approaches(closing, line.length, a.velocity, b.velocity)) return std::nullopt;
  const double j = impulse(closing, line.square, a.inverse_mass + b.inverse_mass, 0);
  a.velocity -= j * a.inverse_mass * line.r;
  b.velocity += j * b.inverse_mass * line.r;
  if (effects_.friction) {
    act.by_friction =
        effects::apply_friction(a, b, line, j * line.length, effects_.friction->balls);
  }
  act.by_friction.lost +=
      lost_to_restitution(-closing / line.length, 0, a.inverse_mass + b.inverse_mass);
  act.normal = line.r / line.length;
  act.distance = line.distance;
  act.impulse = j * line.length;
  return act;
}

bool IntegratedSolver::put_inside(effects::Member& ball) const {
  if (ball.inverse_mass == 0) return false;
  const Vec2 from = ball.position;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain_.solid(axis)) continue;
    double& x = ball.position[axis];
    x = std::clamp(x, domain_.lowest(axis, ball.radius), domain_.highest(axis, ball.radius));
  }
  return ball.position != from;
}

// By their inverse masses; what a wall holds back the other has to give.
std::optional<IntegratedSolver::Act> IntegratedSolver::put_apart(const Meeting& /*meeting*/,
                                                                 effects::Member& a,
                                                                 effects::Member& b) const {
  constexpr double kClose = 1 - 0x1p-40;  // of the sum of the radii: as good as apart
  Act act;
  const double reach = a.radius + b.radius;
  bool free_a = true;
  bool free_b = true;
  const auto push = [&](double weight_a, double weight_b) {
    const LineOfCentres line = line_between(a, b);
    if (line.distance >= reach * kClose || !(weight_a + weight_b > 0)) return false;
    const double depth = reach - line.distance;
    const Vec2 move = depth / (line.length * (weight_a + weight_b)) * line.r;
    a.position -= weight_a * move;
    b.position += weight_b * move;
    free_a = !put_inside(a);
    free_b = !put_inside(b);
    act.depth = std::max(act.depth, depth);
    return true;
  };
  if (!push(a.inverse_mass, b.inverse_mass)) return std::nullopt;
  // First the one that no wall holds back, then the lighter one, then the smaller one.
  const auto comes_first = [](const effects::Member& m, bool free, const effects::Member& other,
                              bool other_free) {
    if (free != other_free) return free;
    if (m.inverse_mass != other.inverse_mass) return m.inverse_mass > other.inverse_mass;
    return m.radius < other.radius;
  };
  const bool a_first = comes_first(a, free_a, b, free_b);
  for (const bool push_a : {a_first, !a_first}) {
    push(push_a ? a.inverse_mass : 0, push_a ? 0 : b.inverse_mass);
  }
  return act;
}

}  // namespace carom
