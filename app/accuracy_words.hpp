#pragma once

#include <string>

#include "carom/accuracy.hpp"

namespace carom {

/// What a study comes to, in one or two plain sentences; with a target, the lines to put into the
/// scene.
std::string to_sentences(const AccuracyStudy& study);

}  // namespace carom
