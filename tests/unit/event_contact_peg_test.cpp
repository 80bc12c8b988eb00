#include <gtest/gtest.h>

#include <algorithm>

#include "support/peg_truth.hpp"
#include "trajectory/fixed_disk_time.hpp"
#include "trajectory/flight.hpp"

namespace carom::event::event_contact_peg_test {
namespace {

using test::Exact;
using test::FixedDiskCase;
using test::kU;
using test::RandomNumbers;
using V = Vec<double>;

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(EventFixedDiskTime, OfAStraightFallOntoThePegIsTheFallsTime) {
  EXPECT_EQ(fixed_disk_time<double>({0, 3}, {0, 0}, {0, -4}, 1), 1);
  EXPECT_EQ(fixed_disk_time<double>({3, 0}, {0, 0}, {-4, 0}, 1), 1);
  EXPECT_EQ(fixed_disk_time<double>({0, 3}, {0, 4}, {0, -4}, 3), 2);  // up from contact and back
  EXPECT_EQ(fixed_disk_time<double>({0, -3}, {0, 0}, {0, -4}, 1), kNever);
  EXPECT_EQ(fixed_disk_time<double>({0, -3}, {0, 4}, {0, -4}, 1), kNever);  // turns at -1: tangent
}

TEST(EventFixedDiskTime, WithoutGravityIsThePairTime) {
  EXPECT_EQ(fixed_disk_time<double>({3, 0}, {-2, 0}, {0, 0}, 1), 1);
  EXPECT_EQ(fixed_disk_time<double>({3, 0}, {2, 0}, {0, 0}, 1), kNever);
}

TEST(EventFixedDiskTime, OverlappingAndApproachingIsNow) {
  EXPECT_EQ(fixed_disk_time<double>({0.9, 0}, {-1, 0}, {0, -1}, 1), 0);
  EXPECT_EQ(fixed_disk_time<double>({0, 1}, {0, 0}, {0, -1}, 1), 0);  // pressed by gravity alone
  EXPECT_EQ(fixed_disk_time<double>({0, 0.5}, {0, 0.5}, {0, -1}, 1), 0.5);  // turns round inside
  EXPECT_EQ(fixed_disk_time<double>({0, -1}, {0, 0}, {0, -1}, 1), kNever);
}

TEST(EventFixedDiskTime, OfAHopOnThePegIsFoundHoweverShort) {
  for (int k = 4; k < 60; ++k) {
    const double v = std::ldexp(1.0, -k);
    EXPECT_NEAR(fixed_disk_time<double>({0, 1}, {0, v}, {0, -2}, 1, true), v, 2 * kU * v) << k;
    const auto slanted = fixed_disk_time<double>({0.6, 0.8}, {0.6 * v, 0.8 * v}, {0, -2}, 1, true);
    EXPECT_GT(slanted, v) << k;
    EXPECT_LT(slanted, 2 * v) << k;
  }
}

TEST(EventFixedDiskTime, NeverMissesARootNorFindsOneTooLate) {
  RandomNumbers random(20260);
  int hits = 0;
  int near = 0;
  for (int k = 0; k < 20000; ++k) {
    FixedDiskCase c = test::random_fixed_disk_case(random);
    if (!c.from_contact && squared_gap(c.r, c.s) <= 0) continue;
    if (c.from_contact && sharp_dot(c.r, c.v) <= 0) continue;
    const double t = fixed_disk_time(c.r, c.v, c.g, c.s, c.from_contact);
    const char* fault = test::fixed_disk_fault(c, t);
    ASSERT_EQ(fault, nullptr) << fault << ", case " << k << ", t " << t;
    hits += t < kNever ? 1 : 0;
    if (t == kNever || c.from_contact) continue;
    const Flight<double> there = after(BallisticLaw<double>{c.g}, Flight<double>{c.r, c.v}, t);
    const V n = there.position;
    near += std::abs(sharp_dot(n, there.velocity)) <
                    1e-6 * c.s * std::hypot(there.velocity.x, there.velocity.y)
                ? 1
                : 0;
  }
  EXPECT_GT(hits, 8000);
  EXPECT_GT(near, 500);
}

TEST(EventFixedDiskTime, IsTheSameForMirrorImagesAndScalesWithPowersOfTwo) {
  RandomNumbers random(3);
  for (int k = 0; k < 5000; ++k) {
    const FixedDiskCase c = test::random_fixed_disk_case(random);
    const double t = fixed_disk_time(c.r, c.v, c.g, c.s, c.from_contact);
    const auto m = [](const V& a) { return V{-a.x, a.y}; };
    const auto w = [](const V& a) { return V{a.y, a.x}; };
    ASSERT_EQ(fixed_disk_time(m(c.r), m(c.v), m(c.g), c.s, c.from_contact), t);
    ASSERT_EQ(fixed_disk_time(w(c.r), w(c.v), w(c.g), c.s, c.from_contact), t);
    ASSERT_EQ(fixed_disk_time(-c.r, -c.v, -c.g, c.s, c.from_contact), t);
    const double l = std::ldexp(1.0, random.below(81) - 40);
    const double u = std::ldexp(1.0, random.below(81) - 40);
    ASSERT_EQ(fixed_disk_time(l * c.r, (l / u) * c.v, (l / u / u) * c.g, l * c.s, c.from_contact),
              t * u);
  }
}

TEST(EventFixedDiskTime, InMoreDigitsAgreesWithDouble) {
  RandomNumbers random(4);
  for (int k = 0; k < 100; ++k) {
    const FixedDiskCase c = test::random_fixed_disk_case(random);
    const auto e = [](const V& a) { return Vec<Exact>{Exact(a.x), Exact(a.y)}; };
    const double t = fixed_disk_time(c.r, c.v, c.g, c.s, c.from_contact);
    const Exact truth = fixed_disk_time(e(c.r), e(c.v), e(c.g), Exact(c.s), c.from_contact);
    ASSERT_EQ(t < kNever, truth < never<Exact>());
    if (t == kNever || t == 0) continue;
    EXPECT_LE(test::error_in_u(t, truth), 4);
  }
}

}  // namespace
}  // namespace carom::event::event_contact_peg_test
