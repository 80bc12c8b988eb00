#pragma once

#include "carom/effects.hpp"
#include "state/balls.hpp"

namespace carom::contact {

/// Whether lasting contacts are looked for: gravity or attraction presses balls together that come
/// to rest by losses, or whose masses differ so much that one lies on the other for many steps.
[[nodiscard]] bool contacts_last(const Effects& effects, const Balls& balls);

}  // namespace carom::contact
