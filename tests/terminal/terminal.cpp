#include "terminal.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "support/process.hpp"
#include "support/vterm_screen.hpp"

namespace carom::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kLong{30};  // a loaded machine, with sanitizers

/// What a shell does: the program is a job in the foreground, and who waits for it is its parent in
/// the same session.
[[noreturn]] void lead(int slave, int report, const std::function<int()>& program) {
  login_tty(slave);
  signal(SIGTTOU, SIG_IGN);
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    tcsetpgrp(STDIN_FILENO, getpid());
    signal(SIGTTOU, SIG_DFL);
    close(report);
    _exit(program());
  }
  setpgid(child, child);
  if (write(report, &child, sizeof child) != sizeof child) _exit(100);
  close(report);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  tcsetpgrp(STDIN_FILENO, getpid());
  if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
  signal(WTERMSIG(status), SIG_DFL);
  raise(WTERMSIG(status));
  _exit(200);
}

/// Where there are no settings of a person, and those of a test may be written.
const std::string& settings_folder() {
  static const support::TemporaryFolder kFolder;
  static const std::string kName = kFolder.path().string();
  return kName;
}

int run_carom(const std::vector<std::string>& arguments, const std::string& folder,
              const std::vector<std::string>& environment) {
  std::vector<char*> words;
  std::string program = CAROM_PROGRAM;
  std::vector<std::string> copies = arguments;
  words.push_back(program.data());
  for (std::string& argument : copies) words.push_back(argument.data());
  words.push_back(nullptr);
  for (const char* const name :
       {"TERM", "NO_COLOR", "COLORTERM", "LANG", "LC_ALL", "LINES", "COLUMNS"})
    unsetenv(name);
  setenv("XDG_CONFIG_HOME", settings_folder().c_str(), 1);
  if (!folder.empty() && chdir(folder.c_str()) != 0) return 125;
  for (const std::string& setting : environment) {
    const auto equals = setting.find('=');
    setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
  }
  execv(program.c_str(), words.data());
  return 126;
}

}  // namespace

Terminal::Terminal(const std::vector<std::string>& arguments) : Terminal(arguments, Settings()) {}

Terminal::Terminal(const std::vector<std::string>& arguments, const Settings& settings) {
  (void)settings_folder();  // of this process, not of the one that starts the program
  start([&] { return run_carom(arguments, settings.folder, settings.environment); }, settings);
}

Terminal::Terminal(const std::function<int()>& program) {
  start(
      [&] {
        setenv("TERM", "xterm-256color", 1);
        return program();
      },
      Settings());
}

void Terminal::start(const std::function<int()>& program, const Settings& settings) {
  columns_ = settings.columns;
  rows_ = settings.rows;
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns_);
  size.ws_row = static_cast<unsigned short>(rows_);
  if (openpty(&master_, &slave_, nullptr, nullptr, &size) != 0)
    throw std::runtime_error("no pseudo-terminal");
  tcgetattr(slave_, &before_);

  vterm_ = vterm_new(rows_, columns_);
  vterm_set_utf8(vterm_, 1);
  screen_ = vterm_obtain_screen(vterm_);
  callbacks_.settermprop = &Terminal::on_property;
  vterm_screen_set_callbacks(screen_, &callbacks_, this);
  vterm_screen_enable_altscreen(screen_, 1);
  vterm_screen_reset(screen_, 1);

  std::array<int, 2> report{};
  if (pipe(report.data()) != 0) throw std::runtime_error("no pipe");
  leader_ = fork();
  if (leader_ == 0) {
    close(master_);
    close(report[0]);
    lead(slave_, report[1], program);
  }
  close(report[1]);
  if (read(report[0], &program_, sizeof program_) != sizeof program_) program_ = -1;
  close(report[0]);
}

Terminal::~Terminal() {
  if (leader_ > 0) {
    kill(program_, SIGKILL);
    waitpid(leader_, nullptr, 0);
  }
  if (vterm_ != nullptr) vterm_free(vterm_);
  close(master_);
  close(slave_);
}

int Terminal::on_property(VTermProp property, VTermValue* value, void* self) {
  auto* const terminal = static_cast<Terminal*>(self);
  if (property == VTERM_PROP_CURSORVISIBLE) terminal->cursor_visible_ = value->boolean != 0;
  if (property == VTERM_PROP_ALTSCREEN) terminal->alternate_screen_ = value->boolean != 0;
  return 1;
}

void Terminal::type(const std::string& keys) const {
  if (write(master_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
    throw std::runtime_error("keys cannot be typed");
}

void Terminal::resize(int columns, int rows) {
  columns_ = columns;
  rows_ = rows;
  vterm_set_size(vterm_, rows, columns);
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = static_cast<unsigned short>(rows);
  ioctl(master_, TIOCSWINSZ, &size);
}

void Terminal::signal(int number) const {
  kill(program_, number);
}

bool Terminal::read_some(std::chrono::milliseconds patience) {
  pollfd source{master_, POLLIN, 0};
  if (poll(&source, 1, static_cast<int>(patience.count())) <= 0) return false;
  std::array<char, 65536> bytes{};
  const ssize_t count = read(master_, bytes.data(), bytes.size());
  if (count <= 0) return false;
  output_.append(bytes.data(), static_cast<std::size_t>(count));
  vterm_input_write(vterm_, bytes.data(), static_cast<std::size_t>(count));
  const std::size_t answer = vterm_output_read(vterm_, bytes.data(), bytes.size());
  return answer == 0 || write(master_, bytes.data(), answer) >= 0;
}

bool Terminal::wait(const Condition& condition) {
  const auto end = Clock::now() + kLong;
  while (!condition(*this)) {
    if (Clock::now() > end) return false;
    read_some(std::chrono::milliseconds{50});
  }
  return true;
}

bool Terminal::wait_for(const std::string& words) {
  return wait([&words](const Terminal& terminal) { return terminal.shows(words); });
}

void Terminal::watch(std::chrono::milliseconds time, const std::function<void()>& seen) {
  const auto end = Clock::now() + time;
  while (Clock::now() < end) {
    if (read_some(std::chrono::milliseconds{20})) seen();
  }
}

int Terminal::wait_for_end() {
  const auto end = Clock::now() + kLong;
  int status = 0;
  while (waitpid(leader_, &status, WNOHANG) == 0) {
    read_some(std::chrono::milliseconds{20});
    if (Clock::now() > end) return -1;
  }
  leader_ = -1;
  while (read_some(std::chrono::milliseconds{0})) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : kKilled + WTERMSIG(status);
}

bool Terminal::ends_unread() {
  const auto end = Clock::now() + kLong;
  while (waitpid(leader_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > end) return false;
    poll(nullptr, 0, 20);
  }
  leader_ = -1;
  return true;
}

bool Terminal::wait_until_stopped() {
  return wait([this](const Terminal&) {
    std::ifstream file("/proc/" + std::to_string(program_) + "/stat");
    const std::string stat{std::istreambuf_iterator<char>(file), {}};
    const auto name_end = stat.rfind(')');
    return name_end != std::string::npos && stat.substr(name_end, 4).find('T') != std::string::npos;
  });
}

std::string Terminal::row(int row) const {
  return support::row_of(screen_, row, columns_);
}

std::string Terminal::text() const {
  std::string text;
  for (int i = 0; i < rows_; ++i) text += row(i) + '\n';
  return text;
}

bool Terminal::shows(const std::string& words) const {
  return text().find(words) != std::string::npos;
}

bool Terminal::settings_restored() const {
  termios now{};
  tcgetattr(slave_, &now);
  return now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag &&
         now.c_cflag == before_.c_cflag && now.c_lflag == before_.c_lflag &&
         std::memcmp(now.c_cc, before_.c_cc, sizeof now.c_cc) == 0;
}

bool Terminal::given_back() const {
  for (const char* const mode : {"1000", "1002", "1003", "1006", "2004", "2026"}) {
    if (mode_on(mode)) return false;
  }
  return settings_restored() && cursor_visible_ && !alternate_screen_ &&
         count("\x1B[22;2t") == count("\x1B[23;2t");
}

bool Terminal::mode_on(const std::string& number) const {
  const auto on = output_.rfind("\x1B[?" + number + 'h');
  const auto off = output_.rfind("\x1B[?" + number + 'l');
  return on != std::string::npos && (off == std::string::npos || off < on);
}

std::size_t Terminal::count(const std::string& bytes) const {
  std::size_t times = 0;
  for (auto at = output_.find(bytes); at != std::string::npos; at = output_.find(bytes, at + 1))
    ++times;
  return times;
}

}  // namespace carom::test
