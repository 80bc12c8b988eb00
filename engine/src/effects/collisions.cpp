#include "effects/collisions.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "effects/contact_group.hpp"
#include "effects/group_impact.hpp"

namespace carom::effects {
namespace {

// Passes over a group that has not come to an end yet; what is left over waits for the next step.
constexpr int kImpactPasses = 16;
constexpr int kSeparationPasses = 8;

// Runs `act` over the contacts, forwards and backwards in turn, until it finds nothing to do; says
// whether it came to that.
template <class Act>
bool sweep(ContactGroup& group, int passes, Act act) {
  for (int pass = 0; pass < passes; ++pass) {
    bool any = false;
    if (pass % 2 == 0) {
      for (Contact& contact : group.contacts) any |= act(contact);
    } else {
      for (Contact& contact : std::views::reverse(group.contacts)) any |= act(contact);
    }
    if (!any) return true;
  }
  return false;
}

// Takes `work` out of the motion along the acceleration (puts it in where it is negative); where
// there is not enough, the balls are moved less far.
void pay(ContactGroup& group, const Vec2& acceleration, double work) {
  if (work == 0) return;
  const double square = acceleration.squaredNorm();
  const double stock = group.sum_over_members([&](const Member& member) {
    const double along = member.velocity.dot(acceleration);
    return member.mass * along * along / square / 2;
  });
  if (stock == 0 && work < 0) return;
  const double kept = work < stock ? std::sqrt(1 - work / stock) : 0;
  for (Member& member : group.members) {
    member.velocity -= (1 - kept) * member.velocity.dot(acceleration) / square * acceleration;
  }
  if (work > stock) {
    const double part = stock / work;
    for (Member& member : group.members) {
      member.position = member.start + part * (member.position - member.start);
    }
  }
}

}  // namespace

double GroupResolver::resolve(Balls& balls, std::span<const Pair> pairs, bool again,
                              ImpactCount& count) const {
  thread_local ContactGroup group;
  group.load(balls, pairs, domain_, again ? 0 : rule_.step);
  if (again) group.touch_all();
  count.lost = 0;
  const Vec2& acceleration = rule_.acceleration;
  const bool ended = sweep(group, kImpactPasses, [&](Contact& contact) {
    return group.collide(contact, domain_, rule_, count);
  });
  if (!ended && ends_slowly(group)) end_impacts(group, domain_, rule_, count);
  sweep(group, kSeparationPasses, [&](const Contact& contact) {
    const auto share = [&](std::uint32_t member) {
      return group.members[member].inverse_mass / contact.inverse_masses;
    };
    return group.separate(contact, domain_, share(contact.a), share(contact.b));
  });
  // Where gravity acts on groups that are resolved here, nothing is lost.
  if (acceleration != Vec2{0, 0} && group.bound) {
    pay(group, acceleration, group.lifting_work(acceleration));
  }
  for (const Contact& contact : group.contacts) {
    if (contact.touching && group.apart(contact, domain_).dot(contact.line.r) < 0) ++count.missed;
  }
  count.push = std::max(count.push, group.farthest_push());
  group.store(balls, domain_, turns_);
  return count.lost;
}

}  // namespace carom::effects
