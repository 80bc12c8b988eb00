#include "contact/impulse_guess.hpp"

#include <algorithm>
#include <cmath>

#include "contact/dense_cholesky.hpp"
#include "contact/quadratic_interior.hpp"

namespace carom::event {
namespace {

/// So many times in a row all wrong contacts are changed without there being fewer.
constexpr int kBlocks = 10;
/// So small a part of the largest speed, or impulse, is none.
constexpr double kSlack = 0x1p-44;

/// Equations of the contacts that carry, by Cholesky's factors.
class Carried {
 public:
  Carried(const ResponseMatrix& response, double give) : response_(response), give_(give) {}

  /// Impulses by which those that carry part no more.
  void solve(const std::vector<char>& carries, const std::vector<double>& parting,
             std::vector<double>& impulses) {
    which_.clear();
    for (std::size_t k = 0; k < carries.size(); ++k) {
      if (carries[k] != 0) which_.push_back(k);
    }
    const std::size_t n = which_.size();
    factor_.reset(n);
    column_.resize(n);
    least_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) factor_.at(i, j) = response_.at(which_[i], which_[j]);
      const double alone = factor_.at(i, i);
      factor_.at(i, i) += give_ * alone;
      least_[i] = give_ * alone / 2;
      column_[i] = -parting[which_[i]];
    }
    factor_.factor(least_);
    factor_.solve(column_);
    std::fill(impulses.begin(), impulses.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) impulses[which_[i]] = column_[i];
  }
  /// Those that carry, as an interior point tells them.
  [[nodiscard]] std::vector<char> sought(const std::vector<double>& parting,
                                         const std::vector<char>& may) const {
    return carrying_contacts(response_, parting, may, give_);
  }
  /// How fast contact `k` parts with them.
  [[nodiscard]] double parting(std::size_t k, const std::vector<double>& parting) const {
    double sum = parting[k];
    for (std::size_t i = 0; i < which_.size(); ++i) {
      sum += response_.at(k, which_[i]) * column_[i];
    }
    return sum;
  }

 private:
  const ResponseMatrix& response_;
  double give_;
  std::vector<std::size_t> which_;
  std::vector<double> least_;
  std::vector<double> column_;
  DenseCholesky factor_;
};

/// Finds which contacts carry: `carries` is where it starts, and what it finds.
std::vector<double> pivot(Carried& carried, const std::vector<double>& parting,
                          const std::vector<char>& may, std::vector<char>& carries) {
  const std::size_t n = may.size();
  double fastest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (may[k] != 0) fastest = std::max(fastest, -parting[k]);
  }
  std::vector<double> impulses(n, 0.0);
  std::size_t fewest = n + 1;
  int blocks = kBlocks;
  bool sought = false;
  std::vector<std::size_t> wrong;
  for (std::size_t pass = 0; pass < 8 * n + 64; ++pass) {
    carried.solve(carries, parting, impulses);
    double largest = 0;
    for (const double impulse : impulses) largest = std::max(largest, std::abs(impulse));
    wrong.clear();
    for (std::size_t k = 0; k < n; ++k) {
      if (may[k] != kPushes) continue;
      const bool is_wrong = carries[k] != 0 ? impulses[k] < -kSlack * largest
                                            : carried.parting(k, parting) < -kSlack * fastest;
      if (is_wrong) wrong.push_back(k);
    }
    if (wrong.empty()) break;
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      blocks = kBlocks;
    } else if (blocks > 0) {
      --blocks;
    }
    if (blocks == 0 && !sought) {
      sought = true;
      carries = carried.sought(parting, may);
      continue;
    }
    if (blocks == 0) wrong.erase(wrong.begin(), wrong.end() - 1);
    for (const std::size_t k : wrong) carries[k] = carries[k] != 0 ? 0 : 1;
  }
  return impulses;
}

}  // namespace

std::vector<double> guess_impulses(const ResponseMatrix& response,
                                   const std::vector<double>& parting, const std::vector<char>& may,
                                   double give, int refinements) {
  const std::size_t n = response.size();
  std::vector<char> carries(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    carries[k] = may[k] == kHolds || (may[k] == kPushes && parting[k] < 0) ? 1 : 0;
  }
  Carried carried(response, give);
  std::vector<double> impulses = pivot(carried, parting, may, carries);
  std::vector<double> from = parting;
  for (int round = 0; round < refinements; ++round) {
    for (std::size_t k = 0; k < n; ++k) {
      from[k] = parting[k] - give * response.at(k, k) * impulses[k];
    }
    impulses = pivot(carried, from, may, carries);
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (may[k] == kPushes) impulses[k] = std::max(impulses[k], 0.0);
  }
  return impulses;
}

}  // namespace carom::event
