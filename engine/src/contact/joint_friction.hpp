#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "contact/dissipation.hpp"
#include "contact/index.hpp"
#include "contact/joint_impact.hpp"
#include "contact/pair_friction.hpp"
#include "numbers/exact_sum.hpp"

namespace carom::event {

/// What is known of a joint impact beside its outcome.
template <class S>
struct JointRecord {
  std::vector<Stroke<S>> strokes;
  std::vector<carom::FrictionChange> by_friction;  ///< by contact; empty: there is no friction
  double held = 0;                                 ///< see JointReport
};

/// Friction at the contacts of one instant.
///
/// Rule: the joint impact without friction tells what each contact carries along its normal; every
/// contact that carries something has friction at once, at the slip it has before, by the part 1 /
/// n of its impulse, where n is the larger number of such contacts at its two balls; then the joint
/// impact is done.  A contact alone is an impact of two with friction, to the last bit.
/// Holds: friction adds no energy: a ball's energy is convex in its impulses, and their parts add
/// up to 1 at most.  Sums are rounded once, so that no order is seen.
template <class S>
class JointFriction {
 public:
  /// Coefficients of friction.
  struct Coefficients {
    double balls;
    double walls;
  };

  /// REQUIRES: a spin (counter-clockwise) and a radius for each body; of a fixed one the spin is 0.
  JointFriction(std::span<Body<S>> bodies, std::span<S> spins, std::span<const S> radii,
                std::span<const Contact<S>> contacts, const Coefficients& coefficients)
      : bodies_(bodies),
        spins_(spins),
        radii_(radii),
        contacts_(contacts),
        coefficients_(coefficients) {}

  /// Changes velocities and spins by friction alone; gives the impulse along the contact and the
  /// energy that it takes, by contact.
  std::vector<carom::FrictionChange> apply() {
    const std::vector<S> gains = normal_gains();
    const std::vector<int> shares = contacts_that_carry(gains);
    std::vector<Sums> sums(bodies_.size());
    std::vector<S> slips(gains.size(), S(0));
    std::vector<carom::FrictionChange> by_friction(gains.size());
    for (std::size_t k = 0; k < gains.size(); ++k) {
      const Contact<S>& c = contacts_[k];
      if (!(gains[k] > 0) || !(moves(c.a) || moves(c.b))) continue;
      const FrictionBody<S> a = disk(c.a);
      const FrictionBody<S> b = disk(c.b);
      const S coefficient = c.b == kWall ? coefficients_.walls : coefficients_.balls;
      const FrictionImpact<S> friction(a, b, c.r, gains[k], coefficient);
      const int most =
          std::max(moves(c.a) ? shares[index(c.a)] : 1, moves(c.b) ? shares[index(c.b)] : 1);
      slips[k] = slip(c);
      by_friction[k].impulse = static_cast<double>(S(friction.impulse() / most));
      const auto take = [&](int body, const FrictionBody<S>& of, int side) {
        if (!moves(body)) return;
        const FrictionChange<S> got = friction.on(of, side, S(S(1) / most));
        sums[index(body)].x.add(got.velocity.x);
        sums[index(body)].y.add(got.velocity.y);
        sums[index(body)].spin.add(got.spin);
      };
      take(c.a, a, -1);
      take(c.b, b, 1);
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      Vec<S>& v = bodies_[k].velocity;
      v = v + Vec<S>{sums[k].x.rounded(), sums[k].y.rounded()};
      spins_[k] += sums[k].spin.rounded();
    }
    for (std::size_t k = 0; k < slips.size(); ++k) {
      if (by_friction[k].impulse == 0) continue;
      by_friction[k].lost = lost_to_impulse(by_friction[k].impulse, static_cast<double>(slips[k]),
                                            static_cast<double>(slip(contacts_[k])));
    }
    return by_friction;
  }

 private:
  /// Of a body's change.
  struct Sums {
    ExactSum<S> x;
    ExactSum<S> y;
    ExactSum<S> spin;
  };

  [[nodiscard]] bool moves(int body) const {
    return body != kWall && bodies_[index(body)].inverse_mass != 0;
  }
  [[nodiscard]] FrictionBody<S> disk(int body) const {
    if (body == kWall) return {{S(0), S(0)}, S(0), S(0), S(0)};
    const std::size_t k = index(body);
    return {bodies_[k].velocity, spins_[k], radii_[k], bodies_[k].inverse_mass};
  }
  [[nodiscard]] std::vector<S> normal_gains() const {
    std::vector<Body<S>> bodies(bodies_.begin(), bodies_.end());
    JointImpact<S> normal(bodies, contacts_);
    normal.resolve();
    return normal.gains();
  }
  /// By body.
  [[nodiscard]] std::vector<int> contacts_that_carry(const std::vector<S>& gains) const {
    std::vector<int> many(bodies_.size(), 0);
    for (std::size_t k = 0; k < gains.size(); ++k) {
      if (!(gains[k] > 0)) continue;
      const Contact<S>& c = contacts_[k];
      if (moves(c.a)) ++many[index(c.a)];
      if (moves(c.b)) ++many[index(c.b)];
    }
    return many;
  }
  [[nodiscard]] S slip(const Contact<S>& c) const {
    const FrictionBody<S> a = disk(c.a);
    const FrictionBody<S> b = disk(c.b);
    const S length = root(S(c.r.x * c.r.x + c.r.y * c.r.y));
    return S(cross(c.r, b.velocity - a.velocity) / length -
             sum_of_products(a.radius, a.spin, b.radius, b.spin));
  }

  std::span<Body<S>> bodies_;
  std::span<S> spins_;
  std::span<const S> radii_;
  std::span<const Contact<S>> contacts_;
  Coefficients coefficients_;
};

/// Resolves what touches at one instant.  `friction`: null where balls have none.  `record`: null
/// where it is not wanted.  `stops`: see JointImpact.
template <class S>
JointReport resolve_jointly(std::span<Body<S>> bodies, std::span<const Contact<S>> contacts,
                            JointFriction<S>* friction, JointRecord<S>* record,
                            bool stops = false) {
  ExactSum<double> by_friction;
  if (friction != nullptr) {
    std::vector<carom::FrictionChange> changes = friction->apply();
    for (const carom::FrictionChange& change : changes) {
      if (change.impulse != 0) by_friction.add(change.lost);
    }
    if (record != nullptr) record->by_friction = std::move(changes);
  }
  JointImpact<S> impact(bodies, contacts, record == nullptr ? nullptr : &record->strokes, stops);
  JointReport report = impact.resolve();
  if (record != nullptr) record->held = report.held_energy;
  report.lost += by_friction.rounded();
  return report;
}

// In double it is compiled once, in joint_friction.cpp.
extern template class JointFriction<double>;
extern template JointReport resolve_jointly(std::span<Body<double>>,
                                            std::span<const Contact<double>>,
                                            JointFriction<double>*, JointRecord<double>*, bool);

}  // namespace carom::event
