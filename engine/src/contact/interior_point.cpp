#include "contact/interior_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace carom::contact {
namespace {

constexpr int kCorrections = 2;
constexpr int kIterations = 45;
constexpr int kMoreIterations = 150;
constexpr double kCompliance = 1e-13;     // keeps the pivots positive
constexpr double kAlmost = 0.995;         // of the way to the border
constexpr double kDiffers = 4;            // times the mean by which a problem differs from the last
constexpr double kClosesSlowly = 0x1p12;  // a gap that closes slower than this many goals
constexpr int kUnknown = 2;               // iterations that tell nothing of the motion
constexpr std::size_t kFew = 256;         // rows; of more, guesses fail too often

}  // namespace

template <int D>
void InteriorPoint<D>::start(const ContactProblem<D>& problem, double impulse, double speed) {
  const std::size_t m = problem.rows.size();
  for (std::size_t k = 0; k < m; ++k) {
    x_[k] = impulse * speed / problem.rows[k].w;
    y_[k] = std::max(problem.rows[k].q, speed);
  }
  problem.spread(x_, motion_, true);
}

template <int D>
bool InteriorPoint<D>::start_on_the_way(const ContactProblem<D>& problem) {
  const std::size_t m = problem.rows.size();
  double square = 0;
  for (std::size_t k = 0; k < m; ++k) {
    const double change = problem.rows[k].q - way_q_[k];
    square += change * change;
  }
  const double differs = kDiffers * std::sqrt(square / static_cast<double>(m));
  std::size_t last = way_length_;
  while (last > 0 && way_[last - 1].miss < differs) --last;
  if (last == 0) return false;
  x_ = way_[last - 1].x;
  y_ = way_[last - 1].y;
  follow_speeds(problem);
  problem.spread(x_, motion_, true);
  return true;
}

template <int D>
void InteriorPoint<D>::note_speeds(const ContactProblem<D>& problem) {
  way_q_.resize(problem.rows.size());
  for (std::size_t k = 0; k < way_q_.size(); ++k) way_q_[k] = problem.rows[k].q;
}

// So that no more is missed than before.
template <int D>
void InteriorPoint<D>::follow_speeds(const ContactProblem<D>& problem) {
  for (std::size_t k = 0; k < y_.size(); ++k) {
    y_[k] = std::max(y_[k] + problem.rows[k].q - way_q_[k], y_[k] / 4);
  }
}

template <int D>
void InteriorPoint<D>::direction(const ContactProblem<D>& problem, Column& dx, Column& dy) {
  const std::size_t m = x_.size();
  for (std::size_t k = 0; k < m; ++k) {
    scratch_[k] = weight_[k] * (target_[k] * inverse_x_[k] - miss_[k]);
  }
  problem.spread(scratch_, change_, false);
  matrix_.solve(change_);
  problem.gather(change_, opening_);
  for (std::size_t k = 0; k < m; ++k) {
    dx[k] = scratch_[k] - weight_[k] * opening_[k];
    dy[k] = (target_[k] - y_[k] * dx[k]) * inverse_x_[k];
  }
}

// In lanes and without branches: which row comes first cannot be foreseen.
template <int D>
double InteriorPoint<D>::longest(const Column& dx, const Column& dy, double part) const {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> fastest{};
  const std::size_t m = x_.size();
  const auto look = [&](std::size_t k, std::size_t lane) {
    const double of_x = -dx[k] * inverse_x_[k];
    const double of_y = -dy[k] / y_[k];
    const double faster = of_x > of_y ? of_x : of_y;
    fastest[lane] = faster > fastest[lane] ? faster : fastest[lane];
  };
  std::size_t k = 0;
  for (; k + kLanes <= m; k += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) look(k + lane, lane);
  }
  for (; k < m; ++k) look(k, 0);
  const double most = *std::max_element(fastest.begin(), fastest.end());
  return most > part ? part / most : 1;
}

template <int D>
int InteriorPoint<D>::iterate(const ContactProblem<D>& problem, double goal, int most,
                              const Revision& revise) {
  const std::size_t m = x_.size();
  const auto count = static_cast<double>(m);
  for (int iteration = 0; iteration < most; ++iteration) {
    problem.gather(motion_, opening_);
    if (revise && iteration >= kUnknown) {
      note_speeds(problem);
      revise(motion_, way_[way_length_ - 1].miss);
      follow_speeds(problem);
    }
    double mean = 0;
    double gap = 0;
    double worst = 0;
    for (std::size_t k = 0; k < m; ++k) {
      miss_[k] = opening_[k] + problem.rows[k].q - y_[k];
      mean += x_[k] * y_[k];
      gap = std::max(gap, std::min(x_[k] * problem.rows[k].w, y_[k]));
      worst = std::max(worst, std::abs(miss_[k]));
    }
    mean /= count;
    if (!std::isfinite(mean) || (gap < goal / 2 && worst < goal / 2)) return iteration;
    if (way_.size() == way_length_) way_.emplace_back();
    Waypoint& here = way_[way_length_++];
    here.x = x_;
    here.y = y_;
    here.miss = std::max(gap, worst);
    for (std::size_t k = 0; k < m; ++k) {
      inverse_x_[k] = 1 / x_[k];
      weight_[k] = 1 / (y_[k] * inverse_x_[k] + kCompliance * problem.rows[k].w);
    }
    matrix_.factor(problem, weight_);

    for (std::size_t k = 0; k < m; ++k) target_[k] = -x_[k] * y_[k];
    direction(problem, dx_, dy_);
    double length = longest(dx_, dy_, 1);
    double ahead = 0;
    for (std::size_t k = 0; k < m; ++k) {
      ahead += (x_[k] + length * dx_[k]) * (y_[k] + length * dy_[k]);
    }
    const double ratio = ahead / count / mean;
    const double centre = ratio * ratio * ratio * mean;
    for (std::size_t k = 0; k < m; ++k) target_[k] += centre - dx_[k] * dy_[k];
    direction(problem, dx_, dy_);
    length = longest(dx_, dy_, kAlmost);
    for (int correction = 0; correction < kCorrections && length < 0.9; ++correction) {
      const double farther = std::min(1.0, length + 0.2);
      const double low = 0.1 * centre;
      const double high = 10 * centre;
      for (std::size_t k = 0; k < m; ++k) {
        const double product = (x_[k] + farther * dx_[k]) * (y_[k] + farther * dy_[k]);
        if (product < low) {
          target_[k] += low - product;
        } else if (product > high) {
          target_[k] += std::max(high - product, -high);
        }
      }
      direction(problem, other_dx_, other_dy_);
      const double other = longest(other_dx_, other_dy_, kAlmost);
      if (other < length + 0.01) break;
      dx_.swap(other_dx_);
      dy_.swap(other_dy_);
      length = other;
    }
    for (std::size_t k = 0; k < m; ++k) {
      x_[k] += length * dx_[k];
      y_[k] += length * dy_[k];
    }
    problem.spread(x_, motion_, true);
  }
  return most;
}

template <int D>
bool InteriorPoint<D>::guess(const ContactProblem<D>& problem, double goal,
                             std::vector<char> carries, std::vector<double>& impulses,
                             Outcome& outcome) {
  const auto tried = active_.solve(problem, matrix_, goal, std::move(carries), impulses);
  outcome.factorisations += tried.factorisations;
  if (!tried.solved) return false;
  outcome.residual = problem.residual(impulses);
  outcome.solved = true;
  return true;
}

template <int D>
typename InteriorPoint<D>::Outcome InteriorPoint<D>::solve(const ContactProblem<D>& problem,
                                                           double goal,
                                                           std::vector<double>& impulses,
                                                           const std::vector<double>* like,
                                                           const Revision& revise) {
  const std::size_t m = problem.rows.size();
  std::vector<char> first(m);
  for (std::size_t k = 0; k < m; ++k) {
    const bool carries =
        like != nullptr ? (*like)[k] > 0 : problem.rows[k].q < kClosesSlowly * goal;
    first[k] = carries ? 1 : 0;
  }
  impulses.assign(m, 0.0);
  Outcome best;
  best.residual = problem.residual(impulses);
  const bool resumes = like != nullptr && way_q_.size() == m;
  if (!resumes) way_q_.clear();
  if (m == 0 || best.residual < goal) return best;
  matrix_.analyse(problem);
  if (m <= kFew && guess(problem, goal, std::move(first), impulses, best)) return best;
  for (Column* column : {&x_, &y_, &dx_, &dy_, &other_dx_, &other_dy_, &inverse_x_, &weight_,
                         &miss_, &target_, &scratch_, &opening_}) {
    column->resize(m);
  }
  double fastest = goal;
  for (const Row<D>& row : problem.rows) fastest = std::max(fastest, std::abs(row.q));
  Column found(m);
  for (const double larger : {1.0, 1e3, 1e6}) {
    const bool on_the_way = larger == 1 && resumes && start_on_the_way(problem);
    if (!on_the_way) start(problem, larger, 0.1 * fastest);
    way_length_ = 0;
    const int most = larger == 1 ? kIterations : kMoreIterations;
    best.factorisations += iterate(problem, goal, most, revise);
    bool finite = true;
    for (std::size_t k = 0; k < m; ++k) {
      finite = finite && std::isfinite(x_[k]);
      found[k] = x_[k] * problem.rows[k].w > y_[k] ? x_[k] : 0;
    }
    const double residual = finite ? problem.residual(found) : best.residual;
    if (finite && residual < best.residual) {
      best.residual = residual;
      impulses = found;
    }
    best.solved = best.residual < 2 * goal;
    if (best.solved) break;
  }
  note_speeds(problem);
  return best;
}

template class InteriorPoint<2>;
template class InteriorPoint<3>;

}  // namespace carom::contact
