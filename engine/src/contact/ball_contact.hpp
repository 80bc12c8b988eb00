#pragma once

#include "contact/island.hpp"

namespace carom::contact {

/// The contact of two balls in a step: r from one centre to the other at its start, `way` how r
/// would change in free flight, `reach` the sum of the radii.
///
/// The normal is that of the start; of balls that meet after a long way it is the one where they
/// meet.
[[nodiscard]] IslandContact ball_contact(const Vec2& r, const Vec2& way, double reach);

}  // namespace carom::contact
