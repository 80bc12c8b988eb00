#pragma once

#include <vector>

#include "contact/contact_rows.hpp"
#include "contact/island.hpp"
#include "contact/island_friction.hpp"

namespace carom::contact {

/// How fast a contact slides beyond what counts as sticking.
///
/// Holds: as the speed changes, this does not jump.
[[nodiscard]] double sliding(const IslandContact& contact, const SurfaceMotion& a,
                             const SurfaceMotion& b, double sticks);

/// Finds how fast the contacts of an island slide while its impulses are found, from how far they
/// are: the rows of the problem then open by the coefficient times that.
///
/// While much is missed a slip may turn out more or less, if it is more than what is missed.  Near
/// the end one may only turn out less, as it would let the contact close, by what is missed.
class SlipRevision {
 public:
  /// `slips`: of the contacts, as the rows of the problem have them.
  SlipRevision(const std::vector<IslandBody>& bodies, const std::vector<IslandContact>& contacts,
               double sticks, ContactProblem<3>& problem, std::vector<double>& slips)
      : bodies_(bodies), contacts_(contacts), sticks_(sticks), problem_(problem), slips_(slips) {}

  /// `motion`: what the impulses do to the bodies; `miss`: the speed by which they miss what they
  /// are to do.
  void operator()(const std::vector<double>& motion, double miss);
  /// Whether the slips have been looked at.
  [[nodiscard]] bool any() const { return revisions_ > 0; }

 private:
  void revise(const std::vector<double>& motion, double miss, bool ends);
  [[nodiscard]] SurfaceMotion surface(const std::vector<double>& motion, int body) const;

  const std::vector<IslandBody>& bodies_;
  const std::vector<IslandContact>& contacts_;
  const double sticks_;
  ContactProblem<3>& problem_;
  std::vector<double>& slips_;
  int revisions_ = 0;
  int corrections_ = 0;
};

}  // namespace carom::contact
