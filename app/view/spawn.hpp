#pragma once

#include <cstdint>
#include <optional>

#include "carom/ball.hpp"
#include "carom/session.hpp"

namespace carom {

/// A ball like the newest free one, at rest at the origin.
Ball model_ball(const Session& session);

/// A ball like the newest free one, at a free place and on its way; `number` tells balls apart.
/// None where there is no free place.
std::optional<Ball> spawn(const Session& session, std::uint64_t number);

}  // namespace carom
