#include "view/curses_screen.hpp"

#define NCURSES_NOMACROS
#include <curses.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <stdexcept>
#include <vector>

#include "view/terminal_info.hpp"

namespace carom {
namespace {

// From slow to fast: of 256 colours, and of 8.
constexpr std::array<short, 8> kHeat256{33, 39, 44, 48, 118, 226, 214, 203};
constexpr std::array<short, 8> kHeat8{COLOR_BLUE,  COLOR_BLUE,   COLOR_CYAN, COLOR_CYAN,
                                      COLOR_GREEN, COLOR_YELLOW, COLOR_RED,  COLOR_RED};
constexpr short kFirstHeatPair = 9;

short pair_of(Ink ink) {
  return static_cast<short>(static_cast<int>(ink) + 1);
}

}  // namespace

class CursesScreen::Implementation {
 public:
  Implementation(Signals& signals, bool colors) : signals_(signals) {
    terminal_ = newterm(nullptr, stdout, stdin);
    if (terminal_ == nullptr) throw std::runtime_error("the terminal cannot be used");
    set_term(terminal_);
    avoid_repetition();
    cbreak();
    noecho();
    nonl();
    keypad(stdscr, TRUE);
    nodelay(stdscr, TRUE);
    set_escdelay(25);
    curs_set(0);
    leaveok(stdscr, TRUE);
    if (colors && has_colors() && start_color() == OK) set_colors();
    match_size();
  }

  ~Implementation() {
    leaveok(stdscr, FALSE);
    endwin();
    delscreen(terminal_);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  static Size size() { return {getmaxx(stdscr), getmaxy(stdscr)}; }

  void show(const Canvas& canvas) {
    line_.resize(static_cast<std::size_t>(canvas.columns));
    for (int row = 0; row < canvas.rows; ++row) {
      for (int column = 0; column < canvas.columns; ++column) {
        const Cell& cell = canvas.at(column, row);
        line_[static_cast<std::size_t>(column)] =
            static_cast<unsigned char>(cell.character) | look(cell);
      }
      mvaddchnstr(row, 0, line_.data(), canvas.columns);
    }
    wnoutrefresh(stdscr);
    doupdate();
  }

  Event wait_until(Instant deadline) {
    for (;;) {
      while (const auto signal = signals_.next()) {
        const Event event = answer(*signal);
        if (event.kind != Event::Kind::none) return event;
      }
      const int key = getch();
      if (key == KEY_RESIZE) continue;
      if (key != ERR) return {Event::Kind::key, key < 0x80 ? key : 0};
      if (hung_up_) return {Event::Kind::ended, SIGHUP};
      if (!sleep_until(deadline)) return {};
    }
  }

 private:
  /// False if the deadline came before anything else.
  bool sleep_until(Instant deadline) {
    const auto left = deadline - std::chrono::steady_clock::now();
    const auto wait = std::max(left, Instant::duration{0});
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wait);
    const timespec patience{seconds.count(),
                            static_cast<long>(std::chrono::nanoseconds(wait - seconds).count())};
    std::array<pollfd, 2> sources{{{STDIN_FILENO, POLLIN, 0}, {signals_.descriptor(), POLLIN, 0}}};
    const int ready = ppoll(sources.data(), sources.size(), &patience, nullptr);
    if (ready < 0 && errno != EINTR) throw std::runtime_error("the terminal cannot be waited for");
    // Of a terminal that is gone, nothing can be read any more.
    if ((sources[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) hung_up_ = true;
    return ready != 0;
  }

  Event answer(int signal) {
    switch (signal) {
      case SIGWINCH:
        match_size();
        return {Event::Kind::resized};
      case SIGTSTP:
        endwin();
        Signals::obey(SIGTSTP);  // stands still here until the program is continued
        [[fallthrough]];
      case SIGCONT:
        match_size();
        clearok(curscr, TRUE);
        curs_set(0);
        return {Event::Kind::resumed};
      default:
        return {Event::Kind::ended, signal};
    }
  }

  void match_size() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0 || size.ws_col == 0)
      return;
    if (is_term_resized(size.ws_row, size.ws_col)) {
      resize_term(size.ws_row, size.ws_col);
      werase(stdscr);
      clearok(curscr, TRUE);
    }
  }

  void set_colors() {
    use_default_colors();
    colors_ = true;
    const auto pair = [](Ink ink, short color) { init_pair(pair_of(ink), color, -1); };
    pair(Ink::wall, -1);
    pair(Ink::periodic, COLOR_CYAN);
    pair(Ink::open, -1);
    pair(Ink::fixed, -1);
    pair(Ink::status, -1);
    pair(Ink::notice, COLOR_YELLOW);
    pair(Ink::ghost, -1);
    const auto& heat = COLORS >= 256 ? kHeat256 : kHeat8;
    for (std::size_t i = 0; i < heat.size(); ++i)
      init_pair(static_cast<short>(kFirstHeatPair + static_cast<int>(i) + 1), heat[i], -1);
  }

  [[nodiscard]] chtype look(const Cell& cell) const {
    chtype look = 0;
    if (cell.ink == Ink::notice || cell.ink == Ink::fixed) look |= A_BOLD;
    if (cell.ink == Ink::open || cell.ink == Ink::ghost) look |= A_DIM;
    if (!colors_ || cell.ink == Ink::none) return look;
    if (cell.ink != Ink::ball) return look | static_cast<chtype>(COLOR_PAIR(pair_of(cell.ink)));
    const auto level = static_cast<std::size_t>(cell.heat * static_cast<float>(kHeat8.size()));
    const int step = static_cast<int>(std::min(level, kHeat8.size() - 1));
    if (COLORS < 256) look |= A_BOLD;
    return look | static_cast<chtype>(COLOR_PAIR(kFirstHeatPair + step + 1));
  }

  Signals& signals_;
  SCREEN* terminal_ = nullptr;
  bool colors_ = false;
  bool hung_up_ = false;
  std::vector<chtype> line_;
};

CursesScreen::CursesScreen(Signals& signals, bool colors)
    : implementation_(std::make_unique<Implementation>(signals, colors)) {}
CursesScreen::~CursesScreen() = default;

UserInterface::Size CursesScreen::size() const {
  return Implementation::size();
}

void CursesScreen::show(const Canvas& canvas) {
  implementation_->show(canvas);
}

Event CursesScreen::wait_until(Instant deadline) {
  return implementation_->wait_until(deadline);
}

}  // namespace carom
