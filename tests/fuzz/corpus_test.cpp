#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "read_scene.hpp"

namespace carom::corpus_test {
namespace {

namespace fs = std::filesystem;

std::size_t replay(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), 0);
  }
  return files.size();
}

TEST(FuzzCorpus, IsReadOrRefusedWithoutABrokenPromise) {
  EXPECT_GE(replay(CAROM_SOURCE_DIR "/tests/fuzz/corpus"), 20U);
  EXPECT_GE(replay(CAROM_SOURCE_DIR "/scenes"), 8U);
}

}  // namespace
}  // namespace carom::corpus_test
