#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "contact/index.hpp"

namespace carom::contact {

/// Where the blocks of a sparse symmetric matrix and of its Cholesky factor are: the order in which
/// bodies are eliminated, one of least fill (approximate minimum degree), and the rows of each
/// column of the factor.
///
/// Holds: a function of the bodies that are joined alone.
class FactorPattern {
 public:
  using Joined = std::vector<std::pair<int, int>>;

  /// `joined`: pairs of bodies that have a block off the diagonal, in any order, and any number of
  /// times; the second is less than 0 where there is none.  Costs next to nothing where they are
  /// the same as the last time.
  void analyse(std::size_t bodies, const Joined& joined);

  [[nodiscard]] std::size_t bodies() const { return bodies_; }
  /// By body: when it is eliminated.
  [[nodiscard]] int place(int body) const { return place_[index(body)]; }
  /// By place: where the column starts; its first block is the diagonal one.
  [[nodiscard]] const std::vector<int>& columns() const { return column_; }
  /// By block: the place of its row.
  [[nodiscard]] const std::vector<int>& rows() const { return row_; }
  /// The block off the diagonal of one of `joined`.
  [[nodiscard]] int between(std::size_t joined) const { return between_[joined]; }

 private:
  void find_neighbours();
  void order_bodies();
  void find_rows();
  [[nodiscard]] int find(int a, int b) const;

  std::size_t bodies_ = 0;
  Joined joined_;
  std::vector<int> place_, column_, row_, between_;
  std::vector<int> order_;                   // the bodies by place
  std::vector<int> neighbour_, neighbours_;  // of each body, and where those of each start
  std::vector<int> first_child_, next_child_, mark_;
};

}  // namespace carom::contact
