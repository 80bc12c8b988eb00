#include <gtest/gtest.h>

#include <algorithm>

#include "contact/pair_impact.hpp"
#include "support/exact_number.hpp"
#include "support/random_numbers.hpp"
#include "trajectory/flight.hpp"
#include "trajectory/pair_time.hpp"

namespace carom::event::event_contact_pair_test {
namespace {

using test::error_in_u;
using test::Exact;
using test::kU;
using test::RandomNumbers;
using V = Vec<double>;
using Fifty = boost::multiprecision::number<boost::multiprecision::backends::cpp_bin_float<50>,
                                            boost::multiprecision::et_off>;

Vec<Exact> exact(const V& a) {
  return {Exact(a.x), Exact(a.y)};
}

V polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

/// The textbook root in a hundred digits.
Exact true_time(const V& r0, const V& v0, double s0) {
  const auto r = exact(r0);
  const auto v = exact(v0);
  const Exact b = r.x * v.x + r.y * v.y;
  const Exact c = r.x * r.x + r.y * r.y - Exact(s0) * s0;
  const Exact vv = v.x * v.x + v.y * v.y;
  const Exact d = b * b - vv * c;
  return d > 0 && b < 0 ? Exact((-b - sqrt(d)) / vv) : never<Exact>();
}

/// A velocity of the given speed whose straight way passes the origin at `impact`, seen from r.
V aimed(const V& r, double speed, double impact) {
  const double distance = std::hypot(r.x, r.y);
  const double angle = std::atan2(-r.y, -r.x) + std::asin(impact / distance);
  return polar(speed, angle);
}

TEST(EventPairTime, IsRightToFourUnitsForPairsAMillionDiametersApart) {
  RandomNumbers random(1);
  double worst = 0;
  for (int k = 0; k < 5000; ++k) {
    const double s = random.between(0.5, 1);
    const V r = polar(1e6 * random.between(0.5, 2), random.angle());
    const V v = aimed(r, random.between(1, 1000), s * random.between(-0.9, 0.9));
    const double t = pair_time(r, v, s);
    if (t == never<double>()) continue;  // the angle of aim was rounded past the ball
    worst = std::max(worst, error_in_u(t, true_time(r, v, s)));
  }
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, 4);
}

TEST(EventPairTime, IsRightToFourUnitsWhenTheSceneIsMovedByTwoToTheThirty) {
  RandomNumbers random(2);
  for (int k = 0; k < 2000; ++k) {
    const double offset = 0x1p30;
    const auto place = [&](double size) {  // exactly representable there, and the difference exact
      return offset + std::round(random.between(-size, size) * 0x1p20) * 0x1p-20;
    };
    const Flight<double> a{{place(8), place(8)}, polar(1, random.angle())};
    const Flight<double> b{{place(8), place(8)}, polar(2, random.angle())};
    const auto seen = relative_at_later_start(StraightLaw<double>{}, a, 0.0, b);
    const Exact truth = true_time(seen.r, seen.v, 0.25);
    const double t = pair_time(seen.r, seen.v, 0.25);
    const double distance = std::hypot(seen.r.x, seen.r.y);
    if (distance < 0.3 || truth == never<Exact>()) continue;
    const double l = std::abs(cross(seen.r, seen.v)) / (0.25 * std::hypot(seen.v.x, seen.v.y));
    if (l > 0.5) continue;
    EXPECT_EQ(seen.r.x, b.position.x - a.position.x);
    EXPECT_LE(error_in_u(t, truth), 5);
  }
}

TEST(EventPairTime, KeepsItsDigitsAtGapsOfABillionthOfTheDistance) {
  RandomNumbers random(3);
  double worst = 0;
  for (int k = 0; k < 5000; ++k) {
    const double s = random.between(0.5, 1);
    const V r = polar(s * (1 + random.between(0.5e-9, 2e-9)), random.angle());
    const V v = aimed(r, random.between(1, 1000), s * random.between(-0.5, 0.5));
    worst = std::max(worst, error_in_u(pair_time(r, v, s), true_time(r, v, s)));
  }
  EXPECT_GT(worst, 0);
  EXPECT_LE(worst, 4);
}

TEST(EventPairTime, OfRandomPairsIsAsRightAsTheirGrazingAllows) {
  RandomNumbers random(4);
  int hits = 0;
  for (int k = 0; k < 20000; ++k) {
    const double s = random.between(0.1, 1);
    const V r = polar(s * std::exp(random.between(1e-3, 6)), random.angle());
    const double graze = random.between(-1.2, 1.2);
    const V v = aimed(r, std::exp(random.between(-5, 5)), s * graze);
    const Exact truth = true_time(r, v, s);
    const double t = pair_time(r, v, s);
    ASSERT_EQ(t == never<double>(), truth == never<Exact>());
    if (t == never<double>()) continue;
    ++hits;
    const double nearness = 1 - std::abs(cross(r, v)) / (s * std::hypot(v.x, v.y));
    EXPECT_LE(error_in_u(t, truth), 4 + 4 / std::max(nearness, kU)) << k;
  }
  EXPECT_GT(hits, 10000);
}

TEST(EventPairTime, HitsIffTheImpactParameterIsBelowTheContactDistance) {
  for (int k = 1; k <= 15; ++k) {
    const double part = std::pow(10.0, -k);
    for (const double distance : {2.0, 64.0}) {
      const auto time = [&](double impact, double turn) {
        // turned by an exact quarter or not: (distance, impact) and speed along the first
        return turn != 0 ? pair_time<double>({impact, distance}, {0, -1}, 1)
                         : pair_time<double>({distance, impact}, {-1, 0}, 1);
      };
      for (const double turn : {0.0, 1.0}) {
        EXPECT_NE(time(1 - part, turn), never<double>()) << k;
        EXPECT_EQ(time(1 + part, turn), never<double>()) << k;
      }
    }
  }
}

TEST(EventPairTime, HitsIffBelowInAnyDirection) {
  RandomNumbers random(5);
  for (int k = 1; k <= 15; ++k) {
    for (int n = 0; n < 200; ++n) {
      const double s = random.between(0.5, 1);
      const V r = polar(s * random.between(2, 50), random.angle());
      V v = aimed(r, 1, s * random.sign() * (1 + random.sign() * std::pow(10.0, -k)));
      const auto re = exact(r);
      const auto ve = exact(v);
      const Exact l = re.x * ve.y - re.y * ve.x;
      const Exact part = 1 - abs(l) / (Exact(s) * sqrt(ve.x * ve.x + ve.y * ve.y));
      if (abs(part) < 8 * kU) continue;  // aiming itself is rounded
      EXPECT_EQ(pair_time(r, v, s) != never<double>(), part > 0) << k;
    }
  }
}

TEST(EventPairTime, IsNowForOverlappingAndApproachingAndNeverForLeaving) {
  EXPECT_EQ(pair_time<double>({0.9, 0}, {-1, 0}, 1), 0);
  EXPECT_EQ(pair_time<double>({0.9, 0}, {1, 0}, 1), never<double>());
  EXPECT_EQ(pair_time<double>({1, 0}, {-1, 0}, 1), 0);
  EXPECT_EQ(pair_time<double>({1, 0}, {1, 0}, 1), never<double>());
  EXPECT_EQ(pair_time<double>({1, 0}, {0, 1}, 1), never<double>());
  EXPECT_EQ(pair_time<double>({3, 0}, {0, 0}, 1), never<double>());
  EXPECT_EQ(pair_time<double>({3, 0}, {-2, 0}, 1), 1);
}

TEST(EventPairTime, WorksAtTheEndsOfItsStatedRange) {
  for (const int size : {-220, 219}) {
    for (const int speed : {-220, 219}) {
      const double s = std::ldexp(1.0, size - 1);
      const double v = std::ldexp(1.0, speed);
      const auto t = pair_time<double>({2 * s, s / 2}, {-v, 0}, s);
      EXPECT_EQ(t, std::ldexp(pair_time<double>({2, 0.5}, {-1, 0}, 1), size - 1 - speed));
      EXPECT_GT(t, 0);
    }
  }
}

TEST(EventPairImpact, OfEqualBallsHeadOnExchangesThemExactly) {
  RandomNumbers random(7);
  for (int k = 0; k < 1000; ++k) {
    const double v = random.between(0, 10);
    const double x = random.between(0.1, 3);
    const auto after = pair_impact<double>({x, 0}, {v, 0}, {0, 0}, 1 / 3.0, 1 / 3.0, 1);
    EXPECT_EQ(after.a.x, 0);
    EXPECT_EQ(after.b.x, v);
    const auto up = pair_impact<double>({0, x}, {0, v}, {0, 0}, 1 / 3.0, 1 / 3.0, 1);
    EXPECT_EQ(up.a.y, 0);
    EXPECT_EQ(up.b.y, v);
  }
}

/// How far an impact of two is from the contract's formula, in a hundred digits.
template <class S>
Exact error_of_impact(const V& r, const V& va, const V& vb, double ma, double mb, double e) {
  const auto in = [](const V& a) { return Vec<S>{S(a.x), S(a.y)}; };
  const auto after = pair_impact<S>(in(r), in(va), in(vb), S(1 / ma), S(1 / mb), S(e));
  const auto re = exact(r);
  const Vec<Exact> v{Exact(vb.x) - va.x, Exact(vb.y) - va.y};
  const Exact b = re.x * v.x + re.y * v.y;
  const Exact j = b < 0 ? Exact(-(1 + Exact(e)) * b / (re.x * re.x + re.y * re.y) /
                                (Exact(1 / ma) + Exact(1 / mb)))
                        : Exact(0);
  Exact worst = 0;
  const auto note = [&](const Exact& wanted, const S& got) {
    worst = std::max(worst, Exact(abs(wanted - Exact(got))));
  };
  note(va.x - j * (1 / ma) * re.x, after.a.x);
  note(va.y - j * (1 / ma) * re.y, after.a.y);
  note(vb.x + j * (1 / mb) * re.x, after.b.x);
  note(vb.y + j * (1 / mb) * re.y, after.b.y);
  return worst;
}

// With no restitution half of the impacts leave an approach that is rounding: making up for it
// must not turn them round.
TEST(EventPairImpact, IsTheContractsFormulaToAFewUnits) {
  RandomNumbers random(8);
  const Exact wide_unit = std::numeric_limits<Fifty>::epsilon();
  for (int k = 0; k < 5000; ++k) {
    const double ma = std::exp(random.between(-14, 14));
    const double mb =
        k % 7 == 0 ? std::numeric_limits<double>::infinity() : std::exp(random.between(-14, 14));
    const double e = k % 3 == 0 ? 1 : k % 3 == 1 ? 0 : random.between(0, 1);
    const V r = polar(random.between(0.5, 2), random.angle());
    const V va = polar(random.between(0, 2), random.angle());
    const V vb = polar(random.between(0, 2), random.angle());
    EXPECT_LE(error_of_impact<double>(r, va, vb, ma, mb, e), 32 * kU) << "restitution " << e;
    EXPECT_LE(error_of_impact<Fifty>(r, va, vb, ma, mb, e), 32 * wide_unit) << "restitution " << e;
  }
}

TEST(EventPairImpact, KeepsEnergyAndMomentumToTheRoundingOfTheVelocities) {
  RandomNumbers random(9);
  Exact drift = 0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const V r = polar(random.between(0.5, 2), random.angle());
    const V va = polar(1, random.angle());
    const V vb = polar(1, random.angle());
    const auto w = pair_impact<double>(r, va, vb, 1, 1, 1);
    const auto energy = [](const V& a, const V& b) {
      return Exact(Exact(a.x) * a.x + Exact(a.y) * a.y + Exact(b.x) * b.x + Exact(b.y) * b.y);
    };
    const Exact change = (energy(w.a, w.b) - energy(va, vb)) / 2;
    EXPECT_LE(abs(change), 8 * kU);
    drift += change;
    EXPECT_LE(abs(Exact(w.a.x) + w.b.x - va.x - vb.x), 2 * kU);
    EXPECT_LE(abs(Exact(w.a.y) + w.b.y - va.y - vb.y), 2 * kU);
  }
  // a walk, not a march: its standard deviation would be below u sqrt(n)
  EXPECT_LE(abs(drift), 4 * kU * std::sqrt(static_cast<double>(n)));
}

TEST(EventPairImpact, AlwaysEndsTheApproachEvenWhereRoundingSwallowsIt) {
  RandomNumbers random(10);
  int swallowed = 0;
  for (int k = 0; k < 20000; ++k) {
    const V r = polar(1, random.angle());
    V va = polar(random.between(0.5, 1), random.angle());
    // side by side, or together and fast, with the last bits of the approach left over
    V vb = k % 2 == 0 ? va : va + random.between(-1, 1) * V{-r.y, r.x};
    vb.x += random.between(-2, 2) * kU;
    vb.y += random.between(-2, 2) * kU;
    const bool approaching = sharp_dot(r, vb - va) < 0;
    const auto w = pair_impact<double>(r, va, vb, 1, k % 3 == 0 ? 0.0 : 1.0, 1);
    EXPECT_GE(sharp_dot(r, w.b - w.a), 0);
    EXPECT_LE(std::abs(w.a.x - va.x) + std::abs(w.a.y - va.y), 16 * kU);
    swallowed += approaching ? 1 : 0;
  }
  EXPECT_GT(swallowed, 1000);
}

TEST(EventPairImpact, DeflectsAGrazingBallRightly) {
  for (int k = 1; k <= 15; ++k) {
    const double part = std::pow(10.0, -k);
    const double y = 1 - part;
    const V r0{64, y};
    const auto t = pair_time<double>(r0, {-1, 0}, 1);
    const V r{64 - t, y};
    const auto w = pair_impact<double>(r, {0, 0}, {-1, 0}, 0, 1, 1);
    const Exact ye(y);
    const Exact deflection = 2 * ye * sqrt(1 - ye * ye);  // sin of twice the angle of the normal
    const Exact error = abs(Exact(w.b.y) - deflection) / deflection;
    EXPECT_LE(error, 16 * kU / part) << k;
  }
}

}  // namespace
}  // namespace carom::event::event_contact_pair_test
