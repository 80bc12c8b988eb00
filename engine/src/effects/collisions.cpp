#include "effects/collisions.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "effects/contact_group.hpp"

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
// there is not enough, the balls are moved less far.  `free` is work that need not be paid.
void pay(ContactGroup& group, const Vec2& acceleration, double work, double free) {
  const double due = work - free;
  if (due == 0) return;
  const double square = acceleration.squaredNorm();
  double stock = 0;
  for (const Member& member : group.members) {
    const double along = member.velocity.dot(acceleration);
    stock += member.mass * along * along / square / 2;
  }
  if (stock == 0 && due < 0) return;
  const double kept = due < stock ? std::sqrt(1 - due / stock) : 0;
  for (Member& member : group.members) {
    member.velocity -= (1 - kept) * member.velocity.dot(acceleration) / square * acceleration;
  }
  if (due > stock) {
    const double part = (free + stock) / work;
    for (Member& member : group.members) {
      member.position = member.start + part * (member.position - member.start);
    }
  }
}

}  // namespace

double GroupResolver::resolve(Balls& balls, std::span<const Pair> pairs, ImpactCount& count) const {
  thread_local ContactGroup group;
  group.load(balls, pairs, domain_);
  count.lost = 0;
  const std::size_t noted = count.log.impacts.size();
  const Vec2& acceleration = rule_.acceleration;
  const bool falls = acceleration.x() != 0 || acceleration.y() != 0;
  const double energy = falls ? group.kinetic_energy() : 0;
  sweep(group, kImpactPasses,
        [&](Contact& contact) { return group.collide(contact, domain_, rule_, count); });
  sweep(group, kSeparationPasses, [&](const Contact& contact) {
    const double a = group.members[contact.a].inverse_mass / contact.inverse_masses;
    return group.separate(contact, domain_, a, 1 - a);
  });
  double lifted = 0;
  if (falls && group.bound) {
    const double work = group.lifting_work(acceleration);
    const double set_free = std::max(0.0, energy - group.kinetic_energy());
    const bool elastic = rule_.restitution == 1;
    if (!elastic) lifted = std::min(work, set_free);
    if (elastic || work > set_free) pay(group, acceleration, work, elastic ? 0 : set_free);
  }
  group.store(balls, domain_, turns_);
  const double lost = std::max(0.0, count.lost - lifted);
  // Each of the impacts has its part in what they have lifted.
  for (std::size_t k = noted; k < count.log.impacts.size() && count.lost > 0; ++k) {
    count.log.impacts[k].energy_lost *= lost / count.lost;
  }
  return lost;
}

}  // namespace carom::effects
