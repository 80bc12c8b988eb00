#include "contact/factor_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <numeric>

namespace carom::contact {
namespace {

constexpr std::size_t kInAnyOrder = 3;  // bodies: so few fill nothing in

}  // namespace

void FactorPattern::analyse(std::size_t bodies, const Joined& joined) {
  if (bodies_ == bodies && joined_ == joined) return;
  bodies_ = bodies;
  joined_ = joined;
  find_neighbours();
  order_bodies();
  find_rows();
  between_.resize(joined_.size());
  for (std::size_t k = 0; k < joined_.size(); ++k) {
    const auto [a, b] = joined_[k];
    const bool again = k > 0 && joined_[k] == joined_[k - 1];
    between_[k] = b < 0 ? -1 : again ? between_[k - 1] : find(a, b);
  }
}

// The neighbours of each body in order, each once.
void FactorPattern::find_neighbours() {
  neighbours_.assign(bodies_ + 1, 0);
  for (const auto& [a, b] : joined_) {
    if (b < 0) continue;
    ++neighbours_[index(a)];
    ++neighbours_[index(b)];
  }
  std::exclusive_scan(neighbours_.begin(), neighbours_.end(), neighbours_.begin(), 0);
  neighbour_.resize(index(neighbours_.back()));
  mark_.assign(neighbours_.begin(), neighbours_.end());
  for (const auto& [a, b] : joined_) {
    if (b < 0) continue;
    neighbour_[index(mark_[index(a)]++)] = b;
    neighbour_[index(mark_[index(b)]++)] = a;
  }
  auto end = neighbour_.begin();
  for (std::size_t i = 0; i < bodies_; ++i) {
    const auto first = neighbour_.begin() + neighbours_[i];
    const auto last = neighbour_.begin() + neighbours_[i + 1];
    if (!std::is_sorted(first, last)) std::sort(first, last);
    neighbours_[i] = static_cast<int>(end - neighbour_.begin());
    end = std::unique_copy(first, last, end);
  }
  neighbours_[bodies_] = static_cast<int>(end - neighbour_.begin());
}

void FactorPattern::order_bodies() {
  const int n = static_cast<int>(bodies_);
  order_.resize(bodies_);
  std::iota(order_.begin(), order_.end(), 0);
  if (bodies_ > kInAnyOrder) {
    // The diagonal and what is below it.
    Eigen::SparseMatrix<double> lower(n, n);
    lower.resizeNonZeros(n + neighbours_.back());
    int* const starts = lower.outerIndexPtr();
    int* next = lower.innerIndexPtr();
    for (int i = 0; i < n; ++i) {
      starts[i] = static_cast<int>(next - lower.innerIndexPtr());
      *next++ = i;
      for (int k = neighbours_[index(i)]; k < neighbours_[index(i) + 1]; ++k) {
        if (neighbour_[index(k)] > i) *next++ = neighbour_[index(k)];
      }
    }
    starts[n] = static_cast<int>(next - lower.innerIndexPtr());
    std::fill_n(lower.valuePtr(), starts[n], 1.0);
    Eigen::PermutationMatrix<-1, -1, int> permutation;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), permutation);
    std::copy_n(permutation.indices().data(), bodies_, order_.begin());
  }
  place_.resize(bodies_);
  for (int i = 0; i < n; ++i) place_[index(order_[index(i)])] = i;
}

// Those of a column are those of its body's neighbours and of the columns whose first row it is.
void FactorPattern::find_rows() {
  const int n = static_cast<int>(bodies_);
  mark_.assign(bodies_, -1);
  first_child_.assign(bodies_, -1);
  next_child_.assign(bodies_, -1);
  column_.assign(bodies_ + 1, 0);
  row_.clear();
  for (int j = 0; j < n; ++j) {
    const auto begin = row_.size();
    row_.push_back(j);
    const auto add = [&](int i) {
      if (i <= j || mark_[index(i)] == j) return;
      mark_[index(i)] = j;
      row_.push_back(i);
    };
    const std::size_t body = index(order_[index(j)]);
    for (int k = neighbours_[body]; k < neighbours_[body + 1]; ++k) {
      add(place_[index(neighbour_[index(k)])]);
    }
    for (int child = first_child_[index(j)]; child >= 0; child = next_child_[index(child)]) {
      for (int q = column_[index(child)] + 1; q < column_[index(child) + 1]; ++q) {
        add(row_[index(q)]);
      }
    }
    std::sort(row_.begin() + static_cast<std::ptrdiff_t>(begin) + 1, row_.end());
    column_[index(j) + 1] = static_cast<int>(row_.size());
    if (row_.size() == begin + 1) continue;
    const std::size_t parent = index(row_[begin + 1]);
    next_child_[index(j)] = first_child_[parent];
    first_child_[parent] = j;
  }
}

int FactorPattern::find(int a, int b) const {
  const auto [j, i] = std::minmax(place_[index(a)], place_[index(b)]);
  const auto begin = row_.begin() + column_[index(j)];
  const auto end = row_.begin() + column_[index(j) + 1];
  return static_cast<int>(std::lower_bound(begin, end, i) - row_.begin());
}

}  // namespace carom::contact
