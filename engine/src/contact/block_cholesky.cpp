#include "contact/block_cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace carom::contact {
namespace {

// NOLINTBEGIN(modernize-use-using): `using` drops the attributes
typedef double Two __attribute__((vector_size(16), aligned(8), may_alias));
typedef double Four __attribute__((vector_size(32), aligned(8), may_alias));
// NOLINTEND(modernize-use-using)

const Two& two(const double* at) {
  return *reinterpret_cast<const Two*>(at);
}
const Four& four(const double* at) {
  return *reinterpret_cast<const Four*>(at);
}
Four& four(double* at) {
  return *reinterpret_cast<Four*>(at);
}

// A column of a block, or a part of the right side.
template <int D>
struct Column {
  Four lanes{};

  static Column of(const double* at) { return {four(at)}; }
  void put(double* at) const { four(at) = lanes; }
};
template <>
struct Column<2> {
  Two lanes{};

  static Column of(const double* at) { return {two(at)}; }
  void put(double* at) const { *reinterpret_cast<Two*>(at) = lanes; }
};

}  // namespace

template <int D>
void BlockCholesky<D>::analyse(const ContactProblem<D>& problem) {
  joined_.clear();
  for (const Row<D>& row : problem.rows) joined_.emplace_back(row.a, row.b);
  pattern_.analyse(problem.bodies(), joined_);
  const std::size_t n = pattern_.bodies();
  factor_.resize(pattern_.rows().size());
  pivots_.resize(n);
  work_.resize(n);
  parts_.resize(n);
  head_.resize(n);
  next_.resize(n);
  cursor_.resize(n);
}

// The same right factor for many products: target -= left P^-1 right', a column of the target at a
// time, of 2 x 2 blocks both at once.
template <int D>
class BlockCholesky<D>::Multiplier {
 public:
  Multiplier(const Block& right, const Pivots& pivots) {
    for (int k = 0; k < D; ++k) {
      for (int column = 0; column < D; ++column) {
        for (int lane = 0; lane < kLanes; ++lane) {
          factors_[index((k * D + column) * kLanes + lane)] =
              right.at(column, k) * pivots.inverse[index(k)];
        }
      }
    }
  }

  void subtract(Block& target, const Block& left) const {
    const double* l = left.v.data();
    const double* f = factors_.data();
    if constexpr (D == 2) {
      const Two first = two(l);
      const Two second = two(l + 2);
      Four t = four(target.v.data());
      t -= __builtin_shufflevector(first, first, 0, 1, 0, 1) * four(f);
      t -= __builtin_shufflevector(second, second, 0, 1, 0, 1) * four(f + 4);
      four(target.v.data()) = t;
    } else {
      for (int column = 0; column < D; ++column) {
        Four t = four(target.v.data() + column * kLanes);
        for (int k = 0; k < D; ++k) {
          t -= four(l + k * kLanes) * four(f + (k * D + column) * kLanes);
        }
        four(target.v.data() + column * kLanes) = t;
      }
    }
  }

 private:
  alignas(32) std::array<double, std::size_t{D} * D * kLanes> factors_{};
};

// What the rows of one contact add to the matrix: the sum of weight j j', a column each.  As the
// first body feels it x and y are turned round.
template <int D>
class BlockCholesky<D>::Stiffness {
 public:
  void add(const Row<D>& row, double weight) {
    Lanes j{row.j[0], row.j[1]};
    if constexpr (D == 3) j[2] = row.j[2];
    const Lanes weighted = weight * j;
    for (int c = 0; c < D; ++c) column_[c] += weighted * row.j[c];
  }
  /// Which bodies the rows and columns of the block are of.
  void add_to(Block& block, bool rows_of_first, bool columns_of_first) const {
    const double by_row = rows_of_first ? -1 : 1;
    const double by_column = columns_of_first ? -1 : 1;
    Lanes sign{by_row, by_row};
    if constexpr (D == 3) sign[2] = 1;
    for (int c = 0; c < D; ++c) {
      double* const at = block.v.data() + c * kLanes;
      auto column = Column<D>::of(at);
      column.lanes += (c < 2 ? by_column : 1) * (sign * column_[c]);
      column.put(at);
    }
  }

 private:
  using Lanes = decltype(Column<D>::lanes);
  Lanes column_[D]{};
};

template <int D>
void BlockCholesky<D>::factor(const ContactProblem<D>& problem,
                              const std::vector<double>& weights) {
  const std::size_t n = pattern_.bodies();
  const int* const columns = pattern_.columns().data();
  std::fill(factor_.begin(), factor_.end(), Block{});
  for (std::size_t i = 0; i < n; ++i) {
    Block& diagonal = factor_[index(columns[pattern_.place(static_cast<int>(i))])];
    for (int c = 0; c < D; ++c) diagonal.at(c, c) = 1 / problem.inverse_mass[i * D + index(c)];
  }
  // The rows of one contact follow each other.
  for (std::size_t k = 0; k < problem.rows.size();) {
    const std::size_t contact = k;
    const int a = problem.rows[k].a;
    const int b = problem.rows[k].b;
    Stiffness stiffness;
    for (; k < problem.rows.size() && problem.rows[k].a == a && problem.rows[k].b == b; ++k) {
      stiffness.add(problem.rows[k], weights[k]);
    }
    stiffness.add_to(factor_[index(columns[pattern_.place(a)])], true, true);
    if (b < 0) continue;
    stiffness.add_to(factor_[index(columns[pattern_.place(b)])], false, false);
    const bool a_is_later = pattern_.place(a) > pattern_.place(b);
    stiffness.add_to(factor_[index(pattern_.between(contact))], a_is_later, !a_is_later);
  }
  std::fill(head_.begin(), head_.end(), -1);
  // Stores of numbers leave these as they are, which a compiler cannot know of members.
  const int* const rows = pattern_.rows().data();
  Block* const blocks = factor_.data();
  Block* const work = work_.data();
  for (std::size_t j = 0; j < n; ++j) {
    const int begin = columns[j];
    const int end = columns[j + 1];
    for (int q = begin; q < end; ++q) work[rows[q]] = blocks[q];
    for (int k = head_[j]; k >= 0;) {
      const int following = next_[index(k)];
      int q = cursor_[index(k)];
      const int last = columns[k + 1];
      const Multiplier right(blocks[q], pivots_[index(k)]);
      for (int r = q; r < last; ++r) right.subtract(work[rows[r]], blocks[r]);
      cursor_[index(k)] = ++q;
      if (q < last) {
        const auto waits = index(rows[q]);
        next_[index(k)] = head_[waits];
        head_[waits] = k;
      }
      k = following;
    }
    factor_diagonal(j);
    const auto& solved = pivots_[j].solved;
    for (int q = begin + 1; q < end; ++q) {
      const double* const w = work[rows[q]].v.data();
      for (int c = 0; c < D; ++c) {
        auto column = Column<D>::of(w + c * kLanes);
        for (int m = 0; m < c; ++m) {
          column.lanes += Column<D>::of(w + m * kLanes).lanes * solved[index(c)][index(m)];
        }
        column.put(blocks[q].v.data() + c * kLanes);
      }
    }
    if (begin + 1 < end) {
      cursor_[j] = begin + 1;
      const auto waits = index(rows[begin + 1]);
      next_[j] = head_[waits];
      head_[waits] = static_cast<int>(j);
    }
  }
}

template <int D>
void BlockCholesky<D>::factor_diagonal(std::size_t j) {
  constexpr double kLeastPivot = 1e-15;
  const Block& w = work_[j];
  Pivots& pivots = pivots_[j];
  double l[D][D]{};
  double times_pivot[D][D]{};
  for (int a = 0; a < D; ++a) {
    for (int i = a; i < D; ++i) {
      double t = w.at(i, a);
      for (int m = 0; m < a; ++m) t -= l[i][m] * times_pivot[a][m];
      if (i == a) {
        pivots.inverse[index(a)] = 1 / std::max(t, kLeastPivot * std::abs(w.at(a, a)));
      } else {
        times_pivot[i][a] = t;
        l[i][a] = t * pivots.inverse[index(a)];
      }
    }
  }
  for (int a = 0; a < D; ++a) {
    for (int i = a + 1; i < D; ++i) {
      double t = -l[i][a];
      for (int m = a + 1; m < i; ++m) t -= l[i][m] * pivots.solved[index(m)][index(a)];
      pivots.solved[index(i)][index(a)] = t;
    }
  }
}

template <int D>
void BlockCholesky<D>::solve(std::vector<double>& x) {
  const std::size_t n = pattern_.bodies();
  const int* const columns = pattern_.columns().data();
  for (std::size_t i = 0; i < n; ++i) {
    for (int c = 0; c < D; ++c)
      parts_[index(pattern_.place(static_cast<int>(i)))].v[index(c)] = x[i * D + index(c)];
  }
  const int* const rows = pattern_.rows().data();
  const Block* const blocks = factor_.data();
  Part* const parts = parts_.data();
  for (std::size_t j = 0; j < n; ++j) {
    const Pivots& pivots = pivots_[j];
    Part& y = parts[j];
    for (int e = D - 1; e > 0; --e) {
      for (int c = 0; c < e; ++c)
        y.v[index(e)] += pivots.solved[index(e)][index(c)] * y.v[index(c)];
    }
    Column<D> factors[D];
    for (int c = 0; c < D; ++c) {
      factors[c].lanes = factors[c].lanes + y.v[index(c)] * pivots.inverse[index(c)];
    }
    for (int q = columns[j] + 1, end = columns[j + 1]; q < end; ++q) {
      const double* block = blocks[q].v.data();
      double* target = parts[rows[q]].v.data();
      auto t = Column<D>::of(target);
      for (int c = 0; c < D; ++c)
        t.lanes -= Column<D>::of(block + c * kLanes).lanes * factors[c].lanes;
      t.put(target);
    }
  }
  for (std::size_t j = n; j-- > 0;) {
    Column<D> sums[D];
    for (int q = columns[j] + 1, end = columns[j + 1]; q < end; ++q) {
      const double* block = blocks[q].v.data();
      const auto source = Column<D>::of(parts[rows[q]].v.data());
      for (int c = 0; c < D; ++c) {
        sums[c].lanes += Column<D>::of(block + c * kLanes).lanes * source.lanes;
      }
    }
    const Pivots& pivots = pivots_[j];
    Part& y = parts[j];
    for (int c = 0; c < D; ++c) {
      double sum = sums[c].lanes[0];
      for (int e = 1; e < D; ++e) sum += sums[c].lanes[e];
      y.v[index(c)] = (y.v[index(c)] - sum) * pivots.inverse[index(c)];
    }
    for (int c = 0; c < D; ++c) {
      for (int e = c + 1; e < D; ++e) {
        y.v[index(c)] += pivots.solved[index(e)][index(c)] * y.v[index(e)];
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (int c = 0; c < D; ++c)
      x[i * D + index(c)] = parts_[index(pattern_.place(static_cast<int>(i)))].v[index(c)];
  }
}

template class BlockCholesky<2>;
template class BlockCholesky<3>;

}  // namespace carom::contact
