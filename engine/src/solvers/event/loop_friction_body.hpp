#pragma once

#include <algorithm>
#include <vector>

#include "contact/joint_impact.hpp"
#include "contact/pair_friction.hpp"
#include "numbers/exact_sum.hpp"
#include "solvers/event/event_loop.hpp"

namespace carom::event {

/// The impacts of one instant, with friction where balls have friction.
///
/// Rule: the joint impact without friction tells what each contact carries along its normal; every
/// contact that carries something has friction at once, at the slip it has before, by the part 1 /
/// n of its impulse, where n is the larger number of such contacts at its two balls; then the joint
/// impact is done.  A contact alone is an impact of two with friction, to the last bit.
/// Holds: friction
/// adds no energy: a ball's energy is convex in its impulses, and their parts add up to 1 at most.
/// Sums are rounded once, so that no order is seen.
template <class P>
JointReport EventLoop<P>::resolve(SimultaneousImpact& group, JointLog* log) const {
  const double by_friction = spins_.empty() ? 0 : apply_friction_jointly(group, log);
  JointImpact<S> impact(group.bodies, group.contacts, log == nullptr ? nullptr : &log->strokes);
  JointReport report = impact.resolve();
  if (log != nullptr) log->held = report.held_energy;
  report.lost += by_friction;
  return report;
}

template <class P>
double EventLoop<P>::apply_friction_jointly(SimultaneousImpact& group, JointLog* log) const {
  const auto& rules = motion_.rules();
  std::vector<Body<S>> bodies = group.bodies;
  JointImpact<S> normal(bodies, group.contacts);
  normal.resolve();
  const std::vector<S>& gains = normal.gains();

  const auto index = [](int body) { return static_cast<std::size_t>(body); };
  const auto moves = [&](int body) {
    return body != kWall && group.bodies[index(body)].inverse_mass != 0;
  };
  std::vector<int> has_friction(bodies.size(), 0);
  for (std::size_t k = 0; k < gains.size(); ++k) {
    if (!(gains[k] > 0)) continue;
    const Contact<S>& c = group.contacts[k];
    if (moves(c.a)) ++has_friction[index(c.a)];
    if (moves(c.b)) ++has_friction[index(c.b)];
  }
  const auto friction_body = [&](int body) -> FrictionBody<S> {
    if (body == kWall) return {{S(0), S(0)}, S(0), S(0), S(0)};
    const std::size_t k = index(body);
    return {group.bodies[k].velocity, group.spins[k],
            motion_.species(disks_[group.members[k]]).radius, group.bodies[k].inverse_mass};
  };
  struct Sums {
    ExactSum<S> x;
    ExactSum<S> y;
    ExactSum<S> spin;
  };
  std::vector<Sums> sums(bodies.size());
  const auto slip = [&](const Contact<S>& c) {
    const FrictionBody<S> a = friction_body(c.a);
    const FrictionBody<S> b = friction_body(c.b);
    const S length = root(S(c.r.x * c.r.x + c.r.y * c.r.y));
    return S(cross(c.r, b.velocity - a.velocity) / length -
             sum_of_products(a.radius, a.spin, b.radius, b.spin));
  };
  std::vector<S> slips(gains.size(), S(0));
  std::vector<carom::FrictionChange> by_friction(gains.size());
  for (std::size_t k = 0; k < gains.size(); ++k) {
    const Contact<S>& c = group.contacts[k];
    if (!(gains[k] > 0) || !(moves(c.a) || moves(c.b))) continue;
    const FrictionBody<S> a = friction_body(c.a);
    const FrictionBody<S> b = friction_body(c.b);
    const S coefficient = c.b == kWall ? rules.wall_friction : rules.friction;
    const FrictionImpact<S> friction(a, b, c.r, gains[k], coefficient);
    const int most = std::max(moves(c.a) ? has_friction[index(c.a)] : 1,
                              moves(c.b) ? has_friction[index(c.b)] : 1);
    slips[k] = slip(c);
    by_friction[k].impulse = static_cast<double>(S(friction.impulse() / most));
    const auto take = [&](int body, const FrictionBody<S>& disk, int side) {
      if (!moves(body)) return;
      const FrictionChange<S> got = friction.on(disk, side, S(S(1) / most));
      sums[index(body)].x.add(got.velocity.x);
      sums[index(body)].y.add(got.velocity.y);
      sums[index(body)].spin.add(got.spin);
    };
    take(c.a, a, -1);
    take(c.b, b, 1);
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    Vec<S>& v = group.bodies[k].velocity;
    v = v + Vec<S>{sums[k].x.rounded(), sums[k].y.rounded()};
    group.spins[k] += sums[k].spin.rounded();
  }
  ExactSum<double> lost;
  for (std::size_t k = 0; k < slips.size(); ++k) {
    if (by_friction[k].impulse == 0) continue;
    by_friction[k].lost = lost_to_impulse(by_friction[k].impulse, static_cast<double>(slips[k]),
                                          static_cast<double>(slip(group.contacts[k])));
    lost.add(by_friction[k].lost);
  }
  if (log != nullptr) log->by_friction = std::move(by_friction);
  return lost.rounded();
}

}  // namespace carom::event
