#pragma once

#include <functional>
#include <vector>

#include "contact/active_set.hpp"
#include "contact/block_cholesky.hpp"
#include "contact/contact_rows.hpp"

namespace carom::contact {

/// Solves contact problems: min 1/2 f' W f + q' f over f >= 0, W = J M^-1 J'.
///
/// A primal-dual interior point with Mehrotra's predictor and Gondzio's correctors; its Newton
/// system is solved in the space of the bodies, (M + J' D J) dv = r, because W of a settled pile is
/// nearly singular and M + J' D J is not. A start that stalls (a ball a million times heavier than
/// the next) is tried again with larger impulses.  Where rows are few an active set comes first:
/// which of many rows carry an impulse can mostly not be guessed.
///
/// Holds: the answer is a function of the problem alone, and of how it is revised, or, with `like`,
/// of that and the problem solved before.
/// Source: Mehrotra, SIAM J. Optim. 2 (1992) 575; Gondzio, Comput. Optim. Appl. 6 (1996) 137.
template <int D>
class InteriorPoint {
 public:
  struct Outcome {
    bool solved = true;
    double residual = 0;  ///< the largest speed by which the conditions are missed
    int factorisations = 0;
  };

  /// Changes the speeds `q` of the problem on the way to its answer, by what the impulses there do
  /// to the bodies, and the speed by which they miss the conditions.
  using Revision = std::function<void(const std::vector<double>& motion, double miss)>;

  /// The least impulses >= 0 after which no row closes faster than `goal`, a speed.  `like`: those
  /// of the problem solved just before, if it has the same rows and differs little.  `revise`: not
  /// asked where a guess does.
  Outcome solve(const ContactProblem<D>& problem, double goal, std::vector<double>& impulses,
                const std::vector<double>* like = nullptr, const Revision& revise = {});

 private:
  using Column = std::vector<double>;

  /// An iterate on the way to the last answer.
  struct Waypoint {
    Column x, y;
    double miss = 0;  // the speed by which it missed the conditions
  };

  /// Starts from where the way to the last answer missed its conditions by as much as `problem`
  /// differs from that one; whether there is such a place.
  bool start_on_the_way(const ContactProblem<D>& problem);
  /// Notes the speeds `q` of the rows, or lets the opening speeds follow what they have changed by.
  void note_speeds(const ContactProblem<D>& problem);
  void follow_speeds(const ContactProblem<D>& problem);
  void start(const ContactProblem<D>& problem, double impulse, double speed);
  int iterate(const ContactProblem<D>& problem, double goal, int most, const Revision& revise);
  void direction(const ContactProblem<D>& problem, Column& dx, Column& dy);
  [[nodiscard]] double longest(const Column& dx, const Column& dy, double part) const;

  /// With `carries` as a guess; adds the factorisations to `outcome`.
  bool guess(const ContactProblem<D>& problem, double goal, std::vector<char> carries,
             std::vector<double>& impulses, Outcome& outcome);

  BlockCholesky<D> matrix_;
  ActiveSet<D> active_;
  Column x_;  // impulses
  Column y_;  // opening speeds
  Column dx_, dy_, other_dx_, other_dy_;
  Column inverse_x_, weight_, miss_, target_, scratch_, opening_;
  Column motion_, change_;
  std::vector<Waypoint> way_;  // to the last answer; beyond way_length_ spare room
  std::size_t way_length_ = 0;
  Column way_q_;  // of the rows of that problem
};

}  // namespace carom::contact
