// The random scenes of property.AnyRun, 2,000 more.
#include <gtest/gtest.h>

#include "support/any_run.hpp"

namespace carom {
namespace {

TEST(AnyRunLong, KeepsEveryInvariant) {
  test::try_any_scenes(1000, 2999);
}

}  // namespace
}  // namespace carom
