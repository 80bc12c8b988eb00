#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace carom {

/// A file that a run writes: whole or not at all.
///
/// The text goes to a temporary file beside the named one, which `commit` puts in its place; until
/// then the named file is as it was.  What is no regular file (a device, a pipe, standard output as
/// "-") is written through.
///
/// Holds: without `commit` nothing is left behind, not even where a signal ends the program.
/// Threads: the control thread only.
/// Errors: std::system_error that names the option and the file.
class OutputFile {
 public:
  /// An empty name is no file: `write` and `commit` do nothing.  `option` is named in errors.
  OutputFile(const std::string& option, const std::string& name);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] explicit operator bool() const { return descriptor_ >= 0; }
  void write(std::string_view text);
  void commit();

 private:
  void flush();
  [[noreturn]] void fail() const;

  std::string name_;       // as the user knows it, for errors
  std::string target_;     // the file to replace
  std::string temporary_;  // empty: written through
  int descriptor_ = -1;
  std::string buffer_;
};

/// Whether a file of this name is standard output: "-", or its device.
bool is_standard_output(const std::string& file);

/// Whether two names are the same file.
bool is_same_file(const std::string& one, const std::string& other);

}  // namespace carom
