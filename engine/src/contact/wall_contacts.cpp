#include "contact/wall_contacts.hpp"

#include <algorithm>

namespace carom::contact {
namespace {

using Member = LastingIsland::Member;

double stop_at(const Domain& domain, const Member& member, std::size_t axis, int side) {
  return side < 0 ? domain.lowest(axis, member.radius) : domain.highest(axis, member.radius);
}

bool near_wall(const Member& member, std::size_t axis, int side, double stop) {
  const double gap =
      std::min(side * (stop - member.start[axis]), side * (stop - member.flown[axis]));
  return gap <= kNearWall * member.radius;
}

}  // namespace

void add_wall_contacts(LastingIsland& island, const Domain& domain, const WallContactRule& rule,
                       const std::vector<char>& driven) {
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Member& member = island.members[m];
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain.solid(axis)) continue;
      for (const int side : {-1, 1}) {
        const double stop = stop_at(domain, member, axis, side);
        if (!near_wall(member, axis, side, stop) && driven[member.ball] == 0) continue;
        IslandContact contact;
        contact.a = static_cast<int>(m);
        contact.normal[axis] = side;
        contact.gap = side * (stop - member.start[axis]);
        contact.friction = rule.friction;
        contact.restitution = rule.restitution;
        island.add_contact(contact, {member.radius, 0, true});
      }
    }
  }
}

bool beyond_far_wall(const Member& member, const Vec2& place, const Domain& domain) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!domain.solid(axis)) continue;
    for (const int side : {-1, 1}) {
      const double stop = stop_at(domain, member, axis, side);
      if (side * (stop - place[axis]) < 0 && !near_wall(member, axis, side, stop)) return true;
    }
  }
  return false;
}

}  // namespace carom::contact
