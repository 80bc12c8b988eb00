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

WallEnds ends_at_walls(const LastingIsland& island, const std::vector<Vec2>& mean, double step,
                       const Domain& domain) {
  WallEnds ends{mean, {}, 0};
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Member& member = island.members[m];
    Vec2 way = island.frame.out(mean[m]);
    const Vec2 end = member.start + step * way;
    bool out = false;
    bool far = false;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain.solid(axis)) continue;
      const double stop = std::clamp(end[axis], stop_at(domain, member, axis, -1),
                                     stop_at(domain, member, axis, 1));
      if (stop == end[axis]) continue;
      out = true;
      far = far || !near_wall(member, axis, end[axis] < stop ? -1 : 1, stop);
      way[axis] = (stop - member.start[axis]) / step;
    }
    if (!out) continue;
    if (far) ends.beyond_far.push_back(member.ball);
    ends.inside[m] = island.frame.into(way);
    ends.out = std::max(ends.out, (ends.inside[m] - mean[m]).norm());
  }
  return ends;
}

}  // namespace carom::contact
