#include "one_file.hpp"

#include <fmt/format.h>

#include "export/output_file.hpp"
#include "options.hpp"

namespace carom {

void refuse_one_file_for_two(const std::vector<std::pair<const char*, const std::string&>>& files) {
  for (auto one = files.begin(); one != files.end(); ++one) {
    for (auto other = one + 1; other != files.end(); ++other) {
      if (one->second.empty() || other->second.empty()) continue;
      if (!is_same_file(one->second, other->second)) continue;
      throw UsageError(fmt::format("{} and {} both write to '{}': give them two files", one->first,
                                   other->first, other->second));
    }
  }
}

}  // namespace carom
