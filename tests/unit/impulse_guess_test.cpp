#include "contact/impulse_guess.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "support/random_numbers.hpp"

namespace carom::event::impulse_guess_test {
namespace {

struct Problem {
  ResponseMatrix response;
  std::vector<double> parting;
};

/// The response of contacts whose impulses move some freedoms each: G' G, of a rank that may be
/// less than there are contacts.  What parts comes from a motion, so that there is a solution.
Problem random_problem(test::RandomNumbers& random, std::size_t contacts, std::size_t freedoms) {
  std::vector<std::vector<double>> rows(contacts);
  std::vector<double> motion(freedoms);
  for (double& v : motion) v = random.between(-1, 1);
  for (auto& row : rows) {
    for (std::size_t k = 0; k < freedoms; ++k) {
      row.push_back(random.below(3) == 0 ? random.between(-1, 1) : 0);
    }
    row[static_cast<std::size_t>(random.below(static_cast<int>(freedoms)))] += 1.5;
  }
  const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
  };
  Problem problem{ResponseMatrix(contacts), {}};
  for (std::size_t i = 0; i < contacts; ++i) {
    for (std::size_t j = 0; j < contacts; ++j)
      problem.response.at(i, j) = product(rows[i], rows[j]);
    problem.parting.push_back(product(rows[i], motion));
  }
  return problem;
}

std::vector<double> partings(const Problem& problem, const std::vector<double>& impulses) {
  std::vector<double> result = problem.parting;
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) {
      result[i] += problem.response.at(i, j) * impulses[j];
    }
  }
  return result;
}

// 0 <= impulse, 0 <= parting, and only one of them more than 0.
TEST(ImpulseGuess, PushesOnlyWhatWouldApproach) {
  test::RandomNumbers random(1);
  for (int n = 0; n < 200; ++n) {
    const auto contacts = static_cast<std::size_t>(1 + random.below(30));
    const Problem problem =
        random_problem(random, contacts, static_cast<std::size_t>(2 + random.below(20)));
    const std::vector<double> impulses = guess_impulses(
        problem.response, problem.parting, std::vector<char>(contacts, kPushes), 0x1p-20, 3);
    const std::vector<double> after = partings(problem, impulses);
    for (std::size_t k = 0; k < contacts; ++k) {
      EXPECT_GE(impulses[k], 0) << n;
      EXPECT_GE(after[k], -1e-4) << n;
      if (impulses[k] > 1e-3) {
        EXPECT_NEAR(after[k], 0, 1e-4) << n;
      }
    }
  }
}

TEST(ImpulseGuess, HoldsBothWaysAndLeavesOutWhatMayDoNothing) {
  ResponseMatrix response(3);
  for (std::size_t k = 0; k < 3; ++k) response.at(k, k) = 2;
  const std::vector<double> impulses =
      guess_impulses(response, {1, 1, -1}, {kHolds, kPushes, 0}, 0x1p-20, 3);
  EXPECT_NEAR(impulses[0], -0.5, 1e-9);
  EXPECT_EQ(impulses[1], 0);
  EXPECT_EQ(impulses[2], 0);
}

}  // namespace
}  // namespace carom::event::impulse_guess_test
