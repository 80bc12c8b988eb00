#pragma once

#include <cstddef>
#include <vector>

namespace carom::event {

/// Cholesky's factor of a full symmetric matrix: each row of its upper half is taken off the rows
/// below it, so that a processor does several of their numbers at once.
class DenseCholesky {
 public:
  /// A matrix of so many rows, of which only the upper half, `at` with row <= column, is asked for.
  void reset(std::size_t size);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double& at(std::size_t row, std::size_t column) {
    return values_[row * size_ + column];
  }
  /// The matrix becomes its factor.  `least`: what rounding may leave of a pivot, by row.
  void factor(const std::vector<double>& least);
  /// After `factor`: the solution takes the place of the right-hand side.
  void solve(std::vector<double>& side) const;

 private:
  std::size_t size_ = 0;
  std::vector<double> values_;  ///< row by row
};

}  // namespace carom::event
