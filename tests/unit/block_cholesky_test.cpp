#include "contact/block_cholesky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace carom::contact::block_cholesky_test {
namespace {

// Bodies of random masses and random rows between them, some twice, some with a wall.
template <int D>
ContactProblem<D> random_problem(std::mt19937& random, int bodies, int rows) {
  std::uniform_real_distribution<double> part(-1, 1);
  const auto below = [&random](int n) { return static_cast<int>(random() % unsigned(n)); };
  ContactProblem<D> problem;
  for (int i = 0; i < bodies * D; ++i) problem.inverse_mass.push_back(1.5 + part(random));
  while (static_cast<int>(problem.rows.size()) < rows) {
    Row<D> row;
    row.a = below(bodies);
    row.b = below(5) == 0 ? -1 : below(bodies);
    if (row.a == row.b) continue;
    for (double& j : row.j) j = part(random);
    problem.rows.push_back(row);
    for (double& j : row.j) j = part(random);
    if (below(3) == 0) problem.rows.push_back(row);
  }
  return problem;
}

// The matrix times x, by its definition.
template <int D>
std::vector<double> product(const ContactProblem<D>& problem, const std::vector<double>& weights,
                            const std::vector<double>& x) {
  std::vector<double> opening;
  problem.gather(x, opening);
  for (std::size_t k = 0; k < opening.size(); ++k) opening[k] *= weights[k];
  std::vector<double> result;
  problem.spread(opening, result, false);
  for (std::size_t i = 0; i < x.size(); ++i) result[i] += x[i] / problem.inverse_mass[i];
  return result;
}

template <int D>
void expect_solutions() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1, 1);
  BlockCholesky<D> matrix;  // the same for all, as a solver keeps it
  for (const int bodies : {2, 3, 4, 5, 9, 30, 200}) {
    for (int problems = 0; problems < 5; ++problems) {
      const ContactProblem<D> problem = random_problem<D>(random, bodies, 3 * bodies);
      matrix.analyse(problem);
      for (int weighed = 0; weighed < 2; ++weighed) {
        std::vector<double> weights;
        for (std::size_t k = 0; k < problem.rows.size(); ++k) {
          weights.push_back(std::exp2(5 * part(random)));
        }
        std::vector<double> wanted;
        for (int i = 0; i < bodies * D; ++i) wanted.push_back(part(random));
        std::vector<double> x = product(problem, weights, wanted);
        matrix.factor(problem, weights);
        matrix.solve(x);
        for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(x[i], wanted[i], 1e-9) << bodies;
      }
    }
  }
}

// Seen to fail where a row between two bodies was added to the block of the row before.
TEST(BlockCholesky, solves_for_any_rows_and_weights) {
  expect_solutions<2>();
  expect_solutions<3>();
}

}  // namespace
}  // namespace carom::contact::block_cholesky_test
