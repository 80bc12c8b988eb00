#pragma once

#include <cstddef>
#include <string>

namespace carom {

/// What a time was measured on.
struct Machine {
  std::string processor;  ///< its model, as the system names it
  std::size_t cores = 0;  ///< that the program may use
  std::string system;
  std::string compiler;  ///< that the engine was built with
};

Machine this_machine();

}  // namespace carom
