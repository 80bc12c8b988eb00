#include "contact/joint_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace carom::event::joint_friction_test {
namespace {

using V = Vec<double>;

/// Disks that touch, of radius 1/2 where nothing else is said.
struct Group {
  std::vector<Body<double>> bodies;
  std::vector<double> spins;
  std::vector<double> radii;
  std::vector<Contact<double>> contacts;

  void add(const V& velocity, double spin, double inverse_mass = 1, double radius = 0.5) {
    bodies.push_back({velocity, inverse_mass});
    spins.push_back(spin);
    radii.push_back(radius);
  }
  JointReport resolve(double friction, JointRecord<double>* record = nullptr) {
    const std::span<const Contact<double>> all = contacts;
    JointFriction<double> by(bodies, spins, radii, all, {friction, friction});
    return resolve_jointly<double>(bodies, all, &by, record);
  }
  /// Of uniform disks.
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (bodies[k].inverse_mass == 0) continue;
      const V& v = bodies[k].velocity;
      const double turning = radii[k] * spins[k];
      sum += (v.x * v.x + v.y * v.y + turning * turning / 2) / bodies[k].inverse_mass / 2;
    }
    return sum;
  }
};

// A disk without spin that comes to a wall at 45 degrees.  Coulomb's law: mu times the normal
// impulse 2 slows it along the wall, and turns it by twice that over its radius.  With much
// friction the slip of 1 stops: a third of it is the disk's, two thirds are its turning.
TEST(JointFriction, OfAWallIsCoulombs) {
  for (const double mu : {0.0, 0.1, 1.0}) {
    Group group;
    group.add({1, -1}, 0);
    group.contacts.push_back({0, kWall, {0, -1}, 1});
    const double tangential = std::min(2 * mu, 1.0 / 3);
    const JointReport report = group.resolve(mu);
    EXPECT_NEAR(group.bodies[0].velocity.x, 1 - tangential, 1e-15) << mu;
    EXPECT_NEAR(group.bodies[0].velocity.y, 1, 1e-15) << mu;
    EXPECT_NEAR(std::abs(group.spins[0]), 2 * tangential / 0.5, 1e-15) << mu;
    // What the slip, from 1 to 1 - 3 J, loses to the impulse J.
    EXPECT_NEAR(report.lost, tangential * (1 - 1.5 * tangential), 1e-15) << mu;
  }
}

// A contact alone is an impact of two, to the last bit.
TEST(JointFriction, OfOneContactIsThatOfAPair) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 100; ++round) {
    const double angle = normal(random);
    const V r{std::cos(angle), std::sin(angle)};
    Group group;
    group.add({normal(random), normal(random)}, normal(random), 0.5);
    group.add({normal(random), normal(random)}, normal(random), 2, 0.5);
    group.contacts.push_back({0, 1, r, 0.75});
    const V v = group.bodies[1].velocity - group.bodies[0].velocity;
    if (!(sharp_dot(r, v) < 0)) continue;
    const FrictionBody<double> a{group.bodies[0].velocity, group.spins[0], 0.5, 0.5};
    const FrictionBody<double> b{group.bodies[1].velocity, group.spins[1], 0.5, 2};
    const double gain = 1.75 * approach_speed(r, v);
    const FrictionImpact<double> friction(a, b, r, gain, 0.3);
    const auto change_a = friction.on(a, -1, 1);
    const auto change_b = friction.on(b, 1, 1);
    const auto after = pair_impact<double>(r, a.velocity + change_a.velocity,
                                           b.velocity + change_b.velocity, 0.5, 2, 0.75);
    group.resolve(0.3);
    EXPECT_NEAR(group.bodies[0].velocity.x, after.a.x, 1e-15);
    EXPECT_NEAR(group.bodies[0].velocity.y, after.a.y, 1e-15);
    EXPECT_NEAR(group.bodies[1].velocity.x, after.b.x, 4e-15);
    EXPECT_NEAR(group.bodies[1].velocity.y, after.b.y, 4e-15);
    EXPECT_NEAR(group.spins[0], a.spin + change_a.spin, 1e-14);
    EXPECT_NEAR(group.spins[1], b.spin + change_b.spin, 1e-14);
  }
}

// Balls around one: momentum stays, nothing gains energy, and what is lost is what was told.
TEST(JointFriction, OfManyContactsAddsNoEnergyAndKeepsMomentum) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  double all_lost = 0;
  for (int round = 0; round < 200; ++round) {
    Group group;
    group.add({normal(random), normal(random)}, normal(random));
    const std::size_t others = 1 + random() % 5;
    for (std::size_t k = 0; k < others; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 6;
      group.add({normal(random), normal(random)}, normal(random));
      group.contacts.push_back({0, static_cast<int>(k) + 1, {std::cos(angle), std::sin(angle)}, 1});
    }
    const double had = group.energy();
    V before{0, 0};
    V after{0, 0};
    for (const auto& body : group.bodies) before = before + body.velocity;
    JointRecord<double> record;
    const JointReport report = group.resolve(0.5, &record);
    for (const auto& body : group.bodies) after = after + body.velocity;
    EXPECT_NEAR(after.x, before.x, 1e-13);
    EXPECT_NEAR(after.y, before.y, 1e-13);
    EXPECT_LE(group.energy(), had * (1 + 1e-14));
    double told = 0;
    for (const auto& change : record.by_friction) told += change.lost;
    EXPECT_NEAR(report.lost, told, 1e-14);
    all_lost += had - group.energy();
  }
  EXPECT_GT(all_lost, 10);
}

// Of two contacts of a ball each has half of its impulse: between two walls that it is pressed into
// a ball is turned by both, one this way and one that way, and not at all.
TEST(JointFriction, OfACornerThatIsHitStraightTurnsNothing) {
  Group group;
  group.add({-1, -1}, 0);
  group.contacts.push_back({0, kWall, {0, -1}, 1});
  group.contacts.push_back({0, kWall, {-1, 0}, 1});
  group.resolve(0.1);
  EXPECT_EQ(group.spins[0], 0);
  // Each takes half of mu times 2 from the speed along it, before the corner turns the ball round.
  EXPECT_NEAR(group.bodies[0].velocity.x, 0.9, 1e-15);
  EXPECT_NEAR(group.bodies[0].velocity.y, 0.9, 1e-15);
}

}  // namespace
}  // namespace carom::event::joint_friction_test
