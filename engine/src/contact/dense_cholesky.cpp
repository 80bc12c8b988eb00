#include "contact/dense_cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace carom::event {

void DenseCholesky::reset(std::size_t size) {
  size_ = size;
  values_.assign(size * size, 0.0);
}

void DenseCholesky::factor(const std::vector<double>& least) {
  for (std::size_t i = 0; i < size_; ++i) {
    double* const row = &values_[i * size_];
    row[i] = std::sqrt(std::max(row[i], least[i]));
    for (std::size_t k = i + 1; k < size_; ++k) row[k] /= row[i];
    for (std::size_t j = i + 1; j < size_; ++j) {
      double* const below = &values_[j * size_];
      const double part = row[j];
      for (std::size_t k = j; k < size_; ++k) below[k] -= part * row[k];
    }
  }
}

void DenseCholesky::solve(std::vector<double>& side) const {
  for (std::size_t i = 0; i < size_; ++i) {
    const double* const row = &values_[i * size_];
    side[i] /= row[i];
    for (std::size_t k = i + 1; k < size_; ++k) side[k] -= side[i] * row[k];
  }
  for (std::size_t i = size_; i-- > 0;) {
    const double* const row = &values_[i * size_];
    for (std::size_t k = i + 1; k < size_; ++k) side[i] -= row[k] * side[k];
    side[i] /= row[i];
  }
}

}  // namespace carom::event
