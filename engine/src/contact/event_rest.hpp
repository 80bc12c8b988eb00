#pragma once

#include "contact/event_scalar.hpp"

namespace carom::event {

// When contacts come to rest, what carries them while they rest, and what wakes them.
//
// With restitution below 1 there are infinitely many impacts in finite time; all but finitely many
// of them fall into one tick of the clock, and there the series is summed. No threshold is
// absolute: each is the clock's own resolution, or a power of two times a time that the contact
// itself brings.
//
// Rule 1, bouncing out. Under a pressing acceleration a (a ball on a floor; also on a fixed ball)
// the hops still to come after an impact that leaves at speed v last 2 v / a (1 + e + e^2 + ...).
// When that is no longer than the clock's resolution, the contact rests from this instant:
// bounces_out(). The ball stays exactly where the impact left it, its normal velocity 0. Dropped
// from h it rests at sqrt(2h/g)(1+e)/(1-e), after about ln(2^53) / ln(1/e) hops. Hops must be
// timed from h = 0 (wall_time) or from_contact (peg_time): those that start in a gap made of
// rounding would never die out.
//
// Rule 2, collapse without a force (McNamara and Young, Phys. Fluids A 4 (1992) 496). The impacts
// of a line of balls pile up before a moment. When a contact is hit again within the clock's
// resolution of its last impact, collapses(), all balls connected by contacts that were hit within
// that resolution take one inelastic joint_impact(): restitution 0 at all those contacts. From then
// on they part or move together, and pair_time() is never until another ball changes the flight of
// one. One pair at a time will not do: ten balls need more than 10^5 impacts within the tick.
//
// Rule 3, hopping. A contact that presses but slides (a ball on the side of a fixed ball, a pile
// that still creeps) has no closed-form path. It goes on hopping: hit again within hop_time(),
// 2^-10 of the time in which the acceleration makes the contact distance, it is hit with
// restitution 1 (the contact-time model of Luding and McNamara, Granular Matter 1 (1998) 113). That
// bounds the impacts of a contact to 2^10 in that time, and the hops to 2^-23 of the distance.
//
// Rule 4, rest. A group whose contacts all rest or hop, and whose reactions() leave no ball an
// acceleration, is put to rest as a whole: velocities 0, no flights, no predictions, no cost. If
// some balls accelerate, the contacts without a force are given up and the rest is asked again.
// reactions() costs O(contacts) for each step of its conjugate gradients, at least as many steps
// as the pile has layers, once each time a group comes to rest or loses a member.
//
// Rule 5, waking. A resting group wakes when a ball that is not of it hits one that is (the impact
// is a joint_impact() with all the group's contacts: a blow goes through a pile in no time), when
// one that carries it is removed, or when gravity is set. Balls that leave a contact with speed
// fly; the others are asked by reactions() again.

/// The hops still to come after leaving with speed v, pressed back by a, in time.
template <class S>
S bouncing_left(const S& v, const S& a, const S& restitution) {
  return 2 * v / (a * (1 - restitution));
}

/// Rule 1; resolution: the smallest step of the clock at this time.
template <class S>
bool bounces_out(const S& v, const S& a, const S& restitution, const S& resolution) {
  return restitution < 1 && a > 0 && bouncing_left(v, a, restitution) <= resolution;
}

/// Rule 2; elapsed: since the last impact of this contact.
template <class S>
bool collapses(const S& restitution, const S& elapsed, const S& resolution) {
  return restitution < 1 && elapsed <= resolution;
}

/// Rule 3: s the contact distance, a the acceleration that presses.
template <class S>
S hop_time(const S& s, const S& a) {
  return root(S(s / a)) / 1024;
}
template <class S>
S restitution_of_a_hop(const S& restitution, const S& elapsed, const S& hop) {
  return elapsed < hop ? S(1) : restitution;
}

}  // namespace carom::event
