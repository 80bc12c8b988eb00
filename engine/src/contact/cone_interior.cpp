#include "contact/cone_interior.hpp"

#include <algorithm>
#include <cmath>

#include "contact/interior_point.hpp"

namespace carom::event {
namespace {

template <int D>
bool solve(const ConeResponse& response, const ConeResponse::Column& parting, double goal,
           bool again, ConeResponse::Column& result) {
  const ConeResponse::Column& inverse_mass = response.inverse_mass();
  double largest_inverse = 0;
  for (const double inverse : inverse_mass) largest_inverse = std::max(largest_inverse, inverse);
  const double unit = std::ldexp(1.0, -std::ilogb(largest_inverse));
  contact::ContactProblem<D> problem;
  for (std::size_t i = 0; i + 1 < inverse_mass.size(); ++i) {
    for (int c = 0; c < D; ++c) {
      problem.inverse_mass.push_back((c < 2 ? 1 : 2) * unit * inverse_mass[i]);
    }
  }
  const auto sides = [&response](std::size_t k) {
    return D == 3 && response.friction(k) != 0 ? 2U : 1U;
  };
  for (std::size_t k = 0; k < response.contacts(); ++k) {
    for (std::size_t side = 0; side < sides(k); ++side) {
      const double mu = (side == 0 ? 1 : -1) * response.friction(k);
      contact::Row<D> row;
      const auto [a, b] = response.ends(k);
      row.a = a;
      row.b = index(b) + 1 < inverse_mass.size() ? b : -1;
      row.j[0] = response.normal_x(k) - mu * response.normal_y(k);
      row.j[1] = response.normal_y(k) + mu * response.normal_x(k);
      if (D == 3) row.j[D - 1] = -mu;
      row.q = parting[side * response.size() + k] / response.scale(k);
      problem.rows.push_back(row);
    }
  }
  problem.weigh();
  // Kept for their memory; nothing of one problem shows in the next, but where it is solved again.
  thread_local contact::InteriorPoint<D> solver;
  thread_local std::vector<double> impulses;
  thread_local std::vector<double> last;
  last.swap(impulses);
  if (!solver.solve(problem, goal, impulses, again ? &last : nullptr).solved) return false;
  std::fill(result.begin(), result.end(), 0);
  std::size_t row = 0;
  for (std::size_t k = 0; k < response.contacts(); ++k) {
    for (std::size_t side = 0; side < sides(k); ++side) {
      result[side * response.size() + k] = unit * impulses[row++] / response.scale(k);
    }
  }
  return true;
}

}  // namespace

bool solve_by_interior_point(const ConeResponse& response, const ConeResponse::Column& parting,
                             double goal, bool again, ConeResponse::Column& impulses) {
  return response.has_friction() ? solve<3>(response, parting, goal, again, impulses)
                                 : solve<2>(response, parting, goal, again, impulses);
}

}  // namespace carom::event
