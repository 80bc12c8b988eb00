#include "view/terminal_info.hpp"

#define NCURSES_NOMACROS
#include <curses.h>
#include <langinfo.h>
#include <locale.h>  // NOLINT(modernize-deprecated-headers): newlocale is POSIX
#include <term.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string_view>

#include "view/built_in_terminals.hpp"

namespace carom {
namespace {

constexpr const char* kFallback = "xterm-256color";
constexpr const char* kMovesAsAnsi = "\x1B[%i%p1%d;%p2%dH";

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool load_from_system(const std::string& name) {
  int found = 0;
  return setupterm(name.c_str(), STDOUT_FILENO, &found) == OK;
}

bool load(const std::string& name) {
  if (load_from_system(name)) return true;
  const char* const description = built_in_terminal(name);
  if (description == nullptr) return false;
  setenv("TERMINFO", description, 1);
  return load_from_system(name);
}

bool utf8_locale() {
  const locale_t locale = newlocale(LC_CTYPE_MASK, "", nullptr);
  if (locale == nullptr) return false;
  const bool utf8 = std::strcmp(nl_langinfo_l(CODESET, locale), "UTF-8") == 0;
  freelocale(locale);
  return utf8;
}

Colors colors_of(const std::string& name) {
  static constexpr char kColors[] = "colors";
  const int count = tigetnum(const_cast<char*>(kColors));
  if (count < 8) return Colors::none;
  const std::string told = environment("COLORTERM");
  const bool direct = name.ends_with("-direct") || told == "truecolor" || told == "24bit";
  if (direct && name != "linux") return Colors::true_color;
  return count >= 256 ? Colors::many : Colors::sixteen;
}

}  // namespace

TerminalInfo load_terminal_info() {
  TerminalInfo info;
  info.name = environment("TERM");
  if (info.name.empty()) {
    info.problem = "TERM is not set";
    return info;
  }
  if (!load(info.name)) {
    if (!load(kFallback)) {
      info.problem = "TERM=" + info.name + " is not a terminal known here";
      return info;
    }
    info.remark = "TERM=" + info.name + " is not known here: treated as " + kFallback;
    info.name = kFallback;
  }
  const std::string moves = capability("cup");
  if (moves.empty()) {
    info.problem = "TERM=" + info.name + " cannot move its cursor";
  } else if (!moves.starts_with(kMovesAsAnsi)) {
    info.problem = "TERM=" + info.name + " does not take ANSI escape sequences";
  }
  info.colors = colors_of(info.name);
  info.unicode = utf8_locale();
  return info;
}

std::string capability(const char* name) {
  const char* const value = tigetstr(const_cast<char*>(name));
  // (char*)-1 for what is no string capability, and null for what is absent.
  // NOLINTNEXTLINE(performance-no-int-to-ptr)
  if (value == nullptr || value == reinterpret_cast<const char*>(-1)) return {};
  std::string text = value;
  for (auto begin = text.find("$<"); begin != std::string::npos; begin = text.find("$<")) {
    const auto end = text.find('>', begin);
    text.erase(begin, end == std::string::npos ? end : end - begin + 1);
  }
  return text;
}

bool has_window(const std::string& term) {
  for (const std::string_view without : {"linux", "vt", "ansi", "cons", "sun"}) {
    if (term.starts_with(without)) return false;
  }
  return true;
}

}  // namespace carom
