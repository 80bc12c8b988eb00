#pragma once

#include <vector>

#include "contact/island.hpp"

namespace carom::contact {

/// A step of an island that has one contact only.
///
/// Of a disk the normal impulse does not change the slip, nor the tangential one the approach, so
/// each has its own closed form.
void take_single(const std::vector<IslandBody>& bodies, const IslandContact& contact,
                 const IslandStep::Rule& rule, IslandOutcome& outcome);

}  // namespace carom::contact
