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

/// What impulses along the edges of the contacts' cones do to the bodies of an island, and what
/// these do to the contacts.
///
/// Columns have an entry for each edge: without friction one a contact, else two, those of the
/// other edge after those of the first.  Edges are scaled, so that the own response of each is the
/// same.
/// Holds: sums over contacts have the same bits in any order.
class ConeResponse {
 public:
  using Column = std::vector<double>;
  /// Of a body.
  struct Total {
    double x = 0;
    double y = 0;
    double turning = 0;
  };

  ConeResponse(const std::vector<ConeBody>& bodies, const std::vector<ConeContact>& contacts);

  [[nodiscard]] std::size_t contacts() const { return contacts_; }
  /// Its two bodies; of a wall the number is one more than that of the last body.
  [[nodiscard]] const std::array<int, 2>& ends(std::size_t k) const { return ends_[k]; }
  /// Contacts, and some more that do nothing: a whole number of lanes.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t edges() const { return edges_; }
  [[nodiscard]] bool has_friction() const { return edges_ > size_; }
  /// The last is that of walls.
  [[nodiscard]] const Column& inverse_mass() const { return inverse_mass_; }
  [[nodiscard]] double normal_x(std::size_t k) const { return normal_x_[k]; }
  [[nodiscard]] double normal_y(std::size_t k) const { return normal_y_[k]; }
  [[nodiscard]] double friction(std::size_t k) const { return friction_[k]; }
  [[nodiscard]] double scale(std::size_t k) const { return scale_[k]; }
  /// How far contacts give way to an impulse: it makes the loads of islands with more contacts than
  /// freedoms definite.
  [[nodiscard]] double give() const { return give_; }
  /// The length of a step down a slope that never goes too far.
  [[nodiscard]] double step() const { return step_; }

  /// The changes of the bodies' motion by the last `pass_on`, or what has been written there; the
  /// last is that of walls.
  [[nodiscard]] std::vector<Total>& totals() { return totals_; }
  /// What impulses do to the bodies.
  void pass_on(const double* impulses);
  /// How fast the ends of each contact part along its edges, moving as `totals` says.
  void part(double* result);
  /// Both, and how far contacts give way.
  void times(const double* impulses, double* result);

 private:
  void scale_edges();

  std::size_t contacts_;
  std::size_t size_;
  std::size_t edges_ = 0;  // of all cones: once or twice as many
  Column inverse_mass_;
  std::vector<std::array<int, 2>> ends_;
  Column normal_x_, normal_y_, friction_, scale_;
  double give_ = 0;
  double step_ = 0;
  double most_at_body_ = 0;
  std::vector<Total> totals_;
  Column push_x_, push_y_, push_turning_;
};

}  // namespace carom::event
