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

Vec2 end_of(const LastingIsland& island, std::size_t m, const std::vector<Vec2>& mean,
            double step) {
  return island.members[m].start + step * island.frame.out(mean[m]);
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

std::vector<std::uint32_t> beyond_far_walls(const LastingIsland& island,
                                            const std::vector<Vec2>& mean, double step,
                                            const Domain& domain) {
  std::vector<std::uint32_t> beyond;
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Member& member = island.members[m];
    if (beyond_far_wall(member, end_of(island, m, mean, step), domain))
      beyond.push_back(member.ball);
  }
  return beyond;
}

std::vector<Vec2> ways_inside(const LastingIsland& island, const std::vector<Vec2>& mean,
                              double step, const Domain& domain) {
  std::vector<Vec2> inside = mean;
  for (std::size_t m = 0; m < island.members.size(); ++m) {
    const Member& member = island.members[m];
    const Vec2 end = end_of(island, m, mean, step);
    Vec2 way = island.frame.out(mean[m]);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!domain.solid(axis)) continue;
      const double stop = std::clamp(end[axis], stop_at(domain, member, axis, -1),
                                     stop_at(domain, member, axis, 1));
      if (stop != end[axis]) way[axis] = (stop - member.start[axis]) / step;
    }
    inside[m] = island.frame.into(way);
  }
  return inside;
}

}  // namespace carom::contact
