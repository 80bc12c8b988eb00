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
  inverse_.resize(n);
  work_.resize(n);
  parts_.resize(n);
  head_.resize(n);
  next_.resize(n);
  cursor_.resize(n);
}

// The same right factor for many products: target -= left right', a column of the target at a time,
// of 2 x 2 blocks both at once.
template <int D>
class BlockCholesky<D>::Multiplier {
 public:
  explicit Multiplier(const Block& right) {
    for (int k = 0; k < D; ++k) {
      for (int column = 0; column < D; ++column) {
        for (int lane = 0; lane < kLanes; ++lane) {
          factors_[index((k * D + column) * kLanes + lane)] = right.at(column, k);
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

// How a row pushes a body, as a column: target += weight this other'.
template <int D>
class BlockCholesky<D>::Edge {
 public:
  using Lanes = decltype(Column<D>::lanes);
  /// A block in registers, a column each.
  struct Target {
    Lanes column[D];

    static Target of(const Block& block) {
      Target target;
      for (int c = 0; c < D; ++c) {
        target.column[c] = Column<D>::of(block.v.data() + c * kLanes).lanes;
      }
      return target;
    }
    void put(Block& block) const {
      for (int c = 0; c < D; ++c) Column<D>{column[c]}.put(block.v.data() + c * kLanes);
    }
  };

  Edge(const double (&j)[D], double side) {
    for (int c = 0; c < D; ++c) parts_[c] = c < 2 ? side * j[c] : j[c];
    if constexpr (D == 2) {
      lanes_ = Lanes{parts_[0], parts_[1]};
    } else {
      lanes_ = Lanes{parts_[0], parts_[1], parts_[2], 0};
    }
  }

  void add(double weight, const Edge& other, Target& target) const {
    const Lanes weighted = weight * lanes_;
    for (int c = 0; c < D; ++c) target.column[c] += weighted * other.parts_[c];
  }

 private:
  Lanes lanes_;
  double parts_[D];
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
    const int a = problem.rows[k].a;
    const int b = problem.rows[k].b;
    const bool a_is_later = b >= 0 && pattern_.place(a) > pattern_.place(b);
    Block& at_a = factor_[index(columns[pattern_.place(a)])];
    Block& at_b = b < 0 ? at_a : factor_[index(columns[pattern_.place(b)])];
    Block& between = b < 0 ? at_a : factor_[index(pattern_.between(k))];
    auto sum_a = Edge::Target::of(at_a);
    auto sum_b = Edge::Target::of(at_b);
    auto sum_between = Edge::Target::of(between);
    for (; k < problem.rows.size() && problem.rows[k].a == a && problem.rows[k].b == b; ++k) {
      const Edge of_a(problem.rows[k].j, -1);
      const Edge of_b(problem.rows[k].j, 1);
      of_a.add(weights[k], of_a, sum_a);
      of_b.add(weights[k], of_b, sum_b);
      (a_is_later ? of_a : of_b).add(weights[k], a_is_later ? of_b : of_a, sum_between);
    }
    if (b >= 0) {
      sum_b.put(at_b);
      sum_between.put(between);
    }
    sum_a.put(at_a);
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
      const Multiplier right(blocks[q]);
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
    const Multiplier inverse(inverse_[j]);
    for (int q = begin + 1; q < end; ++q) {
      Block x{};
      inverse.subtract(x, work[rows[q]]);
      for (double& value : x.v) value = -value;
      blocks[q] = x;
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
  Block c{};
  Block u{};
  for (int a = 0; a < D; ++a) {
    double s = w.at(a, a);
    for (int m = 0; m < a; ++m) s -= c.at(a, m) * c.at(a, m);
    const double pivot = std::sqrt(std::max(s, kLeastPivot * std::abs(w.at(a, a))));
    c.at(a, a) = pivot;
    u.at(a, a) = 1 / pivot;
    for (int i = a + 1; i < D; ++i) {
      double t = w.at(i, a);
      for (int m = 0; m < a; ++m) t -= c.at(i, m) * c.at(a, m);
      c.at(i, a) = t * u.at(a, a);
    }
  }
  for (int a = 0; a < D; ++a) {
    for (int i = a + 1; i < D; ++i) {
      double t = 0;
      for (int m = a; m < i; ++m) t -= c.at(i, m) * u.at(m, a);
      u.at(i, a) = t * u.at(i, i);
    }
  }
  factor_[index(pattern_.columns()[j])] = c;
  inverse_[j] = u;
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
    Part y{};
    for (int c = 0; c < D; ++c) {
      for (int e = c; e < D; ++e) y.v[index(e)] += inverse_[j].at(e, c) * parts_[j].v[index(c)];
    }
    parts_[j] = y;
    Column<D> factors[D];
    for (int c = 0; c < D; ++c) factors[c].lanes = factors[c].lanes + y.v[index(c)];
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
    Part y = parts_[j];
    for (int c = 0; c < D; ++c) {
      for (int e = 0; e < D; ++e) y.v[index(c)] -= sums[c].lanes[e];
    }
    Part out{};
    for (int c = 0; c < D; ++c) {
      for (int e = c; e < D; ++e) out.v[index(c)] += inverse_[j].at(e, c) * y.v[index(e)];
    }
    parts_[j] = out;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (int c = 0; c < D; ++c)
      x[i * D + index(c)] = parts_[index(pattern_.place(static_cast<int>(i)))].v[index(c)];
  }
}

template class BlockCholesky<2>;
template class BlockCholesky<3>;

}  // namespace carom::contact
