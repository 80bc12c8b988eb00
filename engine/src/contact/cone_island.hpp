#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/contact_graph.hpp"

namespace carom::event {

/// A ball of an island; an inverse mass of 0 is not moved.
struct ConeBody {
  Vec<double> velocity;
  double turning;  ///< radius times spin; 0 where there is no friction
  double inverse_mass;
};

/// Two balls of an island that are near, or a ball and something that never moves.
struct ConeContact {
  int a;
  int b;               ///< a body, or kWall
  Vec<double> normal;  ///< of length 1, from a to b
  double gap;
  double friction;
  double parting = 0;  ///< more than 0: so fast it is to part at least, whatever its gap
};

/// More contacts are solved by an interior point, whose bits depend on the order of the bodies and
/// contacts, and on mirrors: the caller puts them in order by place.
inline constexpr std::size_t kFewContacts = 192;

/// The least change of the motion of an island by which none of its contacts closes beyond
/// touching.
///
/// Rule: the impulse of a contact lies in its cone of friction, pushes, and is 0 where the contact
/// stays open.  One that slides opens by the coefficient times the slip (Anitescu's cone
/// complementarity, a convex quadratic program: the motion is unique).
/// Holds: the kinetic energy does not rise: standing still is among the motions allowed, and the
/// nearest to a given one is not longer than it.  Numbering, sides, mirrors and swapped axes leave
/// the bits as they are, of few contacts.
/// Source: M. Anitescu, Math. Program. 105 (2006) 113; Dostal, Schoeberl, Comput. Optim. Appl. 30
/// (2005) 23: conjugate gradients on what pushes, with steps onto and off the bounds (modified
/// proportioning).  In the plane a cone has two edges, and an impulse in it is the sum of two that
/// push along them.
class ConeIsland {
 public:
  using Bodies = std::vector<ConeBody>;
  using Contacts = std::vector<ConeContact>;

  ConeIsland(const Bodies& bodies, const Contacts& contacts);

  /// Changes the motion of the bodies; contacts may close by `rate` times their gap.  What remains
  /// of the speeds that should be stopped is at most `goal`.  Gives the normal impulses of the
  /// contacts.  `slides`: what slides on along something that never moves does not open.
  std::vector<double> resolve(Bodies& motion, double rate, double goal, bool slides = false);

 private:
  using Column = std::vector<double>;

  /// What its contacts do to a body.
  struct Total {
    double x = 0;
    double y = 0;
    double turning = 0;
  };

  void scale();
  void solve(double goal);
  /// Whether it found the impulses.
  template <int D>
  bool solve_many(double goal);
  void descend(double goal);
  void close_slides(double goal);
  void times(const double* impulses, double* result);
  void pass_on(const double* impulses);
  void part(double* result) const;
  /// Steps onto the bound in the way, and down along it.
  void expand(double room);

  const Contacts& contacts_;
  std::size_t size_ = 0;              ///< contacts, and some more that do nothing
  std::size_t edges_ = 0;             ///< of all cones: once or twice as many
  std::vector<double> inverse_mass_;  ///< the last is that of walls
  std::vector<std::array<int, 2>> ends_;
  Column normal_x_, normal_y_, friction_, scale_;
  double give_ = 0;
  double step_ = 0;
  double most_at_body_ = 0;
  std::vector<Total> totals_;
  mutable Column push_x_, push_y_, push_turning_;
  Column start_, parting_, impulses_, anchor_, slope_, way_, free_, change_;
};

}  // namespace carom::event
