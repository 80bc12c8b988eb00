#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "contact/dissipation.hpp"
#include "contact/impulse.hpp"
#include "contact/pair_list.hpp"
#include "effects/collisions.hpp"
#include "effects/walls.hpp"
#include "state/domain.hpp"

namespace carom::effects {

/// One ball of a group, taken out of the columns.
struct Member {
  std::uint32_t ball = 0;
  Vec2 position{0, 0};
  Vec2 velocity{0, 0};
  Vec2 start{0, 0};  ///< where it was before the group was resolved
  double radius = 0;
  double mass = 0;
  double inverse_mass = 0;
  double spin = 0;  ///< with friction
  Vec2 pull{0, 0};  ///< by attraction: half a step of it is in the velocity, half is to come
};

/// Notes what a ball met at a wall across an axis.
void note_wall(const WallImpact& met, std::size_t axis, const Member& ball,
               const FrictionChange& by_friction, ImpactLog& log);

/// Two members that touch.
struct Contact {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  LineOfCentres line;  ///< from a to b, as it was before the group was resolved, or as they met
  double inverse_masses = 0;
  double reach = 0;
  bool touching = false;  ///< the balls overlapped before the group was resolved
  bool met = false;       ///< they have had an impact since
  bool passed = false;    ///< their centres have passed each other since they met
};

/// Balls that touch, worked on together: a copy that is loaded, changed and stored back.
///
/// Holds: members in the order of their balls; contacts in an order that follows from how the balls
/// lie and move, so that neither the order of the balls nor a mirror changes a bit (contacts alike
/// in all of that are in the order of their pairs).
class ContactGroup {
 public:
  std::vector<Member> members;
  std::vector<Contact> contacts;
  /// A fixed ball takes part, or a wall has since loading: momentum need not be kept, and moving
  /// balls apart can lift the centre of mass.
  bool bound = false;
  bool spins = false;   ///< there is friction
  bool pulled = false;  ///< there is attraction

  /// `step`: for so long they have flown; 0: it does not matter.
  void load(const Balls& balls, std::span<const Pair> pairs, const Domain& domain, double step = 0);
  /// Counts which balls it brings back round a periodic axis.
  void store(Balls& balls, const Domain& domain, Turns& turns) const;

  /// From a to b as they are now.
  [[nodiscard]] Vec2 apart(const Contact& contact, const Domain& domain) const;
  /// All pairs count as touching, those too that were moved apart just now.
  void touch_all();
  [[nodiscard]] double farthest_push() const;   ///< of a member since loading
  [[nodiscard]] double kinetic_energy() const;  ///< that of the spins, if there are any, too
  /// The work that the moves since loading have done against a uniform acceleration.
  [[nodiscard]] double lifting_work(const Vec2& acceleration) const;

  /// The same bits in any order of the members.
  template <class Of>
  [[nodiscard]] double sum_over_members(Of of) const {
    std::vector<double> parts;
    for (const Member& member : members) parts.push_back(of(member));
    std::sort(parts.begin(), parts.end());
    return std::accumulate(parts.begin(), parts.end(), 0.0);
  }

  /// An impact along the contact, if its balls approach; says whether there was one.
  bool collide(Contact& contact, const Domain& domain, const CollisionRule& rule,
               ImpactCount& count);
  /// Moves the two balls of a contact apart, in the given shares of their overlap; says whether
  /// there was one.
  bool separate(const Contact& contact, const Domain& domain, double share_a, double share_b);
  /// Sends a ball that has been driven into the wall it stands at back.
  static void rebound(Member& member, const Domain& domain, const CollisionRule& rule,
                      ImpactCount& count);
  /// Notes a contact that does not bounce: its impulse along the normal, what friction did, and all
  /// that was lost.
  Impact& note(const Contact& contact, double normal, const FrictionChange& by_friction,
               ImpactLog& log) const;

 private:
  void put_in_order();
  void see_whether_passed(Contact& contact, const Vec2& r, const Vec2& velocity, double step) const;
  bool collide_under_pull(Contact& contact, const Domain& domain, const CollisionRule& rule,
                          ImpactCount& count);
  void keep_inside(Member& member, const Domain& domain);
  /// The impact itself: `j` r is the impulse.
  struct Exchange {
    double j = 0;
    double arrival = 0;
    double leaving = 0;
    bool bounces = false;
  };
  void exchange(const Contact& contact, const Exchange& exchanged, const Domain& domain,
                const CollisionRule& rule, ImpactCount& count);
};

}  // namespace carom::effects
