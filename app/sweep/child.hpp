#pragma once

#include <string>
#include <vector>

namespace carom::sweeps {

/// A process that runs one point.
///
/// Holds: it ends with this program, however that ends.
class Child {
 public:
  /// Where it may write what is kept beside its output.
  static constexpr const char* kThirdFile = "/dev/fd/3";

  /// `input`: its standard input; its output, its errors and its third file are kept.
  /// Errors: std::system_error.
  Child(const std::vector<std::string>& words, const std::string& input);
  ~Child();
  Child(Child&&) noexcept;
  Child& operator=(Child&&) = delete;

  [[nodiscard]] int process() const { return process_; }
  /// What it left.
  /// REQUIRES: it has ended, with this status as waitpid() gives it.
  struct Outcome {
    bool good = false;
    std::string how;  ///< as in "exit status 2"
    std::string out;
    std::string err;
    std::string third;
  };
  [[nodiscard]] Outcome outcome(int status);

 private:
  int process_ = -1;
  int out_ = -1;  // files without a name
  int err_ = -1;
  int third_ = -1;
};

}  // namespace carom::sweeps
