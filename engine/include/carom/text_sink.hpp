#pragma once

#include <functional>
#include <string_view>

namespace carom {

/// Takes a text piece by piece: what is long is never in memory as a whole.
using TextSink = std::function<void(std::string_view)>;

}  // namespace carom
