#include "accuracy/nonnegative_least_squares.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace carom::accuracy {
namespace {

using Vector = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int kMostIterations = 100;
constexpr double kConverged = 1e-26;  // of the complementarity, in |b|^2: residuals of 1e-13
constexpr double kToTheWall = 0.995;  // part of the way to the nearest bound

/// The largest step along which x stays positive, at most 1.
double longest_step(const Vector& x, const Vector& dx) {
  double step = 1;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (dx[i] < 0) step = std::min(step, -kToTheWall * x[i] / dx[i]);
  }
  return step;
}

/// (D + A'A) x = r by Woodbury's formula, with I + A D^-1 A' factorised.
class NewtonSystem {
 public:
  explicit NewtonSystem(const Sparse& a) : a_(a), identity_(a.rows(), a.rows()) {
    identity_.setIdentity();
  }

  void factorise(const Vector& d) {
    inverse_ = d.cwiseInverse();
    const Sparse k = identity_ + a_ * inverse_.asDiagonal() * Sparse(a_.transpose());
    if (!analysed_) solver_.analyzePattern(k);
    analysed_ = true;
    solver_.factorize(k);
  }
  [[nodiscard]] Vector solve(const Vector& r) const {
    const Vector scaled = inverse_.cwiseProduct(r);
    const Vector inner = solver_.solve(a_ * scaled);
    return scaled - inverse_.cwiseProduct(a_.transpose() * inner);
  }

 private:
  const Sparse& a_;
  Sparse identity_;
  Vector inverse_;
  bool analysed_ = false;
  Eigen::SimplicialLDLT<Sparse> solver_;
};

}  // namespace

double least_residual(const LeastSquares& problem) {
  const Vector b = Eigen::Map<const Vector>(problem.target.data(), problem.rows);
  if (problem.columns == 0) return b.norm();
  std::vector<Eigen::Triplet<double>> entries;
  for (const MatrixEntry& each : problem.matrix)
    entries.emplace_back(each.row, each.column, each.value);
  Sparse a(problem.rows, problem.columns);
  a.setFromTriplets(entries.begin(), entries.end());

  const double size = b.norm();
  const auto n = static_cast<double>(problem.columns);
  Vector f = Vector::Constant(problem.columns, std::max(size, 1e-300));
  Vector z = f;
  NewtonSystem newton(a);
  double best = size;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const Vector residual = a * f - b;
    best = std::min(best, residual.norm());
    const Vector dual = a.transpose() * residual - z;
    const double mu = f.dot(z) / n;
    if (!(f.dot(z) > kConverged * size * size) && dual.norm() < 1e-12 * size) break;
    newton.factorise(z.cwiseQuotient(f));
    // Straight for the solution, to see how far that goes; then along a path that keeps off the
    // bounds.
    const Vector df0 = newton.solve(-dual - z);
    const Vector dz0 = -z - z.cwiseProduct(df0).cwiseQuotient(f);
    const double far = std::min(longest_step(f, df0), longest_step(z, dz0));
    const double mu0 = (f + far * df0).dot(z + far * dz0) / n;
    const double centring = std::pow(mu0 / mu, 3);
    const Vector push =
        (Vector::Constant(f.size(), centring * mu) - df0.cwiseProduct(dz0)).cwiseQuotient(f);
    const Vector df = newton.solve(-dual - z + push);
    const Vector dz = -z + push - z.cwiseProduct(df).cwiseQuotient(f);
    if (!df.allFinite() || !dz.allFinite()) break;
    f += longest_step(f, df) * df;
    z += longest_step(z, dz) * dz;
  }
  return best;
}

}  // namespace carom::accuracy
