#include "effects/pile.hpp"

#include <algorithm>

namespace carom::effects {
namespace {

constexpr int kPasses = 4;

bool stands_on_wall(const Member& member, const Domain& domain, const Vec2& acceleration) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double pull = acceleration[Balls::index(axis)];
    if (!domain.solid(axis) || pull == 0) continue;
    const double x = member.position[Balls::index(axis)];
    if (pull < 0 ? x <= domain.lowest(axis, member.radius)
                 : x >= domain.highest(axis, member.radius)) {
      return true;
    }
  }
  return false;
}

}  // namespace

Pile::Pile(ContactGroup& group, const Domain& domain, const Vec2& acceleration) : group_(group) {
  for (Member& member : group_.members) {
    member.supported = member.inverse_mass == 0 || stands_on_wall(member, domain, acceleration);
  }
  for (std::uint32_t k = 0; k < group_.contacts.size(); ++k) {
    const Contact& contact = group_.contacts[k];
    const double from_a_to_b = -acceleration.dot(contact.line.r);
    const double height =
        -acceleration.dot(group_.members[contact.a].position + group_.members[contact.b].position);
    upwards_.push_back({k, height, from_a_to_b > 0});
  }
  std::stable_sort(upwards_.begin(), upwards_.end(),
                   [](const Standing& s, const Standing& t) { return s.height < t.height; });
  for (const Standing& standing : upwards_) {
    const Contact& contact = group_.contacts[standing.contact];
    Member& lower = group_.members[standing.a_is_lower ? contact.a : contact.b];
    Member& upper = group_.members[standing.a_is_lower ? contact.b : contact.a];
    upper.supported = upper.supported || lower.supported;
  }
}

void Pile::stop(const Domain& domain, const CollisionRule& rule, ImpactCount& count) {
  for (int pass = 0; pass < kPasses; ++pass) {
    bool any = false;
    for (const Standing& standing : upwards_) {
      const Contact& contact = group_.contacts[standing.contact];
      Member& lower = group_.members[standing.a_is_lower ? contact.a : contact.b];
      Member& upper = group_.members[standing.a_is_lower ? contact.b : contact.a];
      const double sign = standing.a_is_lower ? 1 : -1;
      const Vec2 up = sign * contact.line.r;
      const double closing = (upper.velocity - lower.velocity).dot(up);
      if (!approaches(closing, contact.line.square, upper.velocity, lower.velocity)) continue;
      any = true;
      const bool sinking = (upper.velocity + lower.velocity).dot(up) <= 0;
      if (lower.supported && upper.inverse_mass > 0 && sinking) {
        upper.velocity -= closing / contact.line.square * up;
        ContactGroup::rebound(upper, domain, rule, count);
      } else {
        group_.collide(contact, domain, rule, count);
      }
    }
    if (!any) return;
  }
}

void Pile::lift(const Domain& domain) {
  for (const Standing& standing : upwards_) {
    const Contact& contact = group_.contacts[standing.contact];
    const Member& lower = group_.members[standing.a_is_lower ? contact.a : contact.b];
    const Member& upper = group_.members[standing.a_is_lower ? contact.b : contact.a];
    if (!lower.supported || upper.inverse_mass == 0) continue;
    group_.separate(contact, domain, standing.a_is_lower ? 0 : 1, standing.a_is_lower ? 1 : 0);
  }
}

}  // namespace carom::effects
