#pragma once

#include "contact/dissipation.hpp"
#include "numbers/scalar.hpp"

namespace carom::event {

/// A disk with friction: uniform, of inertia m r^2 / 2.
template <class S>
struct FrictionBody {
  Vec<S> velocity;
  S spin;
  S radius;
  S inverse_mass;
};

/// What friction does to a disk.
template <class S>
struct FrictionChange {
  Vec<S> velocity;  ///< what is added to it
  S spin;
};

/// How fast two disks approach along r; negative: they part.
template <class S>
S approach_speed(const Vec<S>& r, const Vec<S>& v) {
  return -sharp_dot(r, v) / root(S(r.x * r.x + r.y * r.y));
}

/// The tangential impulse at a contact by Coulomb's law.
///
/// With n from a to b, t = (-n_y, n_x) and the slip u = (v_b - v_a).t - (r_a w_a + r_b w_b), the
/// impulse along t is the one that stops the slip, -u / (3 (1/m_a + 1/m_b)), cut off at the
/// coefficient times the normal impulse.  A wall is a disk with no spin and no inverse mass.
/// Holds: the same bits for (b, a, -r), and mirrored or swapped bits for mirrors and swapped axes.
template <class S>
class FrictionImpact {
 public:
  /// `gain`: the normal impulse, as the change of the approach speed it makes.
  /// REQUIRES: one of
  /// the two can move.
  FrictionImpact(const FrictionBody<S>& a, const FrictionBody<S>& b, const Vec<S>& r, const S& gain,
                 const S& coefficient)
      : along_{-r.y, r.x}, length_(root(S(r.x * r.x + r.y * r.y))) {
    const S slip = cross(r, b.velocity - a.velocity) / length_ -
                   sum_of_products(a.radius, a.spin, b.radius, b.spin);
    const S most = coefficient * gain;
    const S wanted = -slip / 3;
    const S cut = wanted > most ? most : (wanted < -most ? S(-most) : wanted);
    impulse_ = cut / (a.inverse_mass + b.inverse_mass);
    slip_ = slip;
    inverse_masses_ = a.inverse_mass + b.inverse_mass;
  }

  /// What it takes from the energy where nothing else touches the two.
  [[nodiscard]] double loss() const {
    return lost_to_friction(static_cast<double>(slip_), static_cast<double>(impulse_),
                            static_cast<double>(inverse_masses_));
  }

  /// Along t; b gains it, a loses it.
  [[nodiscard]] const S& impulse() const { return impulse_; }

  /// What it does to a (`side` -1) or to b (`side` 1), in so many parts of the whole.
  FrictionChange<S> on(const FrictionBody<S>& disk, int side, const S& part) const {
    const S change = part * impulse_ * disk.inverse_mass;
    const S by_length = side * change / length_;
    return {by_length * along_, S(-2 * change / disk.radius)};
  }

 private:
  Vec<S> along_;  ///< t times the length of r
  S length_;
  S impulse_;
  S slip_;
  S inverse_masses_;
};

}  // namespace carom::event
