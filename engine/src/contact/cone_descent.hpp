#pragma once

#include <vector>

#include "contact/cone_response.hpp"

namespace carom::event {

/// The least impulses, none of which pulls, by which no edge of an island's cones closes: conjugate
/// gradients on what pushes, with steps onto and off the bounds (modified proportioning).
///
/// Holds: the bits do not depend on the order of contacts or bodies.
/// Source: Dostal, Schoeberl, Comput. Optim. Appl. 30 (2005) 23.
class ConeDescent {
 public:
  using Column = ConeResponse::Column;

  explicit ConeDescent(ConeResponse& response);

  /// `parting`: how fast each edge parts without impulses.  `impulses`: where it starts, and what
  /// it finds.  What remains of speeds that should be stopped is at most `goal`.
  void solve(const Column& parting, Column& impulses, double goal);

 private:
  /// Until nothing gives way any more; whether that was reached by so many descents.
  bool descend_again(const Column& parting, Column& impulses, double goal, int at_most);
  /// Nothing has given way.
  void start(const Column& parting);
  /// What contacts gave way until now.
  void take_back(const Column& impulses);
  /// Gives how many descents there were.
  int descend(Column& impulses, double goal, int at_most);
  /// Steps onto the bound in the way, and down along it.
  void expand(Column& impulses, double room);

  ConeResponse& response_;
  Column from_;    ///< `parting`, less what contacts gave way
  Column anchor_;  ///< the impulses that they give way from
  Column slope_, way_, change_;
};

}  // namespace carom::event
