#pragma once

#include <string>
#include <string_view>

namespace carom {

/// How a simulation computes, as far as its barriers are concerned.
enum class Computation {
  overlap,    ///< whole steps
  events,     ///< windows of free paths and conflict groups
  integrated  ///< method event with attraction: integrated pieces up to each impact
};

/// What is guaranteed once all threads have passed a barrier, in one or two sentences; `pairs`: a
/// phase after it tests pairs.
std::string guarantee_of(std::string_view barrier, Computation computation, bool pairs);

/// What is guaranteed between two frames.
std::string guarantee_between_frames();

}  // namespace carom
