#pragma once

#include "effects/collisions.hpp"
#include "effects/contact_group.hpp"
#include "state/domain.hpp"

namespace carom::effects {

/// Whether impacts of two at a time may need very many passes over a group: a light ball between
/// heavy ones goes to and fro about as often as the root of what they weigh more.
[[nodiscard]] bool ends_slowly(const ContactGroup& group);

/// What still approaches in a group is one joint impact, walls included; then friction acts on what
/// each contact has carried.
///
/// Holds: momentum of free groups; the energy does not rise.
void end_impacts(ContactGroup& group, const Domain& domain, const CollisionRule& rule,
                 ImpactCount& count);

}  // namespace carom::effects
