#include "contact/dense_cholesky.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::event::dense_cholesky_test {
namespace {

// (4 2 2; 2 5 3; 2 3 6) = L L', L = (2 0 0; 1 2 0; 1 1 2).
TEST(DenseCholesky, FactorsAndSolves) {
  DenseCholesky matrix;
  matrix.reset(3);
  const double rows[3][3] = {{4, 2, 2}, {0, 5, 3}, {0, 0, 6}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) matrix.at(i, j) = rows[i][j];
  }
  matrix.factor({0, 0, 0});
  EXPECT_EQ(matrix.at(0, 0), 2);
  EXPECT_EQ(matrix.at(1, 2), 1);
  EXPECT_EQ(matrix.at(2, 2), 2);
  std::vector<double> side{4 * 1 + 2 * 2 + 2 * 3, 2 * 1 + 5 * 2 + 3 * 3, 2 * 1 + 3 * 2 + 6 * 3};
  matrix.solve(side);
  EXPECT_EQ(side, (std::vector<double>{1, 2, 3}));
}

// Of a matrix of rank 1 nothing is left for the second pivot.
TEST(DenseCholesky, TakesTheLeastPivotThatItIsGiven) {
  DenseCholesky matrix;
  matrix.reset(2);
  matrix.at(0, 0) = matrix.at(0, 1) = matrix.at(1, 1) = 1;
  matrix.factor({0.25, 0.25});
  EXPECT_EQ(matrix.at(0, 0), 1);
  EXPECT_EQ(matrix.at(1, 1), 0.5);
}

}  // namespace
}  // namespace carom::event::dense_cholesky_test
