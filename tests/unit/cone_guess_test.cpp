#include "contact/cone_guess.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "contact/cone_descent.hpp"
#include "support/random_numbers.hpp"

namespace carom::event::cone_guess_test {
namespace {

using Column = ConeResponse::Column;

struct Island {
  std::vector<ConeBody> bodies;
  std::vector<ConeContact> contacts;

  /// How fast each edge parts where bodies move as they do.
  [[nodiscard]] Column parting(ConeResponse& response) const {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      response.totals()[k] = {bodies[k].velocity.x, bodies[k].velocity.y, bodies[k].turning};
    }
    Column result(response.edges(), 0);
    response.part(result.data());
    return result;
  }
};

/// Balls one on the other on a floor, each other one so much heavier; all fall at speed 1.
Island tower(int height, double heavier, double friction) {
  Island island;
  for (int k = 0; k < height; ++k) {
    island.bodies.push_back({{0, -1}, 0, k % 2 == 0 ? 1 : 1 / heavier});
    island.contacts.push_back({k, k == 0 ? kWall : k - 1, {0, -1}, 0, friction});
  }
  return island;
}

// By momentum: what stops a tower that falls at speed 1 is the mass above.
void expect_loads(const Island& island, ConeResponse& response, const Column& impulses) {
  double above = 0;
  for (std::size_t k = island.bodies.size(); k-- > 0;) {
    above += 1 / island.bodies[k].inverse_mass;
    double load = 0;
    for (std::size_t at = k; at < response.edges(); at += response.size()) {
      load += response.scale(k) * impulses[at];
    }
    EXPECT_NEAR(load, above, 1e-9 * above) << k;
  }
}

TEST(ConeGuess, OfHeavyBallsOnLightOnesCarriesWhatIsAbove) {
  for (const double heavier : {1.0, 1e4, 1e6}) {
    for (const double friction : {0.0, 0.5}) {
      const Island island = tower(12, heavier, friction);
      ConeResponse response(island.bodies, island.contacts);
      const Column parting = island.parting(response);
      Column impulses(response.edges(), 0);
      ASSERT_TRUE(guess_cone_impulses(response, parting, 1e-12, impulses));
      expect_loads(island, response, impulses);
    }
  }
}

// Descents alone end after 64,000 with a ball that still falls.
TEST(ConeGuess, EndsALongWayOfDescents) {
  const Island island = tower(12, 1e6, 0.5);
  ConeResponse response(island.bodies, island.contacts);
  Column parting = island.parting(response);
  Column impulses(response.edges(), 0);
  ConeDescent(response).solve(parting, impulses, 1e-9);
  expect_loads(island, response, impulses);
}

/// Balls on a lattice between two walls, of any masses, that move anyhow.
Island patch(test::RandomNumbers& random) {
  constexpr int kWide = 4;
  Island island;
  const double friction = random.below(2) == 0 ? 0 : 0.4;
  for (int k = 0; k < kWide * kWide; ++k) {
    const Vec<double> v{random.between(-1, 1), random.between(-1, 1)};
    island.bodies.push_back({v, 0, std::exp(random.between(-6, 6))});
    const int x = k % kWide;
    const int y = k / kWide;
    if (x > 0) island.contacts.push_back({k, k - 1, {-1, 0}, 0, friction});
    if (y > 0) island.contacts.push_back({k, k - kWide, {0, -1}, 0, friction});
    if (y > 0 && x > 0 && random.below(2) == 0) {
      island.contacts.push_back({k, k - kWide - 1, {-0.6, -0.8}, 0, friction});
    }
    if (x == 0) island.contacts.push_back({k, kWall, {-1, 0}, 0, friction});
    if (y == 0) island.contacts.push_back({k, kWall, {0, -1}, 0, friction});
  }
  return island;
}

std::vector<std::size_t> shuffled(std::size_t n, test::RandomNumbers& random) {
  std::vector<std::size_t> where(n);
  std::iota(where.begin(), where.end(), 0);
  for (std::size_t k = n; k > 1; --k) {
    std::swap(where[k - 1], where[static_cast<std::size_t>(random.below(static_cast<int>(k)))]);
  }
  return where;
}

TEST(ConeGuess, PushesOnlyWhereNothingPartsAndDoesNotSeeTheOrder) {
  test::RandomNumbers random(1);
  for (int n = 0; n < 30; ++n) {
    const Island island = patch(random);
    ConeResponse response(island.bodies, island.contacts);
    const Column parting = island.parting(response);
    Column impulses(response.edges(), 0);
    ASSERT_TRUE(guess_cone_impulses(response, parting, 1e-9, impulses)) << n;
    Column after(response.edges(), 0);
    response.pass_on(impulses.data());
    response.part(after.data());
    for (std::size_t k = 0; k < after.size(); ++k) {
      EXPECT_GE(impulses[k], 0) << n;
      EXPECT_GE(after[k] + parting[k], -1e-8) << n;
      EXPECT_LE(std::min(impulses[k], after[k] + parting[k]), 1e-8) << n;
    }

    const auto body = shuffled(island.bodies.size(), random);
    const auto contact = shuffled(island.contacts.size(), random);
    Island other = island;
    for (std::size_t k = 0; k < body.size(); ++k) other.bodies[body[k]] = island.bodies[k];
    for (std::size_t k = 0; k < contact.size(); ++k) {
      ConeContact c = island.contacts[k];
      c.a = static_cast<int>(body[static_cast<std::size_t>(c.a)]);
      if (c.b != kWall) c.b = static_cast<int>(body[static_cast<std::size_t>(c.b)]);
      other.contacts[contact[k]] = c;
    }
    ConeResponse again(other.bodies, other.contacts);
    Column others(again.edges(), 0);
    ASSERT_TRUE(guess_cone_impulses(again, other.parting(again), 1e-9, others)) << n;
    for (std::size_t k = 0; k < contact.size(); ++k) {
      for (std::size_t side = 0; side < again.edges(); side += again.size()) {
        ASSERT_EQ(others[side + contact[k]], impulses[side + k]) << n << ' ' << k;
      }
    }
  }
}

TEST(ConeGuess, LeavesManyContactsToOthers) {
  const Island island = tower(static_cast<int>(kMostEdgesGuessed) + 1, 1, 0);
  ConeResponse response(island.bodies, island.contacts);
  Column impulses(response.edges(), 2);
  EXPECT_FALSE(guess_cone_impulses(response, island.parting(response), 1e-9, impulses));
  EXPECT_EQ(impulses, Column(response.edges(), 2));
}

}  // namespace
}  // namespace carom::event::cone_guess_test
