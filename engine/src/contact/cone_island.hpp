#pragma once

#include <cstddef>
#include <vector>

#include "contact/cone_descent.hpp"
#include "contact/cone_response.hpp"

namespace carom::event {

/// More contacts are solved by an interior point, whose bits depend on the order of the bodies and
/// contacts, and on mirrors: the caller puts them in order by place.
inline constexpr std::size_t kFewContacts = 192;
/// The same of balls that lose energy: of theirs also a few are nearly dependent, and most impacts
/// come to heaps.
inline constexpr std::size_t kFewOfHeap = 64;

/// The least change of the motion of an island by which none of its contacts closes beyond
/// touching.
///
/// Rule: the impulse of a contact lies in its cone of friction, pushes, and is 0 where the contact
/// stays open.  One that slides opens by the coefficient times the slip (Anitescu's cone
/// complementarity, a convex quadratic program: the motion is unique).
/// Holds: the kinetic energy does not rise: standing still is among the motions allowed, and the
/// nearest to a given one is not longer than it.  Numbering, sides, mirrors and swapped axes leave
/// the bits as they are, of few contacts.
/// Source: M. Anitescu, Math. Program. 105 (2006) 113.  In the plane a cone has two edges, and an
/// impulse in it is the sum of two that push along them: cone_response.hpp.  The impulses are found
/// by cone_descent.hpp or, if many, by cone_interior.hpp.
class ConeIsland {
 public:
  using Bodies = std::vector<ConeBody>;
  using Contacts = std::vector<ConeContact>;

  /// `few`: so many contacts at most are solved without an order.
  ConeIsland(const Bodies& bodies, const Contacts& contacts, std::size_t few = kFewContacts);
  ConeIsland(const ConeIsland&) = delete;
  ConeIsland& operator=(const ConeIsland&) = delete;

  /// Changes the motion of the bodies; contacts may close by `rate` times their gap.  What remains
  /// of the speeds that should be stopped is at most `goal`.  Gives the normal impulses of the
  /// contacts.  `opens`: what slides on along something that never moves opens no faster than about
  /// that; 0: by its slip.
  std::vector<double> resolve(Bodies& motion, double rate, double goal, double opens = 0);

 private:
  using Column = ConeResponse::Column;

  /// `again`: after the same with other speeds.
  void solve(double goal, bool again);
  void close_slides(double goal, double opens);

  const Contacts& contacts_;
  std::size_t few_;
  ConeResponse response_;
  ConeDescent descent_{response_};
  Column start_, parting_, impulses_, change_;
};

}  // namespace carom::event
