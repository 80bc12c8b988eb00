#pragma once

#include "contact/event_scalar.hpp"

namespace carom::event {

/// When contacts come to rest, what carries them while they rest, and what wakes them.
///
/// With restitution below 1 there are infinitely many impacts in finite time; all but finitely many
/// of them fall into one tick of the clock, and there the series is summed.  No threshold is
/// absolute: all are the clock's own resolution, or a power of two times a time the contact itself
/// brings.
///
/// 1. A bounce under a pressing acceleration a (ball on a floor; also on a fixed ball, with
/// from_contact): after
///    an impact that leaves at speed v the hops still to come last 2 v / a (1 + e + e^2 + ...).
///    When that is no longer than the clock's resolution, the contact rests from the instant this
///    impact ends (bounces_out()).  The ball stays exactly where the impact left it, with normal
///    velocity 0.  Dropped from h it rests at sqrt(2h/g)(1+e)/(1-e), after about ln(2^53) / ln(1/e)
///    hops. The hops must be timed from h = 0 (wall_time) or from_contact (peg_time): with a gap
///    made of rounding they would never die out.
/// 2. Collapse without a force (McNamara and Young, Phys. Fluids A 4 (1992) 496): the impacts of a
/// line of balls
///    pile up before a moment.  A contact hit again within the clock's resolution of its last
///    impact is hit with restitution 0 (restitution_again()): from then on the two move together
///    and pair_time() is never, until another ball changes the flight of one.  Impacts of the same
///    instant go through joint_impact().
/// 3. A contact that presses but slides (a ball on the side of a fixed ball, a pile that still
/// creeps) has
///    no closed-form path.  It goes on hopping: hit again within hop_time(), which is 2^-10 of the
///    time the acceleration takes through the contact distance, it is hit with restitution 1 (the
///    contact-time model of Luding and McNamara, Granular Matter 1 (1998) 113).  That bounds the
///    impacts of each contact to 2^10 in that time, and the error to hops of 2^-23 of the contact
///    distance.
/// 4. A group all of whose contacts are resting or hopping, and whose reactions() leave no ball an
/// acceleration, is
///    put to rest as a whole: velocities 0, no flights, no predictions, no cost.  If some balls
///    accelerate, those contacts whose force is 0 are given up first; the rest of the group is
///    asked again. Held by: reactions() costs O(contacts) for each step of its conjugate gradients,
///    about the square root of the contacts in steps, once for each time a group comes to rest or
///    loses a member.
/// 5. A resting group wakes when a ball that is not in it hits one of its own (the impact goes
/// through
///    joint_impact() with all the group's contacts, so that a blow travels through a pile in no
///    time), when a ball or fixed ball that carries it is removed, or when gravity is set.  Balls
///    that leave a contact with speed fly; the others are asked by reactions() again.
///

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
S restitution_again(const S& restitution, const S& elapsed, const S& resolution) {
  return restitution < 1 && !(elapsed > resolution) ? S(0) : restitution;
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
