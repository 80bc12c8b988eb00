#include "support/island_equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace carom::contact {
namespace {

// The forces are the impulses of bodies of mass 1 that fall with their weights for one unit of
// time: the least squares of what is left are the least motion.
template <int D>
double residual(const std::vector<IslandBody>& bodies, const std::vector<IslandContact>& contacts,
                const Vec2& acceleration) {
  double heaviest = 0;
  for (const IslandBody& body : bodies) heaviest = std::max(heaviest, 1 / body.inverse_mass);
  const auto weight = [&](int body) -> Vec2 {
    return 1 / bodies[static_cast<std::size_t>(body)].inverse_mass / heaviest * acceleration;
  };
  ContactProblem<D> problem;
  problem.inverse_mass.assign(bodies.size() * D, 1.0);
  for (const IslandContact& c : contacts) {
    const Vec2 t{-c.normal.y(), c.normal.x()};
    for (int side = 1; side >= (D == 2 ? 1 : -1); side -= 2) {
      const double mu = D == 3 ? side * c.friction : 0;
      Row<D> row;
      row.a = c.a;
      row.b = c.b;
      row.j[0] = c.normal.x() + mu * t.x();
      row.j[1] = c.normal.y() + mu * t.y();
      if (D == 3) row.j[D - 1] = -mu;
      const Vec2 j{row.j[0], row.j[1]};
      row.q = (c.b < 0 ? 0 : j.dot(weight(c.b))) - j.dot(weight(c.a));
      problem.rows.push_back(row);
      if (c.friction == 0) break;
    }
  }
  problem.weigh();
  InteriorPoint<D> solver;
  std::vector<double> forces;
  constexpr double kGoal = 0x1p-40;
  solver.solve(problem, kGoal * acceleration.norm(), forces);
  std::vector<double> motion;
  problem.spread(forces, motion, true);
  double left = 0;
  double all = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec2 w = weight(static_cast<int>(i));
    all += w.squaredNorm();
    left += (w + Vec2{motion[i * D], motion[i * D + 1]}).squaredNorm();
    if (D == 3) left += motion[i * D + D - 1] * motion[i * D + D - 1];
  }
  return std::sqrt(left / all);
}

}  // namespace

double equilibrium_residual(const std::vector<IslandBody>& bodies,
                            const std::vector<IslandContact>& contacts, bool spins,
                            const Vec2& acceleration) {
  return spins ? residual<3>(bodies, contacts, acceleration)
               : residual<2>(bodies, contacts, acceleration);
}

}  // namespace carom::contact
