#pragma once

#include <vector>

namespace carom::accuracy {

struct MatrixEntry {
  int row = 0;
  int column = 0;
  double value = 0;
};

/// Find f >= 0 with the least |A f - b|.
struct LeastSquares {
  int rows = 0;
  int columns = 0;
  std::vector<MatrixEntry> matrix;  ///< A, each place once
  std::vector<double> target;       ///< b
};

/// The least |A f - b| over f >= 0; right to some 1e-9 |b|.
///
/// Source: S. Mehrotra, On the implementation of a primal-dual interior point method, SIAM J.
/// Optim. 2 (1992) 575; the Newton system is solved in the space of b, where it is sparse and
/// positive definite whatever the rank of A.
double least_residual(const LeastSquares& problem);

}  // namespace carom::accuracy
