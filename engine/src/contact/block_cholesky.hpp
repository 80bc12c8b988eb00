#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/contact_rows.hpp"
#include "contact/factor_pattern.hpp"

namespace carom::contact {

/// The factors of M + J' W J, one D x D block a body: the matrix of a contact problem in the space
/// of its bodies, W a weight for each row.  They are L P L', P diagonal: no square roots.
///
/// The pattern of the factor is worked out from the rows once, and serves for any weights.
/// REQUIRES: analyse() before factor(), factor() before solve().
template <int D>
class BlockCholesky {
 public:
  /// Costs next to nothing where the rows join the same bodies as the last time.
  void analyse(const ContactProblem<D>& problem);
  void factor(const ContactProblem<D>& problem, const std::vector<double>& weights);
  /// Turns the right side into the solution, in place.
  void solve(std::vector<double>& x);

 private:
  static constexpr int kLanes = D == 2 ? 2 : 4;  // a column of a block, padded to whole registers
  struct alignas(32) Block {
    std::array<double, std::size_t{D} * kLanes> v{};
    double& at(int row, int column) { return v[static_cast<std::size_t>(column * kLanes + row)]; }
    [[nodiscard]] double at(int row, int column) const {
      return v[static_cast<std::size_t>(column * kLanes + row)];
    }
  };
  struct alignas(16) Part {
    std::array<double, kLanes> v{};
  };
  /// The diagonal block of a column.
  struct Pivots {
    std::array<double, D> inverse{};                // of those of P
    std::array<std::array<double, D>, D> solved{};  // below the diagonal: the inverse of L's
  };
  class Multiplier;
  class Stiffness;

  void factor_diagonal(std::size_t j);

  FactorPattern pattern_;
  FactorPattern::Joined joined_;  // by row of the problem: its bodies
  std::vector<int> head_;
  std::vector<int> next_;
  std::vector<int> cursor_;
  std::vector<Block> factor_;
  std::vector<Pivots> pivots_;
  std::vector<Block> work_;
  std::vector<Part> parts_;
};

}  // namespace carom::contact
