#pragma once

#include <vector>

#include "contact/cone_response.hpp"

namespace carom::event {

/// The same impulses as ConeDescent's, by an interior point: many contacts of a pile are nearly
/// dependent, for which conjugate gradients take ever more rounds, and an interior point hardly
/// more than for few.
///
/// Gives whether it found them.  `again`: of the problem that this thread has solved just before,
/// with other speeds `parting`; it is on the way to that answer that it starts.
/// Holds: the bits depend on the order of the bodies and contacts, and on mirrors.
bool solve_by_interior_point(const ConeResponse& response, const ConeResponse::Column& parting,
                             double goal, bool again, ConeResponse::Column& impulses);

}  // namespace carom::event
