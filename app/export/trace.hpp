#pragma once

#include <string>

#include "carom/timeline.hpp"

namespace carom {

/// A timeline as Trace Event JSON, for Perfetto, chrome://tracing and Speedscope.
///
/// Thread `control` has a slice do_frame for each frame; thread `worker K` has a slice for each
/// phase, and one `wait NAME` while it waited at the barrier NAME.  Slices of a thread never
/// overlap, to the last bit of a double.
/// Source: Trace Event Format, Google, 2016.
std::string trace_json(const Timeline& timeline, const std::string& scene);

}  // namespace carom
