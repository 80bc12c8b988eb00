#include "standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace carom {

void hold_standard_streams() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // Open the wrong way round, so that using a stream which is closed still fails.
    const int mode = descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (open("/dev/null", mode) < 0) return;
  }
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw std::system_error(errno, std::generic_category(), "standard output");
  }
}

void print_error(const std::string& text) {
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  (void)std::fflush(stderr);
}

void print_error_line(const std::string& message) {
  constexpr std::size_t kLongest = 300;
  constexpr std::size_t kEnd = 120;  // the end says what is wrong, the beginning where
  if (message.size() <= kLongest) return print_error("carom: " + message + '\n');
  const auto inside = [&](std::size_t i) {  // a character of several bytes
    return (static_cast<unsigned char>(message[i]) & 0xC0U) == 0x80U;
  };
  std::size_t head = kLongest - kEnd;
  while (head > 0 && inside(head)) --head;
  std::size_t tail = message.size() - kEnd;
  while (tail < message.size() && inside(tail)) ++tail;
  print_error("carom: " + message.substr(0, head) + " ... " + message.substr(tail) + '\n');
}

}  // namespace carom
