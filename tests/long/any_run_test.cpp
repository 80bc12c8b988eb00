// The random scenes of property.AnyRun, 2,000 more, without those that may gather: the contact
// theory to come is to take them.
#include <gtest/gtest.h>

#include "support/any_run.hpp"

namespace carom::any_run_test {
namespace {

TEST(AnyRunLong, KeepsEveryInvariant) {
  test::try_any_scenes(1000, 2999, test::may_gather);
}

}  // namespace
}  // namespace carom::any_run_test
