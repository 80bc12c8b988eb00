#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "contact/rest_rules.hpp"
#include "solvers/event/touch_search.hpp"

namespace carom::event {

template <class P>
auto TouchSearch<P>::from(std::vector<Index>& seeds, At now) const -> Group {
  Group group;
  add_member(group, seeds.front(), now);
  for (std::size_t k = 0; k < group.members.size(); ++k) add_contacts(group, k, now);
  std::erase_if(seeds, [&](Index seed) { return group.find(seed) < group.members.size(); });
  return group;
}

template <class P>
void TouchSearch<P>::add_member(Group& group, Index i, At now) const {
  const Disk& disk = disks_[i];
  group.members.push_back(i);
  group.places.push_back(motion_.wrapped(motion_.place(disk, now)));
  group.bodies.push_back({motion_.velocity(disk, now), motion_.species(disk).inverse_mass});
  if (!spins_.empty()) group.spins.push_back(motion_.spin_at(disk, spins_[i], now));
}

template <class P>
void TouchSearch<P>::add_contacts(Group& group, std::size_t member, At now) const {
  const Index i = group.members[member];
  if (motion_.fixed(disks_[i])) return;
  const bool of_island = in_island(i);
  if (!of_island) add_walls(group, member, now);
  if (!motion_.rules().collisions) return;
  std::vector<Index> linked;
  for (const auto& [a, b] : pairs_.linked()) {
    if (a != i && b != i) continue;
    const Index j = a == i ? b : a;
    if (j < kFirstMark) linked.push_back(j);
  }
  neighbours_.lists().each(i, [&](Index j) {
    if (of_island && (motion_.fixed(disks_[j]) || motion_.in_island(disks_[j]))) return;
    const auto known = std::find(linked.begin(), linked.end(), j);
    const bool meets = known != linked.end();
    if (meets) linked.erase(known);
    add_contact(group, member, j, now, meets);
  });
  for (const Index j : linked) add_contact(group, member, j, now, true);
}

template <class P>
void TouchSearch<P>::add_walls(Group& group, std::size_t member, At now) const {
  const Index i = group.members[member];
  const Disk& disk = disks_[i];
  const auto& rules = motion_.rules();
  for (Index wall = kWalls; wall < kWalls + 4; ++wall) {
    if (!rules.domain.solid((wall - kWalls) / 2)) continue;
    const S gap = motion_.wall(disk, group.places[member], wall).gap;
    const bool near = jam_.jammed() && !(gap > 2 * motion_.species(disk).radius * jam_.gap());
    const bool meets =
        !(gap > 0) || motion_.wall_event(disk, wall) == now || pairs_.is_linked(i, wall);
    if (!meets && !near) continue;
    const S side = wall % 2 == kWalls % 2 ? -1 : 1;
    const Vec<S> towards = wall - kWalls < 2 ? Vec<S>{side, S(0)} : Vec<S>{S(0), side};
    group.stops.push_back({member, wall, meets});
    group.contacts.push_back(
        {static_cast<int>(member), kWall, towards, restitution_of(S(rules.wall_restitution))});
  }
}

template <class P>
void TouchSearch<P>::add_contact(Group& group, std::size_t member, Index j, At now,
                                 bool meets) const {
  const Index i = group.members[member];
  const std::size_t other = group.find(j);
  const bool known = other < group.members.size();
  const Vec<S> there = known ? group.places[other] : motion_.wrapped(motion_.place(disks_[j], now));
  const Vec<S> r = motion_.way(group.places[member], there);
  if (!meets && !touch(i, j, now, r)) return;
  if (!known) add_member(group, j, now);
  if (in_island(i) || in_island(j)) return;
  // Each pair once: with the later of its balls, or the one that is not fixed.
  if (other > member && !motion_.fixed(disks_[j])) return;
  group.contacts.push_back({static_cast<int>(member), static_cast<int>(other), r,
                            restitution_of(S(motion_.rules().restitution))});
}

template <class P>
bool TouchSearch<P>::touch(Index i, Index j, At now, const Vec<S>& r) const {
  const Disk& a = disks_[i];
  const Disk& b = disks_[j];
  const S reach = motion_.species(a).radius + motion_.species(b).radius;
  if (!(squared_gap(r, reach) > 0)) return true;
  if (jam_.jammed() && near(r, reach, S(jam_.gap()))) return true;
  if (motion_.clusters() && near(r, reach, S(kTouching)) && motion_.collapses(a, b, now)) {
    return true;
  }
  return prediction_.pair_event(i, j, now) == now;
}

}  // namespace carom::event
