#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "contact/pair_impact.hpp"
#include "trajectory/flight.hpp"
#include "trajectory/pair_time.hpp"
#include "trajectory/wall_time.hpp"

namespace carom::event::event_contact_symmetry_test {
namespace {

using V = Vec<double>;

double number(double limit) {
  return *rc::gen::inRange(-1000000, 1000001) / 1e6 * limit;
}
V vector(double limit) {
  return {number(limit), number(limit)};
}
V swapped(const V& a) {
  return {a.y, a.x};
}
V mirrored(const V& a) {
  return {-a.x, a.y};
}

RC_GTEST_PROP(EventContact, PairTimeIsTheSameForTheSwappedPairAndItsMirrorImages, ()) {
  const V r = vector(3);
  const V v = vector(2);
  const double s = std::abs(number(1)) + 0.1;
  const double t = pair_time(r, v, s);
  RC_ASSERT(pair_time(-r, -v, s) == t);
  RC_ASSERT(pair_time(mirrored(r), mirrored(v), s) == t);
  RC_ASSERT(pair_time(swapped(r), swapped(v), s) == t);
}

RC_GTEST_PROP(EventContact, PairTimeScalesExactlyWithPowersOfTwo, ()) {
  const V r = vector(3);
  const V v = vector(2);
  const double s = std::abs(number(1)) + 0.1;
  const int length = *rc::gen::inRange(-60, 61);
  const int speed = *rc::gen::inRange(-60, 61);
  const double l = std::ldexp(1.0, length);
  const double w = std::ldexp(1.0, speed);
  RC_ASSERT(pair_time(l * r, w * v, l * s) == pair_time(r, v, s) * (l / w));
}

RC_GTEST_PROP(EventContact, TwoFlightsSeeEachOtherTheSameFromBothSides, ()) {
  const BallisticLaw<double> law{vector(10)};
  const Flight<double> a{vector(10), vector(3)};
  const Flight<double> b{vector(10), vector(3)};
  const double t = std::abs(number(2));
  const auto ab = relative_at_later_start(law, a, 0.0, b);
  const auto ba = relative_at_later_start(law, b, 0.0, a);
  RC_ASSERT(ab.r == -ba.r);
  RC_ASSERT(ab.v == -ba.v);
  const BallisticLaw<double> law_m{mirrored(law.gravity)};
  const Flight<double> am{mirrored(a.position), mirrored(a.velocity)};
  const Flight<double> bm{mirrored(b.position), mirrored(b.velocity)};
  const auto seen = relative_at_later_start(law, a, t, b);
  const auto seen_m = relative_at_later_start(law_m, am, t, bm);
  RC_ASSERT(seen_m.r == mirrored(seen.r));
  RC_ASSERT(seen_m.v == mirrored(seen.v));
}

RC_GTEST_PROP(EventContact, PairImpactIsTheSameForTheSwappedPairAndItsMirrorImages, ()) {
  const V r = vector(3);
  const V va = vector(2);
  const V vb = vector(2);
  const double ma = std::abs(number(5));
  const double mb = std::abs(number(5));
  const double e = std::abs(number(1));
  RC_PRE(r.x != 0 || r.y != 0);
  const auto w = pair_impact(r, va, vb, ma, mb, e);
  const auto turned = pair_impact(-r, vb, va, mb, ma, e);
  RC_ASSERT(turned.a == w.b);
  RC_ASSERT(turned.b == w.a);
  const auto m = pair_impact(mirrored(r), mirrored(va), mirrored(vb), ma, mb, e);
  RC_ASSERT(m.a == mirrored(w.a));
  RC_ASSERT(m.b == mirrored(w.b));
  const auto x = pair_impact(swapped(r), swapped(va), swapped(vb), ma, mb, e);
  RC_ASSERT(x.a == swapped(w.a));
  RC_ASSERT(x.b == swapped(w.b));
}

RC_GTEST_PROP(EventContact, WallTimeScalesExactlyWithPowersOfTwo, ()) {
  const double h = number(4);
  const double v = number(3);
  const double a = number(10);
  const double l = std::ldexp(1.0, *rc::gen::inRange(-60, 61));
  const double t = std::ldexp(1.0, *rc::gen::inRange(-60, 61));
  RC_ASSERT(wall_time(l * h, l / t * v, l / t / t * a) == wall_time(h, v, a) * t);
}

}  // namespace
}  // namespace carom::event::event_contact_symmetry_test
