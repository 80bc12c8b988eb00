#pragma once

#include <string>
#include <utility>
#include <vector>

namespace carom {

/// Two texts into one file would leave neither of them whole.  Each: the option, and the file it
/// names; an empty name is no file.
/// Errors: UsageError that names both options.
void refuse_one_file_for_two(const std::vector<std::pair<const char*, const std::string&>>& files);

}  // namespace carom
