#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace carom::support {

/// What a program that has ended leaves.
struct Outcome {
  std::string out;
  std::string err;
  int status = 0;  ///< exit status; 128 + the signal that ended it
};

/// Where and with what a program runs.
struct Surroundings {
  std::filesystem::path folder = ".";
  std::string input;  ///< its standard input
};

/// Runs a program to its end, without a terminal.
Outcome run(const std::vector<std::string>& words, const Surroundings& surroundings = {});

/// A program that runs on while the test goes on; killed at the end if it still does.
class Running {
 public:
  explicit Running(const std::vector<std::string>& words, const Surroundings& surroundings = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void signal(int number) const;
  [[nodiscard]] bool ended();
  Outcome wait();

 private:
  int process_ = -1;
  int status_ = -1;
  std::filesystem::path capture_;  // folder of what it wrote
};

/// A new folder that is gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& file);
void write_file(const std::filesystem::path& file, const std::string& text);

/// The names of what is in a folder, in order.
std::vector<std::string> names_in(const std::filesystem::path& folder);

}  // namespace carom::support
