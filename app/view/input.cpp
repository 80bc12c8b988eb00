#include "view/input.hpp"

#include <array>
#include <charconv>

namespace carom {
namespace {

constexpr char kEscape = '\x1B';
constexpr char kBell = '\a';
constexpr std::string_view kPasteEnds = "\x1B[201~";
constexpr std::size_t kLongestSequence = 4096;  // longer ones are no sequences

// Buttons of mouse reports: two bits, and flags.
constexpr unsigned kButton = 3;
constexpr unsigned kShift = 4;
constexpr unsigned kMotion = 32;
constexpr unsigned kWheel = 64;
constexpr unsigned kOtherButtons = 128;

bool is_final(char byte) {
  return byte >= 0x40 && byte <= 0x7E;
}

}  // namespace

void Input::feed(std::string_view bytes) {
  bytes_ += bytes;
  while (!bytes_.empty()) {
    const std::size_t used = take_one();
    if (used == 0) return;
    bytes_.erase(0, used);
  }
}

void Input::settle() {
  if (bytes_.empty() || pasting_) return;
  key(bytes_.size() == 1 && bytes_[0] == kEscape ? key::kEscape : key::kOther);
  bytes_.clear();
}

std::optional<Event> Input::next() {
  if (events_.empty()) return std::nullopt;
  const Event event = events_.front();
  events_.pop_front();
  return event;
}

/// The bytes of the first event; 0 where the rest is still to come.
std::size_t Input::take_one() {
  if (pasting_) {
    const auto end = bytes_.find(kPasteEnds);
    if (end == std::string::npos) {
      // What cannot be the beginning of the mark is not needed any more.
      if (bytes_.size() > kPasteEnds.size()) bytes_.erase(0, bytes_.size() - kPasteEnds.size());
      return 0;
    }
    pasting_ = false;
    events_.push_back({Event::Kind::pasted, 0, {}});
    return end + kPasteEnds.size();
  }
  return bytes_[0] == kEscape ? take_escape() : take_character();
}

std::size_t Input::take_escape() {
  if (bytes_.size() == 1) return 0;
  switch (bytes_[1]) {
    case '[':
    case 'O':  // of keys that a keyboard in application mode sends: one character after parameters
      return take_control_sequence(2);
    case ']':
    case 'P':
    case 'X':
    case '^':
    case '_':
      return take_string();
    case kEscape:
      // Escape, then something of its own; or Alt with a key that is a sequence.
      key(key::kEscape);
      return 1;
    default: {
      // Alt with a character, which may be several bytes.
      key(key::kOther);
      const auto byte = static_cast<unsigned char>(bytes_[1]);
      const std::size_t length = byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
      return std::min(bytes_.size(), 1 + length);
    }
  }
}

std::size_t Input::take_control_sequence(std::size_t begin) {
  std::size_t end = begin;
  // The Linux console sends function keys as ESC [ [ A.
  if (bytes_.size() > begin && bytes_[1] == '[' && bytes_[begin] == '[') ++end;
  while (end < bytes_.size() && !is_final(bytes_[end])) {
    const char byte = bytes_[end];
    if (byte < 0x20 || byte > 0x7E || end > kLongestSequence) {
      // No byte of a control sequence: it was cut off.
      key(key::kOther);
      return end;
    }
    ++end;
  }
  if (end == bytes_.size()) return 0;
  const std::string_view parameters = std::string_view(bytes_).substr(begin, end - begin);
  const char last = bytes_[end];
  ++end;
  // The mouse report of old terminals: three bytes follow.
  if (bytes_[1] == '[' && last == 'M' && parameters.empty()) {
    return bytes_.size() < end + 3 ? 0 : end + 3;
  }
  if (!parameters.empty() && parameters[0] == '<') {
    report_mouse(parameters.substr(1), last);
  } else {
    act_on(parameters, last);
  }
  return end;
}

/// Operating system commands and the like, answers to questions that were not asked: up to their
/// end.
std::size_t Input::take_string() {
  const auto end = bytes_.find_first_of("\a\x1B", 2);
  if (end == std::string::npos) {
    if (bytes_.size() <= kLongestSequence) return 0;
    key(key::kOther);
    return bytes_.size();
  }
  if (bytes_[end] == kBell) return end + 1;
  if (end + 1 == bytes_.size()) return 0;
  return bytes_[end + 1] == '\\' ? end + 2 : end;
}

void Input::act_on(std::string_view parameters, char last) {
  if (last == '~' && parameters == "200") {
    pasting_ = true;
    return;
  }
  if (!parameters.empty()) return key(key::kOther);
  switch (last) {
    case 'A':
      return key(key::kUp);
    case 'B':
      return key(key::kDown);
    case 'C':
      return key(key::kRight);
    case 'D':
      return key(key::kLeft);
    default:
      return key(key::kOther);
  }
}

void Input::report_mouse(std::string_view parameters, char last) {
  std::array<int, 3> numbers{};
  const char* at = parameters.data();
  const char* const end = at + parameters.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [stopped, error] = std::from_chars(at, end, numbers[i]);
    const bool ends_right = i == 2 ? stopped == end : stopped != end && *stopped == ';';
    if (error != std::errc{} || !ends_right) return;
    at = stopped + 1;
  }
  if (last != 'M' && last != 'm') return;
  const auto code = static_cast<unsigned>(numbers[0]);
  // With shift the mouse is the terminal's, to select text.
  if ((code & (kOtherButtons | kShift)) != 0) return;
  Mouse mouse;
  mouse.column = numbers[1] - 1;
  mouse.row = numbers[2] - 1;
  mouse.button = static_cast<int>(code & kButton);
  if ((code & kWheel) != 0) {
    if (mouse.button > 1) return;
    mouse.action = mouse.button == 0 ? Mouse::Action::wheel_up : Mouse::Action::wheel_down;
    mouse.button = 0;
  } else if ((code & kMotion) != 0) {
    if (mouse.button == 3) return;  // moved with no button down
    mouse.action = Mouse::Action::drag;
  } else {
    mouse.action = last == 'M' ? Mouse::Action::press : Mouse::Action::release;
  }
  events_.push_back({Event::Kind::mouse, 0, mouse});
}

std::size_t Input::take_character() {
  const auto byte = static_cast<unsigned char>(bytes_[0]);
  if (byte < 0x80) {
    key(byte == '\b' ? key::kBackspace : byte == '\n' ? key::kEnter : byte);
    return 1;
  }
  // A letter beyond ASCII is one key, which has no meaning.
  const std::size_t length = byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
  if (bytes_.size() < length) return 0;
  key(key::kOther);
  return length;
}

}  // namespace carom
