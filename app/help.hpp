#pragma once

#include <string>

namespace CLI {
class App;
}

namespace carom {

/// A line of help: what to write, then what it means, wrapped to 80 columns.
std::string help_row(const std::string& what, const std::string& meaning);

/// The options of a command by their groups.
std::string help_options(const CLI::App& app);

}  // namespace carom
