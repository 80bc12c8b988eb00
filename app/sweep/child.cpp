#include "sweep/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill is POSIX
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace carom::sweeps {
namespace {

constexpr int kThird = 3;

int nameless_file() {
  const int file = memfd_create("carom", MFD_CLOEXEC);
  if (file < 0) throw std::system_error(errno, std::generic_category(), "memory for a run");
  return file;
}

void fill(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0) throw std::system_error(errno, std::generic_category(), "memory for a run");
    done += static_cast<std::size_t>(written);
  }
  (void)lseek(file, 0, SEEK_SET);
}

std::string text_of(int file) {
  std::string text;
  std::array<char, 65536> part{};
  (void)lseek(file, 0, SEEK_SET);
  for (ssize_t got = 0; (got = read(file, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(got));
  }
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& words, const std::string& input)
    : out_(nameless_file()), err_(nameless_file()), third_(nameless_file()) {
  const int in = nameless_file();
  fill(in, input);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "a process for a run");
  if (process_ == 0) {
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    (void)dup2(in, STDIN_FILENO);
    (void)dup2(out_, STDOUT_FILENO);
    (void)dup2(err_, STDERR_FILENO);
    // Where it is there already, it must not be closed as the program starts.
    if (third_ == kThird) {
      (void)fcntl(third_, F_SETFD, 0);
    } else {
      (void)dup2(third_, kThird);
    }
    execv("/proc/self/exe", arguments.data());
    _exit(127);
  }
  close(in);
}

Child::Child(Child&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      out_(std::exchange(other.out_, -1)),
      err_(std::exchange(other.err_, -1)),
      third_(std::exchange(other.third_, -1)) {}

Child::~Child() {
  if (process_ > 0) {
    (void)kill(process_, SIGKILL);
    (void)waitpid(process_, nullptr, 0);
  }
  if (out_ >= 0) close(out_);
  if (err_ >= 0) close(err_);
  if (third_ >= 0) close(third_);
}

Child::Outcome Child::outcome(int status) {
  process_ = -1;
  Outcome outcome;
  outcome.good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  outcome.how = WIFSIGNALED(status) ? fmt::format("signal {}", WTERMSIG(status))
                                    : fmt::format("exit status {}", WEXITSTATUS(status));
  outcome.out = text_of(out_);
  outcome.err = text_of(err_);
  outcome.third = text_of(third_);
  return outcome;
}

}  // namespace carom::sweeps
