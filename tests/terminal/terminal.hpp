#pragma once

#include <sys/types.h>
#include <termios.h>
#include <vterm.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace carom::test {

/// A terminal with a program in it: a pseudo-terminal whose output libvterm reads.
///
/// The program is a job in the foreground of a session of its own, as a shell would start it, so
/// that it can be stopped and continued.
class Terminal {
 public:
  struct Settings {
    int columns = 80;
    int rows = 24;
    std::string folder;  ///< that the program is started in; empty: this one
    std::vector<std::string> environment{"TERM=xterm-256color", "LANG=C.UTF-8"};
  };
  using Condition = std::function<bool(const Terminal&)>;

  /// Runs carom with these arguments.
  explicit Terminal(const std::vector<std::string>& arguments);
  Terminal(const std::vector<std::string>& arguments, const Settings& settings);
  /// Runs a function of this program instead; what it gives is its exit status.
  explicit Terminal(const std::function<int()>& program);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(const std::string& keys) const;
  void resize(int columns, int rows);
  /// Sends a signal to the program.
  void signal(int number) const;

  /// Reads until the condition holds; false if it does not for a long time.
  bool wait(const Condition& condition);
  bool wait_for(const std::string& words);
  /// Reads for this long, and calls `seen` whenever something came.
  void watch(std::chrono::milliseconds time, const std::function<void()>& seen);
  static constexpr int kKilled = 1000;
  /// Reads until the program has ended; its exit status, or kKilled + the signal that killed it.
  int wait_for_end();
  /// Whether it ends, too, while its output is not read.
  bool ends_unread();
  bool wait_until_stopped();

  [[nodiscard]] std::string row(int row) const;
  [[nodiscard]] std::string text() const;  ///< all rows
  [[nodiscard]] bool shows(const std::string& words) const;
  [[nodiscard]] const std::string& output() const { return output_; }  ///< every byte so far
  [[nodiscard]] bool cursor_visible() const { return cursor_visible_; }
  [[nodiscard]] bool alternate_screen() const { return alternate_screen_; }
  /// The line discipline is what it was before the program started.
  [[nodiscard]] bool settings_restored() const;
  /// The mode of that number ("?1002h" and "?1002l") was set and not reset.
  [[nodiscard]] std::size_t count(const std::string& bytes) const;  ///< in the output
  [[nodiscard]] bool mode_on(const std::string& number) const;
  /// All: settings, cursor, screen, mouse, paste, title.
  [[nodiscard]] bool given_back() const;

 private:
  void start(const std::function<int()>& program, const Settings& settings);
  bool read_some(std::chrono::milliseconds patience);
  static int on_property(VTermProp property, VTermValue* value, void* self);

  int master_ = -1;
  int slave_ = -1;  // held open, so that what the program wrote last can be read
  pid_t leader_ = -1;
  pid_t program_ = -1;
  termios before_{};
  VTerm* vterm_ = nullptr;
  VTermScreen* screen_ = nullptr;
  VTermScreenCallbacks callbacks_{};
  int columns_ = 0;
  int rows_ = 0;
  bool cursor_visible_ = true;
  bool alternate_screen_ = false;
  std::string output_;
};

}  // namespace carom::test
