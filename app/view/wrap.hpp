#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// Words in lines of at most `width` characters; a longer word is cut.
std::vector<std::string> wrapped(std::string_view words, int width);

}  // namespace carom
