#pragma once

#include "carom/scene.hpp"

namespace carom {

/// Prints what is odd but allowed about running the scene for so many simulated seconds, a line
/// each on standard error.
void print_warnings(const Scene& scene, double seconds);

}  // namespace carom
