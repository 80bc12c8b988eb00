#include "numbers/monotone_root.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "numbers/wide_number.hpp"

namespace carom::event::monotone_root_test {
namespace {

// Where the root is the lower end, 0, no step comes to it: numbers of many digits become smaller
// for as long as they are halved.
TEST(MonotoneRoot, AtAnEndThatIsZeroIsFoundInAnyDigits) {
  const WidePrecision precision(34);
  const auto line = [](const WideNumber& t) { return Tangent<WideNumber>{t, WideNumber(1.0)}; };
  const WideNumber root =
      monotone_root<WideNumber>(line, WideNumber(0.0), WideNumber(1.0), true,
                                std::numeric_limits<WideNumber>::epsilon(), WideNumber(-1.0));
  EXPECT_GE(root, 0);
  EXPECT_LT(root, 1e-90);
}

}  // namespace
}  // namespace carom::event::monotone_root_test
