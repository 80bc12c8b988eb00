// Every hard case that `carom verify` runs, as a test of its own.
#include <gtest/gtest.h>

#include <algorithm>

#include "carom/report.hpp"
#include "carom/verify.hpp"

namespace carom {

void PrintTo(const HardCase& each, std::ostream* out) {
  *out << each.name;
}

namespace {

class Hard : public testing::TestWithParam<HardCase> {};

TEST_P(Hard, Case) {
  const auto results = verify({GetParam().name, 1, false}, [](const CaseResult&) {});
  for (const CaseResult& result : results) {
    if (!result.not_for.empty()) continue;
    EXPECT_TRUE(result.passed) << result.name << ", " << method_name(result.method) << ": "
                               << result.measure << ' ' << result.value << " > " << result.limit
                               << ' ' << result.failure;
  }
}

TEST(HardCases, HaveEachASceneThatSaysWhatItIsAbout) {
  for (const HardCase& each : hard_cases()) {
    EXPECT_FALSE(each.about.empty()) << each.name;
    EXPECT_EQ(hard_scene(each.name).name, each.name);
  }
  EXPECT_THROW(hard_scene("no such case"), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Verify, Hard, testing::ValuesIn(hard_cases()), [](const auto& each) {
  std::string name = each.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace carom
