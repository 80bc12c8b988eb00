#pragma once

#include <string>

namespace carom {

/// Makes sure that the three standard streams are open, so that no file of ours becomes one.
void hold_standard_streams();

/// Writes to standard output at once.
/// Errors: std::system_error.
void print(const std::string& text);

/// Writes to standard error; what cannot be written there cannot be said anywhere.
void print_error(const std::string& text);

/// Writes one line "carom: MESSAGE" to standard error; a long one is cut in its middle.
void print_error_line(const std::string& message);

}  // namespace carom
