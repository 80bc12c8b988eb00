#pragma once

#include <cstddef>

#include "numbers/scalar.hpp"

namespace carom::event {

// When contacts come to rest, what carries them while they rest, and what wakes them.
//
// With restitution below 1 there are infinitely many impacts in finite time.  No threshold is
// absolute: each is the clock's own resolution, or a power of two times a length, a time or a speed
// that the contact itself brings (s: its distance, g: gravity).
//
// Rule 1, bouncing out.  A ball that leaves a wall, against which gravity presses it, so slowly
// that the bounce is over before the clock moves, rests on it from this instant: its normal
// velocity is 0 and nothing accelerates it that way.  Dropped from h it rests at
// sqrt(2h/g)(1+e)/(1-e), exactly at the wall, after about ln(2^55) / ln(1/e) bounces; along the
// wall it glides on.  The same straight above a fixed ball.  Seen from a ball that falls it
// accelerates: fixed_disk_time(). Where the wall is elastic, and only other impacts, friction or
// drag lose energy, bounces do not end: there those within 2^-12 sqrt(s/g) are none, s twice the
// radius; they are 2^-27 s high.
//
// Along a wall with friction, with mu and the normal pull g_n, a uniform disk slides under g_t - mu
// g_n against its slip, its spin changing by 2 mu g_n / r in a second, until the slip is 0: an
// event of its own. Then it rolls, under two thirds of the pull along the wall and of the rate of
// drag, if friction can give it the other third, |g_t - k v| <= 3 mu g_n; the pull fades, so it
// then rolls until something meets it. Else it slides the way it is pulled.  What turns in a corner
// has friction at both walls until it turns no more, if its turning presses it to both.
//
// Rule 2, collapse without a force (McNamara and Young, Phys. Fluids A 4 (1992) 496).  Two that
// would part by less than 2^-40 of their distance while something crosses the box take one normal
// velocity: they stay together, and are counted.  Balls that have been hit within 2^15 ticks
// before, or have not moved by 2^-16 of their distance against each other since both were hit, are
// resolved with all that touch them as one joint_impact().  In that a contact that has bounced
// often enough stays shut (reflection_limits.hpp), so that what is pressed between elastic walls
// and lossy balls ends as contact.
//
// Rule 3, islands.  A contact that lasts and slides (a ball on the side of another, a pile that
// creeps) has no closed form.  Under gravity and with losses the balls of such contacts are a
// island, which is stepped: at every whole multiple of a power of two of ticks, h, about 2^-5 of
// the time of a fall through the largest radius of what moves (a step errs by its square: of up to
// four balls in all, where impacts lose energy, 2^-12 of it), each of its balls gets g h and the
// least impulses by which no contact closes beyond touching until the next step, friction included,
// and flies straight till then.  So its speed is that of the middle of its flight: what joins gets
// g h / 2, or as much of less than a step, what leaves or is hit on its way what it is owed, and
// the energy of a flight is that of its middle; what that leaves out is kept by ball where nothing
// takes energy (SteppedEnergy).  Impacts with others still come at their own times.  Two join an
// island by an impact
//   - after which they would meet again within a step, as gravity presses them together,
//   - or shortly after both have been hit: within 2^-12 sqrt(s/g), and 2^-12 of s: contacts last
//     so long (Luding and McNamara, Granular Matter 1 (1998) 113).
// Two that gravity presses together and that have no speed along their normal, but for a bounce
// within 2^-22 of the two, join whatever their restitution. Else, where collisions are elastic,
// something else must take energy from the two: one of them is carried already; or, where walls
// lose energy or there is friction or drag, one is within 2^-16 of its diameter of a wall and both
// have been hit within 2^-16 instead of 2^-12; or, where there is friction or drag, one is fixed
// and the other comes at less than 2^-12 sqrt(s g). A harder impact on an island is resolved for
// all of it at once: by the least impulses after which it parts e times as fast as it came and
// nothing closes.  A step of a large heap sees many: to an island of more than kFewOfHeap
// contacts belong, from each of its steps and impacts to the next step, also the balls that fly
// near to it, those that will meet one of it before that, from within kAhead, and such as do so
// with these.  Two that will meet by then bounce at once, so fast as they will be when they are
// back where they are, or are held from closing if they would not get there, and so are near ones
// that this drives together.  A ball that nothing in the island carries leaves it. An island gains
// no energy, but what the turning normals of its contacts took before; where balls lose energy,
// what ends a gain leaves their drift along an axis along which nothing that never moves can push
// them.  Where nothing loses energy along a normal, a step holds only what approaches no faster
// than 2 h (g + u^2 / s), u the slip, as gravity and the turning normal of a contact that lasts
// make it, u h / s being 2^-8 at most; what comes faster, or to a wall, is an impact at its own
// time, and so is what a hit between steps leaves closing by more than its gap until the next one.
// What presses in a step that would hold what moves, as one that closes a wedge does, is a joint
// impact.  Where impacts lose energy, what comes faster than that, and would close before the next
// step, bounces in this one; such a step is an impact.  A step is no hit: what it leaves is not
// taken for what has just been hit.
//
// Rule 4, rest.  Balls that carry each other and that a step leaves slower than 2^-10 g h are laid
// to rest where they are, if forces within the cones of friction hold them there, which is asked of
// up to 16 balls: what is pulled, by 2^-22 g, moves on.  Where balls lose energy, so does, by
// however little, what is pulled along walls without friction and touches nothing else that never
// moves.  A ball on a single fixed one rests only straight above it.  While an island rests it
// costs nothing.  In an island of more than kFewOfHeap contacts each ball rests by itself: one that
// was so slow before the step, too, and from which every faster one is more than two contacts away.
// It then stands as walls do, until a faster one comes as near, or one of every eight steps, which
// asks all, shows that it moves.
//
// Rule 5, waking.  An island at rest moves again when a ball that is not of it hits one that is,
// when one of it is removed, or when gravity is set.
//
// What there is to save of this is, ball by ball, the axes along which something carries it, and
// whether it is in an island, and rests; the rest follows from the flights.

/// Rule 1: leaving at v, pressed back by a, the bounce is over before the clock moves.
template <class S>
bool bounces_out(const S& v, const S& a, const S& restitution, const S& resolution) {
  return restitution < 1 && a > 0 && 2 * v <= a * resolution;
}

/// Rules 1 and 3: how long a contact lasts, and how far its balls part, as a part of its distance
/// and of the time of a fall through it.
inline constexpr double kShortly = 0x1p-12;
/// The same for elastic balls, from which only something else takes energy.
inline constexpr double kBriefly = 0x1p-16;
/// The same where nothing takes any: a bounce so short has 2^-49 of the energy of a fall through s.
inline constexpr double kAtOnce = 0x1p-22;

/// Rule 1, where what is bounced off is elastic: the bounce is shorter than a contact of distance
/// s.
template <class S>
bool barely_bounces(const S& v, const S& a, const S& s, double part = kShortly) {
  return a > 0 && 4 * v * v <= a * s * (part * part);
}

/// Rule 1, too: so many units of rounding of the speed along the wall are no speed away from it.
inline constexpr int kRounding = 64;

/// Rule 2: two that part by less than 2^this of their contact's distance while something crosses
/// the box stay together; ticks within which both have been hit before, where balls collapse, or
/// how far they have then moved against each other, as a part of that distance.
inline constexpr int kTogether = -40;
inline constexpr double kCollapse = 0x1p15;
inline constexpr double kCollapsed = 0x1p-16;

/// Balls that touch are so near, as a part of their contact's distance: nearer than what
/// neighbours are listed for.
inline constexpr double kTouching = 0x1p-31;

/// Rule 3: the longest step, as a part of the fall; how near the balls of an island are that a step
/// looks at together, as a part of their contact's distance.
inline constexpr double kStep = 0x1p-5;
inline constexpr double kNear = 0x1p-6;
/// Rule 3: so many balls can move where steps are shortest, and how much shorter they are then.
inline constexpr std::size_t kFewMovers = 4;
inline constexpr int kShortestStep = -7;
/// Rule 3: how near are those that will meet a ball of an island of many contacts before its next
/// step, and bounce ahead of that.
inline constexpr double kAhead = 0x1p-3;
/// An instant with more contacts than this is one of an island.
inline constexpr int kManyContacts = 16;

/// Rule 4, in parts of the speed that gravity makes in a step: what is still, what a contact
/// carries at least, and how exactly a step is solved.
inline constexpr double kStill = 0x1p-10;
inline constexpr double kLoaded = 0x1p-10;
inline constexpr double kSolved = 0x1p-12;
/// Rule 3, in the same parts: what slides along something that never moves opens no faster.
inline constexpr double kOpens = 0x1p-4;
/// Rule 3: a contact of balls that lose nothing along a normal lasts while it turns by no more than
/// this in a step: what comes faster than that explains is an impact, or it would overlap.
inline constexpr double kTurnOfStep = 0x1p-8;
/// Rule 3: what an impact leaves unsolved closes contacts by no more than this part of the largest
/// radius in a step, however fast something light has hit.
inline constexpr double kLeftOpen = 0x1p-16;
/// Rule 4: what forces hold is moved no faster by a step; of so many balls at most that is asked.
inline constexpr double kHeld = 0x1p-22;
inline constexpr std::size_t kFewHeld = 16;

/// Rule 4, in an island of more than kFewOfHeap contacts: what is so near to what moves, in
/// contacts, does not rest; one of so many steps asks what rests whether it does.
inline constexpr int kMovesAlong = 2;
inline constexpr int kAskedAgain = 8;
/// And so many contacts of what moves are few: they are in order already.
inline constexpr std::size_t kFewOfPart = 16;

/// Rule 3: steps of few balls are shorter by this power of two where their impacts, or those with
/// walls, lose energy; of twice as many they are sixteen times as long.
inline int shorter_steps(std::size_t movers) {
  int power = kShortestStep;
  for (std::size_t few = kFewMovers; few < movers && power < 0; few *= 2) power += 4;
  return power < 0 ? power : 0;
}

/// Whether two that are r apart are nearer than their contact's distance and this part more of it.
template <class S>
bool near(const Vec<S>& r, const S& reach, const S& part) {
  const S most = reach + reach * part;
  return !(r.x * r.x + r.y * r.y > most * most);
}

/// Whether a ball at r from a fixed one lies and moves straight above it, to the last bit.
template <class S>
bool straight_up(const Vec<S>& r, const Vec<S>& v, const Vec<S>& gravity) {
  return cross(r, gravity) == 0 && cross(v, gravity) == 0 && sharp_dot(r, gravity) < 0;
}

}  // namespace carom::event
