#include "contact/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace carom::contact {
namespace {

constexpr double kCompliance = 0x1p-30;
constexpr int kTries = 8;
constexpr int kRefinements = 8;
constexpr double kFine = 0x1p-6;  // of the goal: where refining ends

}  // namespace

// Impulses by which the rows that carry stand still, with the matrix just factored; whether they
// do.
template <int D>
bool ActiveSet<D>::hold(const ContactProblem<D>& problem, BlockCholesky<D>& matrix,
                        const std::vector<char>& carries, double goal) {
  const std::size_t m = problem.rows.size();
  double last = INFINITY;
  for (int refinement = 0;; ++refinement) {
    problem.spread(f_, motion_, true);
    problem.gather(motion_, opening_);
    double worst = 0;
    for (std::size_t k = 0; k < m; ++k) {
      opening_[k] += problem.rows[k].q;
      if (carries[k] != 0) worst = std::max(worst, std::abs(opening_[k]));
    }
    if (worst < kFine * goal) return true;
    if (!(worst < last / 2) || refinement == kRefinements) return worst < goal / 2;
    last = worst;
    for (std::size_t k = 0; k < m; ++k) scratch_[k] = -weight_[k] * opening_[k];
    problem.spread(scratch_, change_, false);
    matrix.solve(change_);
    problem.gather(change_, opening_);
    for (std::size_t k = 0; k < m; ++k) f_[k] += scratch_[k] - weight_[k] * opening_[k];
  }
}

template <int D>
typename ActiveSet<D>::Outcome ActiveSet<D>::solve(const ContactProblem<D>& problem,
                                                   BlockCholesky<D>& matrix, double goal,
                                                   std::vector<char> carries,
                                                   std::vector<double>& impulses) {
  const std::size_t m = problem.rows.size();
  Outcome outcome;
  f_.assign(m, 0.0);
  weight_.resize(m);
  scratch_.resize(m);
  std::size_t fewest = m;
  while (outcome.factorisations < kTries) {
    for (std::size_t k = 0; k < m; ++k) {
      weight_[k] = carries[k] != 0 ? 1 / (kCompliance * problem.rows[k].w) : 0;
      if (carries[k] == 0) f_[k] = 0;
    }
    matrix.factor(problem, weight_);
    ++outcome.factorisations;
    if (!hold(problem, matrix, carries, goal)) return outcome;
    std::size_t changes = 0;
    for (std::size_t k = 0; k < m; ++k) {
      const bool pulls = carries[k] != 0 && f_[k] * problem.rows[k].w < -goal / 2;
      const bool closes = carries[k] == 0 && opening_[k] < -goal / 2;
      if (!pulls && !closes) continue;
      carries[k] = closes ? 1 : 0;
      ++changes;
    }
    if (changes == 0) break;
    if (outcome.factorisations > 2 && changes >= fewest) return outcome;
    fewest = std::min(fewest, changes);
  }
  for (double& f : f_) f = std::max(f, 0.0);
  outcome.solved = problem.residual(f_) < 2 * goal;
  if (outcome.solved) impulses = f_;
  return outcome;
}

template class ActiveSet<2>;
template class ActiveSet<3>;

}  // namespace carom::contact
