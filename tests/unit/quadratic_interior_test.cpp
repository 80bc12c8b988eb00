#include "contact/quadratic_interior.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "support/random_numbers.hpp"

namespace carom::event::quadratic_interior_test {
namespace {

// Impulses, or speeds, are drawn for contacts that may push, the other one is 0: what parts so is
// the one problem that they solve, though three in four contacts are more than the bodies have
// freedoms.
TEST(QuadraticInterior, FindsWhichContactsCarry) {
  constexpr double kGive = 0x1p-20;
  test::RandomNumbers random(7);
  for (int n = 0; n < 40; ++n) {
    const auto contacts = static_cast<std::size_t>(4 * (1 + random.below(20)));
    const std::size_t freedoms = 1 + contacts / 4;
    std::vector<std::vector<double>> rows(contacts, std::vector<double>(freedoms));
    for (auto& row : rows) {
      for (double& part : row) part = random.between(-1, 1);
    }
    ResponseMatrix response(contacts);
    std::vector<char> may(contacts, kPushes);
    std::vector<char> carries(contacts, 0);
    std::vector<double> impulses(contacts, 0.0);
    std::vector<double> parting(contacts, 0.0);
    for (std::size_t k = 0; k < contacts; ++k) {
      if (random.below(8) == 0) may[k] = random.below(2) == 0 ? kHolds : char{0};
      carries[k] = may[k] == kHolds || (may[k] == kPushes && random.below(2) == 0) ? 1 : 0;
      if (carries[k] != 0) {
        impulses[k] = random.between(0.5, 2) * (may[k] == kHolds && random.below(2) == 0 ? -1 : 1);
      } else {
        parting[k] = random.between(0.5, 2);
      }
    }
    for (std::size_t i = 0; i < contacts; ++i) {
      for (std::size_t j = 0; j < contacts; ++j) {
        for (std::size_t l = 0; l < freedoms; ++l) response.at(i, j) += rows[i][l] * rows[j][l];
        parting[i] -= response.at(i, j) * impulses[j];
      }
      parting[i] -= kGive * response.at(i, i) * impulses[i];
    }
    EXPECT_EQ(carrying_contacts(response, parting, may, kGive), carries) << n;
  }
}

TEST(QuadraticInterior, KnowsWhenNothingIsToCarry) {
  ResponseMatrix response(2);
  response.at(0, 0) = response.at(1, 1) = 1;
  const std::vector<char> push(2, kPushes);
  EXPECT_EQ(carrying_contacts(response, {1, 2}, push, 0x1p-20), (std::vector<char>{0, 0}));
  EXPECT_EQ(carrying_contacts(response, {0, 0}, push, 0x1p-20), (std::vector<char>{0, 0}));
  EXPECT_EQ(carrying_contacts(response, {-1, 2}, {kPushes, 0}, 0x1p-20), (std::vector<char>{1, 0}));
}

}  // namespace
}  // namespace carom::event::quadratic_interior_test
