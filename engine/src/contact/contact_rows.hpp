#pragma once

#include <cstddef>
#include <vector>

namespace carom::contact {

/// One inequality of a contact problem, as the velocities of its bodies enter it.
///
/// In the plane the friction cone |f_t| <= mu f_n has two edges, n + mu t and n - mu t: a contact
/// with friction is two rows, one without is a row along n. A body has D velocities: x, y and, with
/// friction (D = 3), its spin times its radius.
template <int D>
struct Row {
  int a = 0;
  int b = -1;     ///< less than 0: a wall or a fixed ball
  double j[D]{};  ///< as b feels it; a feels the same with x and y turned round
  double q = 0;   ///< how fast the contact opens along the row without an impulse
  double w = 0;   ///< how fast one unit of its impulse opens it
};

/// Find the least impulses f >= 0 by which no row closes: f >= 0, J M^-1 J' f + q >= 0, and one of
/// the two is 0 in every row.
template <int D>
struct ContactProblem {
  std::vector<double> inverse_mass;  ///< D for each body: 1/m, 1/m and 2/m for the spin
  std::vector<Row<D>> rows;

  [[nodiscard]] std::size_t bodies() const { return inverse_mass.size() / D; }

  /// Works out `w` of every row.
  void weigh();
  /// What the impulses do to the bodies: J' f, or M^-1 J' f.
  void spread(const std::vector<double>& impulses, std::vector<double>& motion, bool by_mass) const;
  /// How fast the motion of the bodies opens the rows: J v.
  void gather(const std::vector<double>& motion, std::vector<double>& opening) const;
  /// The largest speed by which the conditions are missed.
  [[nodiscard]] double residual(const std::vector<double>& impulses) const;
};

}  // namespace carom::contact
