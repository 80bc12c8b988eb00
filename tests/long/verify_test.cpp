// The long versions of the hard cases, as `carom verify --long` runs them.
#include <gtest/gtest.h>

#include <cstdio>

#include "carom/report.hpp"
#include "carom/verify.hpp"

namespace carom::verify_test {
namespace {

class LongCase : public testing::TestWithParam<const char*> {};

TEST_P(LongCase, Holds) {
  const auto results = verify({GetParam(), 1, true}, [](const CaseResult&) {});
  for (const CaseResult& result : results) {
    if (!result.not_for.empty()) continue;
    std::printf("%s: %s %.2g of %.2g\n", result.name.c_str(), result.measure.c_str(), result.value,
                result.limit);
    EXPECT_TRUE(result.passed) << result.measure << ' ' << result.value << ' ' << result.failure;
  }
}

INSTANTIATE_TEST_SUITE_P(Verify, LongCase,
                         testing::Values("dense", "gas", "speeds", "cooling", "pi"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace carom::verify_test
