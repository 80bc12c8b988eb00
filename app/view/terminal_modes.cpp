#include "view/terminal_modes.hpp"

#include "view/terminal_info.hpp"

namespace carom {
namespace {

// xterm, "Control Sequences": buttons and drags of the mouse, told in the form that has no limits
// (1006); bracketed paste; the title of the window, kept on a stack; synchronized output, ended in
// case it was cut off.
constexpr const char* kMouseOn = "\x1B[?1002h\x1B[?1006h";
constexpr const char* kMouseOff = "\x1B[?1006l\x1B[?1002l";
constexpr const char* kPasteOn = "\x1B[?2004h";
constexpr const char* kPasteOff = "\x1B[?2004l";
constexpr const char* kKeepTitle = "\x1B[22;2t";
constexpr const char* kTitleBack = "\x1B[23;2t";
constexpr const char* kEndSynchronized = "\x1B[?2026l";

}  // namespace

TerminalModes terminal_modes(const std::string& term, bool mouse) {
  const bool windowed = has_window(term);
  TerminalModes modes;
  modes.again = capability("civis") + kPasteOn + (mouse ? kMouseOn : "");
  modes.enter = capability("smcup") + (windowed ? kKeepTitle : "") + modes.again;
  // A string that was cut off ends at the first control character that cancels it.
  modes.leave = std::string("\x18") + kEndSynchronized;
  if (mouse) modes.leave += kMouseOff;
  modes.leave += kPasteOff;
  if (windowed) modes.leave += kTitleBack;
  modes.leave += "\x1B[m" + capability("cnorm");
  const std::string back = capability("rmcup");
  // Without another screen, what was there is gone: the prompt comes below a cleared one.
  modes.leave += back.empty() ? "\x1B[2J\x1B[H" : back;
  return modes;
}

}  // namespace carom
