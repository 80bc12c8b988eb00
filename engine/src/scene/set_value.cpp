#include "scene/set_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <vector>

#include "carom/scene_file.hpp"
#include "json/pointer.hpp"
#include "json/text.hpp"
#include "json/well_formed.hpp"

namespace carom::scene {

namespace {

/// Walks over a well-formed JSON text.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) { skip_space(); }

  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  /// Passes one character and the space after it.
  void pass() {
    ++at_;
    skip_space();
  }

  /// Passes a value, and the space after it; gives the end of the value.
  std::size_t skip_value() {
    std::size_t depth = 0;
    std::size_t end = at_;
    do {
      const char c = peek();
      if (c == '"') {
        skip_text();
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at_;
      } else if (c == '}' || c == ']') {
        --depth;
        ++at_;
      } else if (c == ',' || c == ':') {
        ++at_;
      } else {
        at_ = std::min(text_.find_first_of(",:]} \t\r\n", at_), text_.size());
      }
      end = at_;
      skip_space();
    } while (depth > 0 && at_ < text_.size());
    return end;
  }

  /// Passes a text and the space after it; gives it as written, with its quotes.
  std::string_view take_text() {
    const std::size_t begin = at_;
    skip_text();
    const std::string_view taken = text_.substr(begin, at_ - begin);
    skip_space();
    return taken;
  }

 private:
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  void skip_text() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    at_ = std::min(at_ + 1, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The steps of a JSON pointer (RFC 6901).
std::vector<std::string> steps_of(std::string_view pointer) {
  std::vector<std::string> steps;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::string_view step = pointer.substr(0, std::min(pointer.find('/'), pointer.size()));
    pointer.remove_prefix(step.size());
    std::string plain;
    for (std::size_t i = 0; i < step.size(); ++i) {
      const bool escaped =
          step[i] == '~' && i + 1 < step.size() && (step[i + 1] == '0' || step[i + 1] == '1');
      plain += escaped ? (step[++i] == '0' ? '~' : '/') : step[i];
    }
    steps.push_back(std::move(plain));
  }
  return steps;
}

std::string key_text(std::string_view key) {
  std::string text = "\"";
  for (const char c : key) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

/// A value within the objects and lists that are not there yet.
std::string nested(const std::vector<std::string>& steps, std::size_t from, std::string value) {
  for (std::size_t i = steps.size(); i > from; --i) {
    const std::string& step = steps[i - 1];
    const bool in_list = step == "0" || step == "-";
    value = in_list ? fmt::format("[{}]", value) : fmt::format("{{{}: {}}}", key_text(step), value);
  }
  return value;
}

class Setter {
 public:
  Setter(std::string_view text, const SceneChange& change)
      : text_(text), change_(change), cursor_(text), steps_(steps_of(change.pointer)) {}

  std::string result() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const char open = cursor_.peek();
      if (open == '{') {
        if (!enter_object(steps_[i]))
          return insert(
              fmt::format("{}: {}", key_text(steps_[i]), nested(steps_, i + 1, change_.value)));
      } else if (open == '[') {
        if (!enter_list(steps_[i], i)) return insert(nested(steps_, i + 1, change_.value));
      } else {
        fail(i, "is neither an object nor a list");
      }
    }
    const std::size_t begin = cursor_.at();
    const std::size_t end = cursor_.skip_value();
    return fmt::format("{}{}{}", text_.substr(0, begin), change_.value, text_.substr(end));
  }

 private:
  /// Goes to the member's value, or to the end of the object.
  bool enter_object(const std::string& key) {
    cursor_.pass();
    empty_ = cursor_.peek() == '}';
    while (cursor_.peek() == '"') {
      const std::string name = json::meaning_of(cursor_.take_text());
      cursor_.pass();  // the colon
      if (name == key) return true;
      cursor_.skip_value();
      if (cursor_.peek() == ',') cursor_.pass();
    }
    return false;
  }

  bool enter_list(const std::string& step, std::size_t depth) {
    std::size_t index = 0;
    const char* const last = step.data() + step.size();
    const auto [stopped, error] = std::from_chars(step.data(), last, index);
    const bool append = step == "-";
    if (!append && (error != std::errc{} || stopped != last || step.empty())) {
      fail(depth,
           fmt::format("is a list: after it an index is needed, got {}", json::in_quotes(step)));
    }
    cursor_.pass();
    empty_ = cursor_.peek() == ']';
    std::size_t count = 0;
    for (; cursor_.peek() != ']' && cursor_.peek() != '\0'; ++count) {
      if (!append && count == index) return true;
      cursor_.skip_value();
      if (cursor_.peek() == ',') cursor_.pass();
    }
    if (!append && index != count) {
      fail(depth, fmt::format("is a list: the index must be at most {}, got {}", count, index));
    }
    return false;
  }

  std::string insert(const std::string& item) const {
    return fmt::format("{}{}{}{}", text_.substr(0, cursor_.at()), empty_ ? "" : ", ", item,
                       text_.substr(cursor_.at()));
  }

  [[noreturn]] void fail(std::size_t depth, const std::string& message) const {
    std::string place;
    for (std::size_t i = 0; i < depth; ++i) place += '/' + json::pointer_step(steps_[i]);
    throw SceneError("", {{place, message}});
  }

  std::string_view text_;
  const SceneChange& change_;
  Cursor cursor_;
  std::vector<std::string> steps_;
  bool empty_ = false;  // the container that was entered last
};

}  // namespace

std::string set_value(std::string_view text, const SceneChange& change) {
  return Setter(text, change).result();
}

}  // namespace carom::scene

namespace carom {

SceneChange parse_change(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (!text.starts_with('/') || equals == std::string_view::npos) {
    throw std::invalid_argument("must be /POINTER=VALUE, as in /effects/drag/rate=0.1");
  }
  const std::string_view value = text.substr(equals + 1);
  SceneChange change{std::string(text.substr(0, equals)), std::string(value)};
  const std::string wrong = json::what_is_wrong(value);
  if (!value.empty() && wrong.empty()) return change;
  constexpr std::string_view kBeginsJson = "{[\"-+.0123456789 ";
  if (value.empty() || kBeginsJson.find(value.front()) != std::string_view::npos) {
    throw std::invalid_argument("its value " + (value.empty() ? "is missing" : wrong));
  }
  change.value = fmt::format("\"{}\"", value);
  if (!json::is_well_formed(change.value)) {
    throw std::invalid_argument("its value is neither JSON nor a word");
  }
  return change;
}

}  // namespace carom
