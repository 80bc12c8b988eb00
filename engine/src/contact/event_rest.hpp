#pragma once

#include "contact/event_scalar.hpp"

namespace carom::event {

// When contacts come to rest, what carries them while they rest, and what wakes them.
//
// With restitution below 1 there are infinitely many impacts in finite time.  No threshold is
// absolute: each is the clock's own resolution, or a power of two times a length, a time or a speed
// that the contact itself brings (s: its distance, g: gravity).
//
// Rule 1, bouncing out.  A ball that leaves a wall, against which gravity presses it, so slowly
// that the hop is over before the clock moves, rests on it from this instant: its normal velocity
// is 0 and nothing accelerates it that way.  Dropped from h it rests at sqrt(2h/g)(1+e)/(1-e),
// exactly at the wall, after about ln(2^55) / ln(1/e) hops; along the wall it glides on.  The same
// straight above a fixed ball.  Seen from a ball that falls it accelerates: peg_time().
//
// Rule 2, collapse without a force (McNamara and Young, Phys. Fluids A 4 (1992) 496).  Two that
// would part by less than 2^-95 of their distance in a tick take one normal velocity: they stay
// together, and are counted.  Balls that have been hit within 2^15 ticks before are resolved with
// all that touch them as one joint_impact().
//
// Rule 3, hopping.  A contact that presses but slides (a ball on the side of another, a pile that
// creeps) has no closed-form path.  It hops: an impact slower than 4 kHop sqrt(g s) of two that
// have both been hit within the time of such a hop parts as fast as it came, and not slower than
// kHop sqrt(g s); so does any impact of two that were hit within 2^-5 of that (Luding and
// McNamara, Granular Matter 1 (1998) 113: contacts that follow each other within a contact's
// duration lose nothing).  Hops are s 2^-15 high.  Contacts of one instant hop together, by the
// least impulses.
//
// Rule 4, rest.  At every whole multiple of a power of two of ticks, about the time of a fall
// through a ball, balls that are near and slow to each other are asked whether forces can carry
// them: settle() lets them sink to where all loaded contacts are closed; those that do not move
// there, by less than 2^-7 of s away, and have no partner that moves, are put there at rest, or to
// their common drift where no wall stops it.  A ball on a single one rests only straight above it.
//
// Rule 5, waking.  A group at rest wakes as a whole when a ball that is not of it hits one that is,
// when one of it is removed, or when gravity is set: all of it flies on from there.
//
// What there is to save of this is, ball by ball, the axes along which something carries it;
// which balls form a group, and which have been hit lately, follows from the flights.

/// Rule 1: leaving at v, pressed back by a, the hop is over before the clock moves.
template <class S>
bool bounces_out(const S& v, const S& a, const S& restitution, const S& resolution) {
  return restitution < 1 && a > 0 && 2 * v <= a * resolution;
}

/// Rule 3, in units of sqrt(g s): the speed at which hopping balls part, and how much faster than
/// that an impact may be to count as a hop.
inline constexpr double kHop = 0x1p-7;
inline constexpr double kSlow = 4;
/// An impact of two that have both been hit within this part of the time in which gravity makes
/// the speed of a hop counts as one however fast it is: shocks pass through a crowd in bounded
/// impacts.
inline constexpr double kShock = 0x1p-5;
/// What may be left of a joint hop.
inline constexpr double kHopError = 0x1p-24;

/// Rule 2: two that part by less than 2^this of their contact's distance in a tick stay together.
inline constexpr int kTogether = -95;
/// Ticks within which both have been hit before, where balls collapse.
inline constexpr double kCollapse = 0x1p15;

/// Balls that touch are so near, as a part of their contact's distance: nearer than what
/// neighbours are listed for.
inline constexpr double kTouching = 0x1p-31;

/// Rule 4: balls of a group are so near, as a part of their contact's distance.
inline constexpr double kNear = 0x1p-6;

/// Whether two that are r apart are nearer than their contact's distance and this part more of it.
template <class S>
bool near(const Vec<S>& r, const S& reach, const S& part) {
  const S most = reach + reach * part;
  return !(r.x * r.x + r.y * r.y > most * most);
}

/// Whether v is not beyond the speed of hops.
template <class S>
bool slow(const Vec<S>& v, const S& hop_speed) {
  return !(absolute(v.x) > kSlow * hop_speed || absolute(v.y) > kSlow * hop_speed);
}

/// Whether a ball at r from a fixed one lies and moves straight above it, to the last bit.
template <class S>
bool straight_up(const Vec<S>& r, const Vec<S>& v, const Vec<S>& gravity) {
  return cross(r, gravity) == 0 && cross(v, gravity) == 0 && sharp_dot(r, gravity) < 0;
}

}  // namespace carom::event
