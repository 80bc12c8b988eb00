#pragma once

#include <cstdint>
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
  /// A file that stays unfinished where the program is killed, beside its name with ".unfinished",
  /// so that another one can go on with it.
  struct Kept {};
  OutputFile(const std::string& option, const std::string& name, Kept);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] explicit operator bool() const { return descriptor_ >= 0; }
  void write(std::string_view text);
  /// Hands over what was written so far.
  void flush();
  /// Of a kept file: its length, now that all is on the disk; goes on after so many bytes, which is
  /// false where there are not as many.
  [[nodiscard]] std::uint64_t keep();
  [[nodiscard]] bool go_on_after(std::uint64_t length);
  void commit();

 private:
  [[noreturn]] void fail() const;

  std::string name_;       // as the user knows it, for errors
  std::string target_;     // the file to replace
  std::string temporary_;  // empty: written through
  int descriptor_ = -1;
  bool kept_ = false;
  std::string buffer_;
};

/// Whether a file of this name is standard output: "-", or its device.
bool is_standard_output(const std::string& file);

/// Whether two names are the same file.
bool is_same_file(const std::string& one, const std::string& other);

}  // namespace carom
