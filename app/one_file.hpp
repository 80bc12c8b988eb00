#pragma once

#include <string>
#include <utility>
#include <vector>

namespace carom {

/// Refuses two outputs into the same file, which would destroy both.  Each: the option, and the
/// file that it names; an empty name is no file.
/// Errors: UsageError that names both options.
void refuse_one_file_for_two(const std::vector<std::pair<const char*, const std::string&>>& files);

}  // namespace carom
