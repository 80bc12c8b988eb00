#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "contact/cone_island.hpp"
#include "contact/joint_friction.hpp"
#include "solvers/event/contact_line.hpp"
#include "solvers/event/huge_pages.hpp"
#include "solvers/event/impact_lines.hpp"
#include "solvers/event/impact_notes.hpp"
#include "solvers/event/motion.hpp"
#include "solvers/event/simultaneous_impact.hpp"

namespace carom::event {

/// Writes what happens to the flights of an event loop as lines of its notes.
///
/// REQUIRES: all but `slides` are called only where notes are wanted.
template <class P>
class ImpactWriter {
 public:
  using S = typename P::Scalar;
  using At = typename P::At;
  using Disk = typename P::Disk;

  /// Of these flights, by ball; all must outlive this.
  ImpactWriter(const Motion<P>& motion, const HugeVector<Disk>& disks, ImpactNotes& notes)
      : motion_(motion), disks_(disks), notes_(notes) {}

  /// An impact of two, or at a wall, from the velocities before and after, as it has left them.
  /// `was`, `partner_was`: the flights before.
  void single(Index i, Index partner, const Disk& was, const Disk& partner_was, double lost,
              At now) {
    const bool wall = partner >= kWalls;
    const bool moves = !wall && !motion_.fixed(disks_[partner]);
    // Which of the two it was found from must not show in the last bits.
    if (moves && partner < i) return single(partner, i, partner_was, was, lost, now);
    const Disk& a = disks_[i];
    const Vec<S> before = motion_.velocity(was, now);
    Vec<S> r{S(0), S(0)};
    if (wall) {
      const S side = partner % 2 == kWalls % 2 ? -1 : 1;
      (partner - kWalls < 2 ? r.x : r.y) = side;
    } else {
      r = motion_.way(motion_.place(a, now), motion_.place(disks_[partner], now));
    }
    const Impact contact = line(i, partner, r, now);
    SingleImpact impact;
    impact.from_a = contact.a == i;
    impact.change = {static_cast<double>(S(before.x - a.vx)),
                     static_cast<double>(S(before.y - a.vy))};
    impact.inverse_mass = static_cast<double>(motion_.species(a).inverse_mass);
    impact.friction = motion_.rules().spins;
    impact.lost = lost;
    notes_.add(single_line(contact, impact));
  }

  void joint(const SimultaneousImpact<S>& group, const JointRecord<S>& record, At now) {
    std::vector<Impact> contacts;
    JointCarried carried;
    carried.elastic = true;
    group.each_contact([&](const Contact<S>& contact, Index i, Index partner) {
      contacts.push_back(line(i, partner, contact.r, now));
      carried.elastic = carried.elastic && contact.restitution == 1;
    });
    for (const Stroke<S>& stroke : record.strokes) {
      carried.pushes.push_back(
          {stroke.contact, static_cast<double>(stroke.impulse), lost_of(stroke)});
    }
    carried.by_friction = record.by_friction;
    carried.held = record.held;
    notes_.add(joint_lines(contacts, carried, notes_.next_event()));
  }

  /// `island`: its members, its contacts (of two members, or of one with what never moves), and
  /// for each of those, near, the way r to the other and the partner that never moves.
  template <class Island>
  void island(const Island& island, const IslandCarried& carried, At now) {
    std::vector<Impact> contacts;
    for (std::size_t k = 0; k < island.contacts.size(); ++k) {
      const ConeContact& contact = island.contacts[k];
      const Index j = contact.b == kWall ? island.near[k].partner
                                         : island.members[static_cast<std::size_t>(contact.b)];
      contacts.push_back(
          line(island.members[static_cast<std::size_t>(contact.a)], j, island.near[k].r, now));
    }
    notes_.add(island_lines(contacts, carried, notes_.next_event()));
  }

  /// A ball at rest that moves from now on.
  void wake(Index i, At now) {
    const auto seconds = static_cast<double>(motion_.rules().scale.seconds(now));
    notes_.add(wake_line(in_double(motion_.place(disks_[i], now)), i, seconds));
  }

  /// What the flight of ball i, which was `was`, has slid till now, or none of it, where the flight
  /// goes on after all, as its end was taken back.  `spin`: at its start.
  void slides(Index i, const Disk& was, const S* spin, At now) {
    if (!notes_.wanted()) return;
    const auto seconds = static_cast<double>(motion_.rules().scale.seconds(now));
    if (disks_[i].start != now) {
      notes_.take_back_slides(i, seconds);
      return;
    }
    for (const auto& slide : motion_.slides_of(was, spin, now)) {
      const Vec<S> at = motion_.wrapped(motion_.place(was, now));
      notes_.add_slide(slide_line<P>(slide, in_double(at), i, seconds,
                                     static_cast<double>(motion_.species(disks_[i]).radius)));
    }
  }

 private:
  [[nodiscard]] Impact line(Index i, Index j, const Vec<S>& r, At now) const {
    return contact_line(motion_, disks_, i, j, r, now);
  }
  [[nodiscard]] static double lost_of(const Stroke<S>& stroke) {
    return static_cast<double>(S(stroke.impulse * stroke.approach * (1 - stroke.restitution) / 2));
  }

  const Motion<P>& motion_;
  const HugeVector<Disk>& disks_;
  ImpactNotes& notes_;
};

}  // namespace carom::event
