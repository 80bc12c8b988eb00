#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "contact/joint_impact.hpp"
#include "support/exact_number.hpp"

namespace carom::event::event_contact_jammed_test {
namespace {

using V = Vec<double>;

struct Lattice {
  std::vector<Body<double>> bodies;
  std::vector<Contact<double>> contacts;

  JointReport resolve() {
    return joint_impact<double>(bodies, std::span<const Contact<double>>(contacts));
  }

  double energy() const {
    double sum = 0;
    for (const auto& body : bodies) {
      if (body.inverse_mass == 0) continue;
      sum += (body.velocity.x * body.velocity.x + body.velocity.y * body.velocity.y) /
             body.inverse_mass / 2;
    }
    return sum;
  }

  bool approaches() const {
    return std::any_of(contacts.begin(), contacts.end(), [&](const auto& c) {
      const auto& a = bodies[static_cast<std::size_t>(c.a)];
      const auto b = c.b == kWall ? Body<double>{{0, 0}, 0} : bodies[static_cast<std::size_t>(c.b)];
      return a.inverse_mass + b.inverse_mass > 0 && sharp_dot(c.r, b.velocity - a.velocity) < 0;
    });
  }

  bool bound() const {
    return std::any_of(contacts.begin(), contacts.end(), [&](const auto& c) {
      return c.b == kWall || bodies[static_cast<std::size_t>(c.b)].inverse_mass == 0 ||
             bodies[static_cast<std::size_t>(c.a)].inverse_mass == 0;
    });
  }
};

// Balls of diameter 1 on the places of a square lattice that fills its box: every gap is zero, and
// rows and columns that are full are jammed.
Lattice lattice(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&random](int n) {
    return static_cast<int>(random() % static_cast<unsigned>(n));
  };
  Lattice result;
  const int width = 1 + below(4);
  const int height = 1 + below(4);
  const bool walls = below(4) != 0;
  std::vector<int> at(static_cast<std::size_t>(width * height), -1);
  const auto place = [&](int x, int y) -> int& {
    return at[static_cast<std::size_t>(x + width * y)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (below(3) == 0) continue;
      place(x, y) = static_cast<int>(result.bodies.size());
      const double mass = std::ldexp(1.0, below(5) - 2) * (1 + 2 * below(2));
      const bool fixed = below(6) == 0;
      result.bodies.push_back({{double(below(7) - 3), double(below(7) - 3)}, fixed ? 0 : 1 / mass});
      if (fixed) result.bodies.back().velocity = {0, 0};
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int me = place(x, y);
      if (me < 0) continue;
      if (x + 1 < width && place(x + 1, y) >= 0) {
        result.contacts.push_back({me, place(x + 1, y), {1, 0}, 1});
      }
      if (y + 1 < height && place(x, y + 1) >= 0) {
        result.contacts.push_back({me, place(x, y + 1), {0, 1}, 1});
      }
      if (!walls || result.bodies[static_cast<std::size_t>(me)].inverse_mass == 0) continue;
      if (x == 0) result.contacts.push_back({me, kWall, {-1, 0}, 1});
      if (x == width - 1) result.contacts.push_back({me, kWall, {1, 0}, 1});
      if (y == 0) result.contacts.push_back({me, kWall, {0, -1}, 1});
      if (y == height - 1) result.contacts.push_back({me, kWall, {0, 1}, 1});
    }
  }
  return result;
}

TEST(EventJammed, TwoBallsThatFillTheHeightGlideOnWithAllTheirEnergy) {
  Lattice pair;
  pair.bodies = {{{0, 0}, 1}, {{-6, -2}, 1}};
  pair.contacts = {{0, kWall, {0, -1}, 1}, {0, 1, {0, 1}, 1}, {1, kWall, {0, 1}, 1}};
  const JointReport report = pair.resolve();
  EXPECT_GT(report.jammed, 0);
  EXPECT_EQ(report.held_energy, 0);
  EXPECT_FALSE(pair.approaches());
  EXPECT_NEAR(pair.energy(), 20, 20e-15);
  EXPECT_EQ(pair.bodies[1].velocity.y, 0);
  EXPECT_NEAR(pair.bodies[1].velocity.x, -std::sqrt(40.0), 1e-14);
}

TEST(EventJammed, EnergyThatNothingCanMoveWithIsHeld) {
  Lattice ball;
  ball.bodies = {{{0, 3}, 0.5}};
  ball.contacts = {{0, kWall, {0, -1}, 1}, {0, kWall, {0, 1}, 1}};
  const JointReport report = ball.resolve();
  EXPECT_EQ(report.held_energy, 9);
  EXPECT_EQ(ball.bodies[0].velocity, (V{0, 0}));
}

// A ball at rest that touches a wall, and one M times as heavy that comes to it.
Lattice between_wall_and_heavy(double heavy) {
  Lattice pair;
  pair.bodies = {{{0, 0}, 1}, {{-1, 0}, 1 / heavy}};
  pair.contacts = {{0, kWall, {-1, 0}, 1}, {0, 1, {1, 0}, 1}};
  return pair;
}

// There are as many impacts as the first digits of pi say (Galperin 2003): 3,141,592.  They are not
// waited for, as the angle of the wedge tells so after a few rounds.
TEST(EventJammed, AWedgeThatIsTooNarrowIsNotWaitedFor) {
  Lattice pair = between_wall_and_heavy(1e12);
  const JointReport report = pair.resolve();
  EXPECT_LE(report.rounds, 2 * kPatience);
  EXPECT_GT(report.jammed, 0);
  EXPECT_FALSE(pair.approaches());
  EXPECT_NEAR(pair.energy() + report.held_energy, 5e11, 5e11 * 1e-12);
}

// Upwards it closes a wedge of 1e-8 between a wall and a fixed ball, and it slides away from the
// wall by as little as that: it turns round, as after pi / 1e-8 impacts.
TEST(EventJammed, WhatClosesANarrowWedgeTurnsRound) {
  Lattice wedge{{{{1e-9, 1}, 2}, {{0, 0}, 0}}, {{0, kWall, {-1, 0}, 1}, {0, 1, {1, 1e-8}, 1}}};
  const JointReport report = wedge.resolve();
  EXPECT_GT(report.jammed, 0);
  EXPECT_EQ(report.held_energy, 0);
  EXPECT_FALSE(wedge.approaches());
  EXPECT_NEAR(wedge.bodies[0].velocity.y, -1, 1e-7);
  EXPECT_NEAR(wedge.energy(), 0.25, 0.25 * 1e-14);
}

// 0 fills the height, but for a wedge that closes to the left.  2 comes to it from the right and
// falls: 0 has nowhere to go, and what 2 has along it stays with it.
TEST(EventJammed, WhatComesToAJammedBallGoesOnAlongIt) {
  Lattice group{{{{0.002, 0}, 6}, {{0, 0}, 0}, {{-1e-4, -0.25}, 0.2}},
                {{0, kWall, {0, -1}, 1}, {0, 1, {-7e-7, 1}, 1}, {2, 0, {-1, -0.0037}, 1}}};
  const double before = group.energy();
  const JointReport report = group.resolve();
  EXPECT_EQ(report.held_energy, 0);
  EXPECT_FALSE(group.approaches());
  EXPECT_NEAR(group.energy(), before, 1e-14 * before);
  EXPECT_NEAR(group.bodies[2].velocity.y, -0.25, 0.0025);
}

TEST(EventJammed, ElasticLatticesKeepTheirEnergyAndEnd) {
  int jammed = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    Lattice group = lattice(seed);
    const double before = group.energy();
    const JointReport report = group.resolve();
    EXPECT_FALSE(group.approaches()) << seed;
    EXPECT_NEAR(group.energy() + report.held_energy, before, 1e-13 * before) << seed;
    if (report.jammed > 0) ++jammed;
  }
  EXPECT_GT(jammed, 100);
}

TEST(EventJammed, NeitherOrderNorUnitsChangeABit) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Lattice group = lattice(seed);
    const std::size_t n = group.bodies.size();
    Lattice other = group;
    std::vector<std::size_t> to(n);
    std::iota(to.begin(), to.end(), 0U);
    std::mt19937 random(seed);
    std::shuffle(to.begin(), to.end(), random);
    for (std::size_t k = 0; k < n; ++k) {
      Body<double>& body = other.bodies[to[k]];
      body = group.bodies[k];
      body.inverse_mass /= 8;
      body.velocity = 4.0 * body.velocity;
    }
    for (auto& c : other.contacts) {
      c.a = static_cast<int>(to[static_cast<std::size_t>(c.a)]);
      if (c.b != kWall) c.b = static_cast<int>(to[static_cast<std::size_t>(c.b)]);
      if (c.b != kWall && random() % 2 == 0) {
        std::swap(c.a, c.b);
        c.r = -c.r;
      }
    }
    std::shuffle(other.contacts.begin(), other.contacts.end(), random);
    group.resolve();
    other.resolve();
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(4.0 * group.bodies[k].velocity, other.bodies[to[k]].velocity) << seed;
    }
  }
}

TEST(EventJammed, InAHundredDigitsToo) {
  using test::Exact;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Lattice group = lattice(seed);
    std::vector<Body<Exact>> bodies;
    std::vector<Contact<Exact>> contacts;
    for (const auto& b : group.bodies) {
      bodies.push_back({{Exact(b.velocity.x), Exact(b.velocity.y)}, Exact(b.inverse_mass)});
    }
    for (const auto& c : group.contacts) {
      contacts.push_back({c.a, c.b, {Exact(c.r.x), Exact(c.r.y)}, Exact(1)});
    }
    const JointReport report =
        joint_impact(std::span<Body<Exact>>(bodies), std::span<const Contact<Exact>>(contacts));
    Exact sum = report.held_energy;
    for (const auto& body : bodies) {
      if (body.inverse_mass == 0) continue;
      sum += (body.velocity.x * body.velocity.x + body.velocity.y * body.velocity.y) /
             body.inverse_mass / 2;
    }
    const Exact before = group.energy();
    EXPECT_LE(abs(sum - before), before * Exact("1e-13")) << seed;
  }
}

}  // namespace
}  // namespace carom::event::event_contact_jammed_test
