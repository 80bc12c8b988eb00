#include "contact/cone_descent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/cone_interior.hpp"

namespace carom::event::cone_descent_test {
namespace {

constexpr double kGoal = 1e-12;

std::vector<ConeBody> bodies_of(std::size_t count, double inverse_mass) {
  return std::vector<ConeBody>(count, ConeBody{{0, 0}, 0, inverse_mass});
}

// Equal balls one on the other on a floor; all fall at speed 1.
struct Tower {
  explicit Tower(int height, double friction = 0) : bodies(bodies_of(std::size_t(height), 1)) {
    for (int k = 0; k < height; ++k) {
      contacts.push_back({k, k == 0 ? kWall : k - 1, {0, -1}, 0, friction});
    }
  }
  // How fast the edges part: only the floor is met.
  [[nodiscard]] ConeResponse::Column parting(const ConeResponse& response) const {
    ConeResponse::Column result(response.edges(), 0);
    for (std::size_t at = 0; at < response.edges(); at += response.size()) {
      result[at] = -response.scale(0);
    }
    return result;
  }
  // By contact.
  [[nodiscard]] std::vector<double> loads(const ConeResponse& response,
                                          const ConeResponse::Column& impulses) const {
    std::vector<double> result(contacts.size(), 0);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      for (std::size_t at = k; at < response.edges(); at += response.size()) {
        result[k] += response.scale(k) * impulses[at];
      }
    }
    return result;
  }

  std::vector<ConeBody> bodies;
  std::vector<ConeContact> contacts;
};

TEST(ConeResponse, AnImpulseMovesABallByItsInverseMass) {
  const std::vector<ConeBody> bodies = bodies_of(1, 0.5);
  ConeResponse response(bodies, {{0, kWall, {0, -1}, 0, 0}});
  ASSERT_EQ(response.scale(0), 1);
  ConeResponse::Column impulses(response.edges(), 0);
  ConeResponse::Column parts(response.edges(), 0);
  impulses[0] = 3;
  response.pass_on(impulses.data());
  EXPECT_EQ(response.totals()[0].x, 0);
  EXPECT_EQ(response.totals()[0].y, 1.5);
  response.part(parts.data());
  EXPECT_EQ(parts[0], 1.5);
}

TEST(ConeResponse, FrictionTurnsAUniformDiskTwiceAsFastAsItMovesIt) {
  // An edge of the cone with coefficient 1/2 pushes up by 1 and along by 1/2; of a uniform disk the
  // moment of inertia is m r^2 / 2.
  ConeResponse response(bodies_of(1, 1), {{0, kWall, {0, -1}, 0, 0.5}});
  ConeResponse::Column impulses(response.edges(), 0);
  impulses[0] = 1 / response.scale(0);
  response.pass_on(impulses.data());
  const ConeResponse::Total& total = response.totals()[0];
  EXPECT_NEAR(total.y, 1, 1e-15);
  EXPECT_NEAR(std::abs(total.x), 0.5, 1e-15);
  EXPECT_NEAR(std::abs(total.turning), 1, 1e-15);
}

TEST(ConeDescent, EachContactOfATowerCarriesWhatIsAboveIt) {
  for (const double friction : {0.0, 0.5}) {
    const Tower tower(5, friction);
    ConeResponse response(tower.bodies, tower.contacts);
    ConeResponse::Column parting = tower.parting(response);
    ConeResponse::Column impulses(response.edges(), 0);
    ConeDescent(response).solve(parting, impulses, kGoal);
    const std::vector<double> loads = tower.loads(response, impulses);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      EXPECT_NEAR(loads[k], 5 - static_cast<double>(k), 1e-9) << k << ", friction " << friction;
    }
  }
}

TEST(ConeDescent, WhatPartsIsNotPulledBack) {
  const Tower tower(2);
  ConeResponse response(tower.bodies, tower.contacts);
  ConeResponse::Column parting(response.edges(), 0);
  parting[0] = 1;
  ConeResponse::Column impulses(response.edges(), 0);
  ConeDescent(response).solve(parting, impulses, kGoal);
  EXPECT_EQ(tower.loads(response, impulses), (std::vector<double>{0, 0}));
}

void expect_loads(const Tower& tower, int height, double heavier, bool again) {
  const ConeResponse response(tower.bodies, tower.contacts);
  ConeResponse::Column parting = tower.parting(response);
  for (double& speed : parting) speed *= heavier;
  ConeResponse::Column impulses(response.edges(), 0);
  ASSERT_TRUE(solve_by_interior_point(response, parting, 1e-10, again, impulses));
  const std::vector<double> loads = tower.loads(response, impulses);
  for (int k = 0; k < height; ++k) {
    EXPECT_NEAR(loads[static_cast<std::size_t>(k)], heavier * (height - k), 1e-5) << k;
  }
}

// Many rows take another way than few.
TEST(ConeInterior, FindsTheSameLoadsAndThoseOfOtherSpeedsAfterThem) {
  for (const double friction : {0.0, 0.5}) {
    for (const int height : {40, 150}) {
      const Tower tower(height, friction);
      expect_loads(tower, height, 1, false);
      expect_loads(tower, height, 1.25, true);
      expect_loads(tower, height, 0, true);
    }
  }
}

}  // namespace
}  // namespace carom::event::cone_descent_test
