#pragma once

#include "effects/contact_group.hpp"

namespace carom::effects {

/// Lets a group that stands on something come to rest: what the symmetric passes leave over is
/// passed upwards from the ground, each supported ball being as firm as the ground for the balls on
/// it.  Through a pile of any height one pass is enough.
/// Source: Guendelman, Bridson, Fedkiw, Nonconvex rigid bodies with stacking, 2003 (shock
/// propagation); here only where it takes energy away.
class Pile {
 public:
  /// Finds out what stands on what; `acceleration` is not zero.
  Pile(ContactGroup& group, const Domain& domain, const Vec2& acceleration);

  /// Stops balls that still sink into what they stand on.
  void stop(const Domain& domain, const CollisionRule& rule, ImpactCount& count);
  /// Moves balls out of what they stand on.
  void lift(const Domain& domain);

 private:
  struct Standing {
    std::uint32_t contact = 0;
    double height = 0;  // of the two centres together: what carries comes before what is carried
    bool a_is_lower = false;
  };

  ContactGroup& group_;
  std::vector<Standing> upwards_;
};

}  // namespace carom::effects
