#pragma once

#include <cstddef>
#include <vector>

#include "carom/ball.hpp"
#include "carom/effects.hpp"
#include "solvers/event/core.hpp"
#include "state/domain.hpp"

namespace carom::event {

/// Whether the balls are many enough for domains of the plane, small enough beside its periods, and
/// under effects that suit domains.  `rests`: contacts may come to rest; domains leave those that
/// do to an event loop.
bool suits_domains(const Effects& effects, const Domain& domain, const std::vector<Ball>& balls,
                   bool rests, const Sharing& sharing, std::size_t workers);

}  // namespace carom::event
