#include "effects/pile.hpp"

#include <algorithm>

#include "effects/friction.hpp"

namespace carom::effects {
namespace {

constexpr int kPasses = 4;

bool stands_on_wall(const Member& member, const Domain& domain, const Vec2& acceleration) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double pull = acceleration[axis];
    if (!domain.solid(axis) || pull == 0) continue;
    const double x = member.position[axis];
    if (pull < 0 ? x <= domain.lowest(axis, member.radius)
                 : x >= domain.highest(axis, member.radius)) {
      return true;
    }
  }
  return false;
}

// One contact as seen along gravity.
struct Standing {
  Contact* contact;
  double height;  // of the two centres together: what carries comes before what is carried
  std::uint32_t lower;
  std::uint32_t upper;
  Vec2 up;  // the line of centres, from the lower to the upper ball
};

std::vector<Standing> from_the_ground_up(ContactGroup& group, const Vec2& acceleration) {
  std::vector<Standing> standings;
  for (Contact& contact : group.contacts) {
    if (!contact.touching) continue;
    const double height =
        -acceleration.dot(group.members[contact.a].position + group.members[contact.b].position);
    if (acceleration.dot(contact.line.r) < 0) {
      standings.push_back({&contact, height, contact.a, contact.b, contact.line.r});
    } else {
      standings.push_back({&contact, height, contact.b, contact.a, -contact.line.r});
    }
  }
  std::stable_sort(standings.begin(), standings.end(),
                   [](const Standing& s, const Standing& t) { return s.height < t.height; });
  return standings;
}

}  // namespace

void stop_on_ground(ContactGroup& group, const Domain& domain, const CollisionRule& rule,
                    ImpactCount& count) {
  CollisionRule soft = rule;
  soft.restitution = 0;
  soft.wall_restitution = 0;
  const std::vector<Standing> standings = from_the_ground_up(group, rule.acceleration);
  for (Member& member : group.members) {
    member.supported =
        member.inverse_mass == 0 || stands_on_wall(member, domain, rule.acceleration);
  }
  for (const Standing& standing : standings) {
    if (group.members[standing.lower].supported) group.members[standing.upper].supported = true;
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    bool any = false;
    for (const Standing& standing : standings) {
      Member& lower = group.members[standing.lower];
      Member& upper = group.members[standing.upper];
      const double square = standing.contact->line.square;
      const double closing = (upper.velocity - lower.velocity).dot(standing.up);
      if (!approaches(closing, standing.contact->line.length, upper.velocity, lower.velocity))
        continue;
      any = true;
      const bool sinking = (upper.velocity + lower.velocity).dot(standing.up) <= 0;
      if (lower.supported && upper.inverse_mass > 0 && sinking) {
        const double length = standing.contact->line.length;
        const double before = upper.velocity.dot(standing.up) / length;
        upper.velocity -= closing / square * standing.up;
        Rubbed rubbed;
        const double normal = -closing / length * upper.mass;
        rubbed.lost = lost_to_impulse(normal, before, before - closing / length);
        if (rule.friction > 0) {
          // Between the two as they are: what the ground carries is the normal impulse alone.
          const LineOfCentres& line = standing.contact->line;
          const Rubbed friction =
              rub(lower, upper, {standing.up, square, line.length, line.distance}, normal,
                  rule.friction);
          rubbed.impulse = friction.impulse;
          rubbed.lost += friction.lost;
        }
        count.lost += rubbed.lost;
        if (count.log.wanted) group.note(*standing.contact, normal, rubbed, count.log);
        ContactGroup::rebound(upper, domain, soft, count);
      } else {
        group.collide(*standing.contact, domain, soft, count);
      }
    }
    if (!any) return;
  }
}

}  // namespace carom::effects
