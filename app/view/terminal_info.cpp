#include "view/terminal_info.hpp"

#define NCURSES_NOMACROS
#include <curses.h>
#include <term.h>
#include <unistd.h>

#include <cstdlib>

namespace carom {

std::string terminal_problem() {
  const char* const name = std::getenv("TERM");
  if (name == nullptr || *name == '\0') return "TERM is not set";
  int found = 0;
  const bool known = setupterm(name, STDOUT_FILENO, &found) == OK;
  // tigetstr gives (char*)-1 for what is no string capability, and null for what is absent.
  static constexpr char kCapability[] = "cup";
  const bool moves = known && tigetstr(const_cast<char*>(kCapability)) != nullptr;
  if (known) del_curterm(cur_term);
  if (!known) return std::string("TERM=") + name + " is not a terminal known here";
  if (!moves) return std::string("TERM=") + name + " cannot move its cursor";
  return {};
}

void avoid_repetition() {
  repeat_char = nullptr;
}

}  // namespace carom
