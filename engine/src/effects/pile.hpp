#pragma once

#include "effects/contact_group.hpp"

namespace carom::effects {

/// Stops the balls of a group that still sink into what they stand on, from the ground upwards:
/// what the symmetric passes leave over is passed on as if each supported ball were as firm as the
/// ground. Through a pile of any height a few passes are enough.
/// REQUIRES: an acceleration.
/// Source: Guendelman, Bridson, Fedkiw, Nonconvex rigid bodies with stacking, 2003 (shock
/// propagation); here only where it takes energy away.
void stop_on_ground(ContactGroup& group, const Domain& domain, const CollisionRule& rule,
                    ImpactCount& count);

}  // namespace carom::effects
