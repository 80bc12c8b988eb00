#pragma once

#include <cstdint>
#include <string>

#include "view/canvas.hpp"

namespace carom {

/// A frame of a dump: a line "# frame K time T", then one line for each row, without trailing
/// blanks.
std::string to_text(const Canvas& canvas, std::uint64_t frame, double time);

}  // namespace carom
