#pragma once

#include <string>
#include <string_view>

namespace carom::json {

/// A key as a step of a JSON pointer (RFC 6901), with what would not print on one line escaped.
std::string pointer_step(std::string_view key);

}  // namespace carom::json
