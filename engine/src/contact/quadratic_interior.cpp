#include "contact/quadratic_interior.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contact/dense_cholesky.hpp"

namespace carom::event {
namespace {

constexpr int kMostIterations = 60;
/// What is left of impulses times speeds is so small a part of what there was.
constexpr double kComplementary = 0x1p-66;
/// No iteration goes nearer to a bound than this part of the way.
constexpr double kWayToBound = 0.995;

/// The impulses of those contacts that may carry some, and how fast these let them part.
class Interior {
 public:
  Interior(const ResponseMatrix& response, const std::vector<double>& parting,
           const std::vector<char>& may, double give) {
    for (std::size_t k = 0; k < may.size(); ++k) {
      if (may[k] != 0) which_.push_back(k);
    }
    const std::size_t n = which_.size();
    double fastest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) matrix_.push_back(response.at(which_[i], which_[j]));
      matrix_[i * n + i] *= 1 + give;
      least_.push_back(std::max(give, 0x1p-52) * matrix_[i * n + i] / 2);
      pushes_.push_back(may[which_[i]] == kPushes ? 1 : 0);
      parting_.push_back(parting[which_[i]]);
      fastest = std::max(fastest, std::abs(parting_[i]));
    }
    for (std::size_t i = 0; i < n; ++i) {
      impulses_.push_back(pushes_[i] != 0 ? fastest / matrix_[i * n + i] : 0);
      speeds_.push_back(pushes_[i] != 0 ? fastest : 0);
    }
  }

  void solve() {
    const double had = complementarity(impulses_, speeds_);
    for (int k = 0; k < kMostIterations; ++k) {
      const double now = complementarity(impulses_, speeds_);
      if (!(now > kComplementary * had)) return;
      iterate(now);
    }
  }

  /// Those that push have an impulse and no speed, or the other way round.
  void note_carrying(std::vector<char>& carries) const {
    const std::size_t n = which_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool carried = impulses_[i] * matrix_[i * n + i] > speeds_[i];
      carries[which_[i]] = pushes_[i] == 0 || carried ? 1 : 0;
    }
  }

 private:
  /// The mean of impulse times speed.
  [[nodiscard]] double complementarity(const std::vector<double>& impulses,
                                       const std::vector<double>& speeds) const {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < which_.size(); ++i) {
      sum += impulses[i] * speeds[i];
      count += pushes_[i];
    }
    return count > 0 ? sum / count : 0;
  }

  // Newton's step to where all products are 0 says how far towards that the real one can aim, and
  // what it misses.
  void iterate(double now) {
    const std::size_t n = which_.size();
    factor();
    std::vector<double> missed(n);
    std::vector<double> products(n);
    for (std::size_t i = 0; i < n; ++i) {
      missed[i] = parting_[i] - speeds_[i];
      for (std::size_t j = 0; j < n; ++j) missed[i] += matrix_[i * n + j] * impulses_[j];
      products[i] = impulses_[i] * speeds_[i];
    }
    aim(missed, products);
    std::vector<double> impulses = impulses_;
    std::vector<double> speeds = speeds_;
    go(way(1), impulses, speeds);
    const double part = complementarity(impulses, speeds) / now;
    const double goal = part * part * part * now;
    for (std::size_t i = 0; i < n; ++i) {
      if (pushes_[i] != 0) products[i] += impulse_step_[i] * speed_step_[i] - goal;
    }
    aim(missed, products);
    go(way(kWayToBound), impulses_, speeds_);
  }

  void factor() {
    const std::size_t n = which_.size();
    factor_.reset(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) factor_.at(i, j) = matrix_[i * n + j];
      if (pushes_[i] != 0) factor_.at(i, i) += speeds_[i] / impulses_[i];
    }
    factor_.factor(least_);
  }

  // The step that takes away what is missed, and the products to first order.
  void aim(const std::vector<double>& missed, const std::vector<double>& products) {
    const std::size_t n = which_.size();
    impulse_step_.assign(n, 0.0);
    speed_step_.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      impulse_step_[i] = -missed[i];
      if (pushes_[i] != 0) impulse_step_[i] -= products[i] / impulses_[i];
    }
    factor_.solve(impulse_step_);
    for (std::size_t i = 0; i < n; ++i) {
      if (pushes_[i] == 0) continue;
      speed_step_[i] = -(products[i] + speeds_[i] * impulse_step_[i]) / impulses_[i];
    }
  }

  // How far the step can go, at most this part of the way to a bound.
  [[nodiscard]] double way(double part) const {
    double most = 1;
    for (std::size_t i = 0; i < which_.size(); ++i) {
      if (pushes_[i] == 0) continue;
      if (impulse_step_[i] < 0) most = std::min(most, -part * impulses_[i] / impulse_step_[i]);
      if (speed_step_[i] < 0) most = std::min(most, -part * speeds_[i] / speed_step_[i]);
    }
    return most;
  }

  void go(double part, std::vector<double>& impulses, std::vector<double>& speeds) const {
    for (std::size_t i = 0; i < which_.size(); ++i) {
      impulses[i] += part * impulse_step_[i];
      speeds[i] += part * speed_step_[i];
    }
  }

  // By contact that may carry:
  std::vector<std::size_t> which_;
  std::vector<char> pushes_;
  std::vector<double> matrix_;  ///< row by row
  std::vector<double> least_;   ///< see DenseCholesky
  std::vector<double> parting_;
  std::vector<double> impulses_;
  std::vector<double> speeds_;
  std::vector<double> impulse_step_;
  std::vector<double> speed_step_;
  DenseCholesky factor_;
};

}  // namespace

std::vector<char> carrying_contacts(const ResponseMatrix& response,
                                    const std::vector<double>& parting,
                                    const std::vector<char>& may, double give) {
  Interior interior(response, parting, may, give);
  interior.solve();
  std::vector<char> carries(may.size(), 0);
  interior.note_carrying(carries);
  return carries;
}

}  // namespace carom::event
