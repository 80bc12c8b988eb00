#include "export/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "export/unfinished_files.hpp"

namespace carom {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 16;
constexpr mode_t kNewFileMode = 0666;  // less the umask

/// The descriptor that a name like /dev/stdout or /dev/fd/3 stands for, else -1.
int named_descriptor(const std::string& file) {
  if (file == "-" || file == "/dev/stdout") return STDOUT_FILENO;
  if (file == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!file.starts_with(folder)) continue;
    int descriptor = -1;
    const char* const end = file.data() + file.size();
    const auto [stopped, error] = std::from_chars(file.data() + folder.size(), end, descriptor);
    if (error == std::errc{} && stopped == end) return descriptor;
  }
  return -1;
}

/// Where a chain of symbolic links ends, whether or not there is a file.
std::filesystem::path end_of_links(const std::string& name) {
  namespace fs = std::filesystem;
  constexpr int kLongestChain = 40;  // as Linux follows it
  std::error_code error;
  fs::path path = fs::absolute(name, error);
  for (int i = 0; i < kLongestChain && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

/// A name for the temporary file beside `target`: its own with six letters, cut where that would
/// be longer than a file's name may be.
std::string temporary_name(const std::filesystem::path& target) {
  constexpr std::string_view kEnding = ".XXXXXX";
  constexpr std::size_t kLongest = 255;  // bytes; NAME_MAX
  std::string name = target.filename().string();
  if (name.size() + kEnding.size() > kLongest) {
    std::size_t cut = kLongest - kEnding.size();
    while (cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xC0U) == 0x80U) --cut;
    name.resize(cut);
  }
  return target.parent_path() / (name + std::string(kEnding));
}

mode_t mode_of_new_files() {
  const mode_t mask = umask(0);
  umask(mask);
  return kNewFileMode & ~mask;
}

}  // namespace

bool is_standard_output(const std::string& file) {
  return named_descriptor(file) == STDOUT_FILENO;
}

bool is_same_file(const std::string& one, const std::string& other) {
  const int first_open = named_descriptor(one);
  const int second_open = named_descriptor(other);
  if (first_open >= 0 && first_open == second_open) return true;
  struct stat first {};
  struct stat second {};
  const bool first_there =
      first_open >= 0 ? fstat(first_open, &first) == 0 : stat(one.c_str(), &first) == 0;
  const bool second_there =
      second_open >= 0 ? fstat(second_open, &second) == 0 : stat(other.c_str(), &second) == 0;
  if (first_there && second_there) {
    // What is written through may well be shared, as /dev/null is.
    return S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
  }
  if (first_there != second_there) return false;
  const auto place = [](const std::string& name) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(end_of_links(name), ignored);
  };
  return place(one) == place(other);
}

OutputFile::OutputFile(const std::string& option, const std::string& name)
    : name_(option + ": " + (name == "-" ? "standard output" : name)) {
  if (name.empty()) return;
  if (const int open_already = named_descriptor(name); open_already >= 0) {
    descriptor_ = fcntl(open_already, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail();
    return;
  }
  struct stat status {};
  const bool exists = stat(name.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    fail();
  }
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(name.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail();
    return;
  }
  // A file that may not be written is not replaced either.
  if (exists && access(name.c_str(), W_OK) != 0) fail();
  std::error_code error;
  target_ = exists ? std::filesystem::canonical(name, error) : end_of_links(name);
  if (error) throw std::system_error(error, name_);
  temporary_ = temporary_name(target_);
  descriptor_ = unfinished_files::create(temporary_);
  if (descriptor_ < 0) {
    temporary_.clear();
    fail();
  }
  (void)fchmod(descriptor_, exists ? status.st_mode & 07777U : mode_of_new_files());
}

OutputFile::OutputFile(const std::string& option, const std::string& name, Kept)
    : name_(option + ": " + name), kept_(true) {
  if (name.empty()) return;
  struct stat status {};
  const bool exists = stat(name.c_str(), &status) == 0;
  if (named_descriptor(name) >= 0 || (exists && !S_ISREG(status.st_mode))) {
    throw std::system_error(ESPIPE, std::generic_category(),
                            name_ + ": a run with --checkpoint writes files only");
  }
  if (exists && access(name.c_str(), W_OK) != 0) fail();
  std::error_code error;
  target_ = exists ? std::filesystem::canonical(name, error).string() : name;
  if (error) throw std::system_error(error, name_);
  temporary_ = target_ + ".unfinished";
  descriptor_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kNewFileMode);
  if (descriptor_ < 0) fail();
  if (exists) (void)fchmod(descriptor_, status.st_mode & 07777U);
}

std::uint64_t OutputFile::keep() {
  if (descriptor_ < 0) return 0;
  flush();
  if (fsync(descriptor_) != 0) fail();
  return static_cast<std::uint64_t>(lseek(descriptor_, 0, SEEK_CUR));
}

bool OutputFile::go_on_after(std::uint64_t length) {
  if (descriptor_ < 0) return true;
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail();
  if (static_cast<std::uint64_t>(status.st_size) < length) return false;
  if (ftruncate(descriptor_, static_cast<off_t>(length)) != 0) fail();
  (void)lseek(descriptor_, 0, SEEK_END);
  return true;
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (kept_) return;
  if (!temporary_.empty()) unfinished_files::remove(temporary_);
}

void OutputFile::write(std::string_view text) {
  if (descriptor_ < 0) return;
  buffer_ += text;
  // What is written through may be watched as it comes.
  if (buffer_.size() >= kBufferSize || temporary_.empty()) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::commit() {
  if (descriptor_ < 0) return;
  flush();
  if (!temporary_.empty() && fsync(descriptor_) != 0) fail();
  if (close(std::exchange(descriptor_, -1)) != 0) fail();
  if (temporary_.empty()) return;
  if (rename(temporary_.c_str(), target_.c_str()) != 0) fail();
  if (!kept_) unfinished_files::forget(temporary_);
  temporary_.clear();
}

void OutputFile::fail() const {
  throw std::system_error(errno, std::generic_category(), name_);
}

}  // namespace carom
