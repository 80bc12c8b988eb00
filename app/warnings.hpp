#pragma once

#include "carom/scene.hpp"

namespace carom {

/// Prints warnings about running the scene for so many simulated seconds: valid, but probably not
/// what was meant.  One line each, on standard error.
void print_warnings(const Scene& scene, double seconds);

}  // namespace carom
