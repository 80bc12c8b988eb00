#pragma once

#include <vector>

#include "contact/cone_response.hpp"

namespace carom::event {

/// The same impulses as ConeDescent's, by an interior point: many contacts of a pile are nearly
/// dependent, for which conjugate gradients take ever more rounds, and an interior point hardly
/// more than for few.
///
/// Gives whether it found them.
/// Holds: the bits depend on the order of the bodies and contacts, and on mirrors.
bool solve_by_interior_point(const ConeResponse& response, const std::vector<ConeContact>& contacts,
                             const ConeResponse::Column& parting, double goal,
                             ConeResponse::Column& impulses);

}  // namespace carom::event
