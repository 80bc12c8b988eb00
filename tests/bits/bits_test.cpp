// The bits of every scene of the tree and of one random scene for each set of effects, by both
// methods, are those pinned in pinned.txt.  Where a change of results is meant, the table is
// written again,
//     CAROM_BITS_TABLE=tests/bits/pinned.txt build/release/tests/carom_bits_tests
// and the commit says why.  The table holds for every machine and for builds without -march=native;
// tests/portable_bits compares those.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "bits/outcome.hpp"
#include "bits/table.hpp"

namespace carom::bits::bits_test {
namespace {

const std::filesystem::path kTop = CAROM_SOURCE_DIR;
const std::filesystem::path kPinned = kTop / "tests/bits/pinned.txt";

/// Of scenes that are new to the table.
constexpr double kSeconds = 5;

TEST(Bits, OfEverySceneAreThosePinned) {
  const char* table = std::getenv("CAROM_BITS_TABLE");
  std::vector<Row> rows = all_rows(kTop, read_table(kPinned), kSeconds);
  std::string changed;
  for (Row& row : rows) {
    const std::string pinned = row.outcome;
    row.outcome = outcome(kTop / row.scene, row.method, row.seconds);
    if (row.outcome != pinned) changed += to_line(row) + " (was " + pinned + ")\n";
  }
  if (table != nullptr) {
    write_table(table, rows);
    GTEST_SKIP() << "wrote " << table << "; changed:\n" << changed;
  }
  EXPECT_TRUE(changed.empty()) << "scenes whose bits have changed:\n" << changed;
}

TEST(Bits, TheTableNamesNoSceneThatIsGone) {
  for (const Row& row : read_table(kPinned)) {
    EXPECT_TRUE(std::filesystem::exists(kTop / row.scene)) << row.scene;
  }
}

}  // namespace
}  // namespace carom::bits::bits_test
