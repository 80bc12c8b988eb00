#pragma once

#include <cstddef>
#include <vector>

#include "contact/cone_response.hpp"
#include "numbers/scalar.hpp"
#include "solvers/event/islands/stepped_flight.hpp"

namespace carom::event {

/// The balls of a contact island and their near contacts at one instant, as far as impulses depend
/// on them: in double whatever the run computes in.
struct IslandMotion {
  std::vector<unsigned> support;         ///< by ball; see support.hpp
  std::vector<ConeBody> bodies;          ///< by ball
  std::vector<GravityOfFlight> gravity;  ///< by ball: of its flight till now
  std::vector<double> left_out;          ///< by ball: energy, see SteppedEnergy; empty: none
  std::vector<ConeContact> contacts;     ///< of two balls, or of one and what never moves
  std::vector<char> touches;             ///< by contact; else it is only near
  double lifted = 0;                     ///< the height that balls were given, in energy
};

/// How fast a contact's bodies approach.
[[nodiscard]] double approach(const IslandMotion& island, std::size_t contact);

/// Takes what a body has of speed towards the wall of a contact, but for `left`.
void stop_at(ConeBody& body, const ConeContact& wall, double left = 0);

}  // namespace carom::event
