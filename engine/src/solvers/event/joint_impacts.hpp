#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "contact/joint_friction.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/order_by_place.hpp"
#include "solvers/event/simultaneous_impact.hpp"

namespace carom::event {

/// What joint impacts do to the flights of their balls.
template <class P>
class JointImpacts {
 public:
  using S = typename P::Scalar;
  using At = typename P::At;
  using Disk = typename P::Disk;
  using Group = SimultaneousImpact<S>;

  /// The flights of all balls.
  struct Flights {
    HugeVector<Disk>& disks;
    std::vector<S>& spins;     ///< empty: they have none
    std::vector<Index>& left;  ///< the fixed ball at which each began; empty: it does not matter
  };
  /// All must outlive this.
  JointImpacts(const Motion<P>& motion, const Flights& flights)
      : motion_(motion), disks_(flights.disks), spins_(flights.spins), left_(flights.left) {}

  struct Outcome {
    JointReport report;
    std::vector<char> changed;  ///< by member: it moves otherwise than before
  };
  /// The group's bodies move, and turn, as they do afterwards.  `stops`: see JointImpact.
  Outcome resolve(Group& group, JointRecord<S>* record, bool stops) const {
    const std::vector<Body<S>> before = group.bodies;
    const std::vector<S> spins_before = group.spins;
    Outcome outcome{report_of(group, record, stops), std::vector<char>(group.members.size(), 0)};
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      bool same = before[k].velocity == group.bodies[k].velocity;
      if (!spins_.empty()) same = same && spins_before[k] == group.spins[k];
      outcome.changed[k] = same || motion_.fixed(disks_[group.members[k]]) ? 0 : 1;
    }
    return outcome;
  }

  /// Those that have changed begin new flights, exactly at the walls that they meet.
  void begin_flights(const Group& group, const std::vector<char>& changed, At now) {
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      if (changed[k] == 0) continue;
      const Index m = group.members[k];
      Disk& disk = disks_[m];
      disk.x = group.places[k].x;
      disk.y = group.places[k].y;
      disk.vx = with_plain_zero(group.bodies[k].velocity.x);
      disk.vy = with_plain_zero(group.bodies[k].velocity.y);
      if (!spins_.empty()) spins_[m] = group.spins[k];
      disk.start = now;
      if (!left_.empty()) left_[m] = kUnknown;
    }
    for (const typename Group::Stop& stop : group.stops) {
      Disk& disk = disks_[group.members[stop.member]];
      // To move the others would take the energy of their height.
      if (disk.start != now || !stop.meets) continue;
      const S at = motion_.wall(disk, {disk.x, disk.y}, stop.wall).stop;
      (stop.wall - kWalls < 2 ? disk.x : disk.y) = at;
    }
    if (!left_.empty()) note_left(group, now);
  }

  /// How many contacts of balls do not part any more, where nothing presses them together.
  [[nodiscard]] std::size_t staying_together(const Group& group, At now) const {
    std::size_t staying = 0;
    for (const Contact<S>& contact : group.contacts) {
      if (contact.b == kWall || contact.restitution == 1) continue;
      const Disk& a = disks_[group.members[static_cast<std::size_t>(contact.a)]];
      const Disk& b = disks_[group.members[static_cast<std::size_t>(contact.b)]];
      if (a.start == now && b.start == now && motion_.stay_together(a, b)) ++staying;
    }
    return staying;
  }

 private:
  JointReport report_of(Group& group, JointRecord<S>* record, bool stops) const {
    const std::span<const Contact<S>> contacts = group.contacts;
    if (spins_.empty()) return resolve_jointly<S>(group.bodies, contacts, nullptr, record, stops);
    std::vector<S> radii;
    for (const Index m : group.members) radii.push_back(motion_.species(disks_[m]).radius);
    JointFriction<S> friction(group.bodies, group.spins, radii, contacts,
                              {motion_.rules().friction, motion_.rules().wall_friction});
    return resolve_jointly<S>(group.bodies, contacts, &friction, record, stops);
  }

  // Of several fixed balls that it touches the flight began at the one that lies first, by place.
  void note_left(const Group& group, At now) {
    std::vector<const Vec<S>*> ways(group.members.size(), nullptr);
    for (const Contact<S>& contact : group.contacts) {
      if (contact.b == kWall) continue;
      const auto a = static_cast<std::size_t>(contact.a);
      const Index b = group.members[static_cast<std::size_t>(contact.b)];
      const Index ball = group.members[a];
      if (!motion_.fixed(disks_[b]) || disks_[ball].start != now) continue;
      const Vec<S>* first = ways[a];
      const Vec<S>& r = contact.r;
      if (first != nullptr && precedes_by_place(*first, r)) continue;
      ways[a] = &r;
      left_[ball] = b;
    }
  }

  const Motion<P>& motion_;
  HugeVector<Disk>& disks_;
  std::vector<S>& spins_;
  std::vector<Index>& left_;
};

}  // namespace carom::event
