#include "support/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace carom::support {
namespace {

constexpr int kSignalled = 128;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// In the child: only calls that are safe after a fork.
[[noreturn]] void become(char* const* words, const char* folder, const char* input, const char* out,
                         const char* err) {
  const int in_file = open(input, O_RDONLY);
  const int out_file = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (in_file >= 0 && out_file >= 0 && err_file >= 0 && chdir(folder) == 0 &&
      dup2(in_file, STDIN_FILENO) >= 0 && dup2(out_file, STDOUT_FILENO) >= 0 &&
      dup2(err_file, STDERR_FILENO) >= 0) {
    close(in_file);
    close(out_file);
    close(err_file);
    execv(words[0], words);
  }
  _exit(127);
}

}  // namespace

Running::Running(const std::vector<std::string>& words, const Surroundings& surroundings) {
  std::string name = (std::filesystem::temp_directory_path() / "carom-run-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) fail(name);
  capture_ = name;
  const std::string input = capture_ / "in";
  const std::string out = capture_ / "out";
  const std::string err = capture_ / "err";
  const std::string folder = surroundings.folder;
  write_file(input, surroundings.input);
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  arguments.reserve(copies.size() + 1);
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  process_ = fork();
  if (process_ < 0) fail("fork");
  if (process_ == 0) {
    become(arguments.data(), folder.c_str(), input.c_str(), out.c_str(), err.c_str());
  }
}

Running::~Running() {
  if (status_ < 0) {
    (void)kill(process_, SIGKILL);
    (void)waitpid(process_, nullptr, 0);
  }
  std::error_code ignored;
  std::filesystem::remove_all(capture_, ignored);
}

void Running::signal(int number) const {
  if (status_ < 0) (void)kill(process_, number);
}

bool Running::ended() {
  if (status_ >= 0) return true;
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return false;
  status_ = WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status);
  return true;
}

Outcome Running::wait() {
  if (status_ < 0) {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0) {
      if (errno != EINTR) fail("waitpid");
    }
    status_ = WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status);
  }
  return {read_file(capture_ / "out"), read_file(capture_ / "err"), status_};
}

Outcome run(const std::vector<std::string>& words, const Surroundings& surroundings) {
  return Running(words, surroundings).wait();
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "carom-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) fail(name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace carom::support
