#include "contact/cone_guess.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "contact/cone_interior.hpp"
#include "contact/index.hpp"
#include "numbers/double_double.hpp"

namespace carom::event {
namespace {

/// Contacts give way by this part of what they do in ConeDescent, so that it is soon taken back.
constexpr double kGivesLess = 0x1p-7;
constexpr int kMostTakenBack = 64;
/// What is taken back falls at least so from one time to the next, or no impulses can stop it.
constexpr double kFalls = 63.0 / 64;
/// How often a solution is corrected, and after which change, as a part of the largest impulse.
constexpr int kMostCorrections = 24;
constexpr double kNoise = 0x1p-60;
/// How many bits of the largest impulse are kept, and so, no smaller ones, of the others: what
/// rounding leaves in double-double, where contacts are dependent, is far below.
constexpr int kBits = 46;

/// How well the equations are solved, as a part of the largest impulse, and how small a part of the
/// largest speed, or impulse, is none then.
struct Fineness {
  double solved;
  double nothing;
};
constexpr Fineness kRough{0x1p-40, 0x1p-30};
constexpr Fineness kFine{0x1p-84, 0x1p-64};

using Wide = DoubleDouble;

class ConeGuess {
 public:
  ConeGuess(const ConeResponse& response, const ConeResponse::Column& parting,
            const ConeResponse::Column& impulses)
      : response_(response), give_(response.give() * kGivesLess) {
    list_edges(parting);
    fill_matrix();
    for (const Edge& edge : edges_) {
      impulses_.emplace_back(impulses[edge.number]);
      carries_.push_back(impulses[edge.number] > 0 ? 1 : 0);
      fastest_ = std::max(fastest_, std::abs(edge.parting));
    }
    anchor_.assign(edges_.size(), Wide(0));
    speeds_.assign(edges_.size(), Wide(0));
  }

  bool find(double goal) {
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostTakenBack; ++round) {
      if (!descend()) return false;
      double most = 0;
      for (std::size_t i = 0; i < edges_.size(); ++i) {
        most = std::max(most, give_ * std::abs((impulses_[i] - anchor_[i]).high));
      }
      anchor_ = impulses_;
      if (!(most > goal / 16) || !(most < kFalls * last)) break;
      last = most;
    }
    return true;
  }

  void write(ConeResponse::Column& impulses) const {
    std::fill(impulses.begin(), impulses.end(), 0);
    const double grid = std::ldexp(1.5, std::ilogb(largest()) + 53 - kBits);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const double impulse = impulses_[i].high;
      if (impulse > 0) impulses[edges_[i].number] = (impulse + grid) - grid;
    }
  }

 private:
  struct Edge {
    std::size_t number;  ///< in columns
    int a;
    int b;
    double x;  ///< what its impulse does to b, and, but for its sign, to a
    double y;
    double turning;  ///< to both
    double parting;
  };
  struct Moved {
    Wide x = Wide(0);
    Wide y = Wide(0);
    Wide turning = Wide(0);
  };

  void list_edges(const ConeResponse::Column& parting) {
    for (std::size_t side = 0; side * response_.size() < response_.edges(); ++side) {
      for (std::size_t k = 0; k < response_.contacts(); ++k) {
        const double s = response_.scale(k);
        const double mu = side == 0 ? response_.friction(k) : -response_.friction(k);
        const double nx = response_.normal_x(k);
        const double ny = response_.normal_y(k);
        const auto [a, b] = response_.ends(k);
        const std::size_t number = side * response_.size() + k;
        edges_.push_back(
            {number, a, b, s * (nx - mu * ny), s * (ny + mu * nx), -(s * mu), parting[number]});
      }
    }
  }

  void fill_matrix() {
    const auto n = static_cast<Eigen::Index>(edges_.size());
    matrix_.setZero(n, n);
    const std::size_t bodies = response_.inverse_mass().size();
    std::vector<std::vector<std::size_t>> at_body(bodies);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      at_body[index(edges_[i].a)].push_back(i);
      at_body[index(edges_[i].b)].push_back(i);
    }
    for (std::size_t body = 0; body < bodies; ++body) {
      const double mobility = response_.inverse_mass()[body];
      if (mobility == 0) continue;
      for (const std::size_t i : at_body[body]) {
        for (const std::size_t j : at_body[body]) {
          const Edge& e = edges_[i];
          const Edge& f = edges_[j];
          const bool same = (index(e.b) == body) == (index(f.b) == body);
          const double along = e.x * f.x + e.y * f.y;
          matrix_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
              mobility * ((same ? along : -along) + 2 * e.turning * f.turning);
        }
      }
    }
    own_ = n > 0 ? matrix_.diagonal().maxCoeff() : 0;
    matrix_.diagonal().array() += give_;
  }

  [[nodiscard]] double largest() const {
    double most = 0;
    for (const Wide& impulse : impulses_) most = std::max(most, std::abs(impulse.high));
    return most;
  }

  /// How fast each edge parts with the impulses.
  void find_speeds() {
    const ConeResponse::Column& mobility = response_.inverse_mass();
    moved_.assign(mobility.size(), Moved{});
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (carries_[i] == 0) continue;
      const Edge& e = edges_[i];
      const Wide x = Wide(e.x) * impulses_[i];
      const Wide y = Wide(e.y) * impulses_[i];
      Moved& a = moved_[index(e.a)];
      Moved& b = moved_[index(e.b)];
      a.x = a.x - x;
      a.y = a.y - y;
      b.x = b.x + x;
      b.y = b.y + y;
      if (e.turning == 0) continue;
      const Wide turning = Wide(e.turning) * impulses_[i];
      a.turning = a.turning + turning;
      b.turning = b.turning + turning;
    }
    for (std::size_t body = 0; body < mobility.size(); ++body) {
      Moved& m = moved_[body];
      m = {Wide(mobility[body]) * m.x, Wide(mobility[body]) * m.y,
           Wide(2 * mobility[body]) * m.turning};
    }
    const Wide give(give_);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Edge& e = edges_[i];
      const Moved& a = moved_[index(e.a)];
      const Moved& b = moved_[index(e.b)];
      Wide speed = Wide(e.parting) + give * (impulses_[i] - anchor_[i]);
      speed = speed + Wide(e.x) * (b.x - a.x) + Wide(e.y) * (b.y - a.y);
      if (e.turning != 0) speed = speed + Wide(e.turning) * (a.turning + b.turning);
      speeds_[i] = speed;
    }
  }

  void factor() {
    if (factored_ == carries_) return;
    factored_ = carries_;
    which_.clear();
    for (std::size_t i = 0; i < carries_.size(); ++i) {
      if (carries_[i] != 0) which_.push_back(static_cast<Eigen::Index>(i));
    }
    const Eigen::MatrixXd carried = matrix_(which_, which_);
    factors_.compute(carried);
  }

  /// Impulses by which what carries parts no more, and the speeds with them; whether they are
  /// found.
  bool solve(double fine) {
    factor();
    Eigen::VectorXd rest(static_cast<Eigen::Index>(which_.size()));
    double last = std::numeric_limits<double>::infinity();
    for (int correction = 0; correction < kMostCorrections; ++correction) {
      find_speeds();
      if (which_.empty()) return true;
      for (std::size_t k = 0; k < which_.size(); ++k) {
        rest[static_cast<Eigen::Index>(k)] = -speeds_[static_cast<std::size_t>(which_[k])].high;
      }
      const Eigen::VectorXd change = factors_.solve(rest);
      for (std::size_t k = 0; k < which_.size(); ++k) {
        Wide& impulse = impulses_[static_cast<std::size_t>(which_[k])];
        impulse = impulse + Wide(change[static_cast<Eigen::Index>(k)]);
      }
      const double changed = change.cwiseAbs().maxCoeff();
      if (!std::isfinite(changed)) return false;
      // Where contacts are dependent rounding in double-double remains.
      const bool noise = changed <= kNoise * largest() && changed > last / 4;
      if (!(changed > fine * largest()) || noise) {
        find_speeds();
        return true;
      }
      last = changed;
    }
    return false;
  }

  /// From impulses that do not pull back to the first that would on the way to those now, which
  /// leaves; whether there is one.
  bool leave(const std::vector<Wide>& from, double nothing) {
    const double least = nothing * largest();
    const auto until = [&](std::size_t i) {
      return from[i].high / (from[i].high - impulses_[i].high);
    };
    double part = 1;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (impulses_[i].high < -least) part = std::min(part, until(i));
    }
    if (!(part < 1)) return false;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const bool leaves = impulses_[i].high < -least && !(until(i) > part);
      impulses_[i] = from[i] + Wide(part) * (impulses_[i] - from[i]);
      if (leaves) carries_[i] = 0;
      if (leaves || impulses_[i].high < 0) impulses_[i] = Wide(0);
    }
    return true;
  }

  /// Lets in what closes; whether anything does.
  bool enter(double nothing) {
    const double slowest = nothing * std::max(fastest_, own_ * largest());
    bool enters = false;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (carries_[i] != 0 || !(speeds_[i].high < -slowest)) continue;
      carries_[i] = 1;
      enters = true;
    }
    return enters;
  }

  /// Finds which edges carry, and how much, until contacts give way to it; whether it ends.
  bool descend() {
    Fineness fine = kRough;
    for (std::size_t pass = 0; pass < 4 * edges_.size() + 16; ++pass) {
      const std::vector<Wide> from = impulses_;
      if (!solve(fine.solved)) return false;
      if (leave(from, fine.nothing) || enter(fine.nothing)) continue;
      if (fine.solved == kFine.solved) return true;
      fine = kFine;
    }
    return false;
  }

  const ConeResponse& response_;
  double give_;
  std::vector<Edge> edges_;
  Eigen::MatrixXd matrix_;
  double fastest_ = 0;
  double own_ = 0;  ///< the largest response of an edge to itself
  std::vector<char> carries_;
  std::vector<char> factored_;  ///< what carries in `factors_`
  std::vector<Eigen::Index> which_;
  Eigen::LLT<Eigen::MatrixXd> factors_;
  std::vector<Wide> impulses_, anchor_, speeds_;
  std::vector<Moved> moved_;
};

}  // namespace

bool guess_cone_impulses(const ConeResponse& response, const ConeResponse::Column& parting,
                         double goal, ConeResponse::Column& impulses) {
  if (response.edges() > kMostEdgesGuessed) return false;
  ConeResponse::Column from = impulses;
  solve_by_interior_point(response, parting, goal / 16, false, from);
  ConeGuess guess(response, parting, from);
  if (!guess.find(goal)) return false;
  guess.write(impulses);
  return true;
}

}  // namespace carom::event
