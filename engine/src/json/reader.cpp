#include "json/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "json/pointer.hpp"
#include "json/scalar.hpp"
#include "json/text.hpp"

namespace carom::json {

namespace {

constexpr std::size_t kDeepest = 64;  // containers within containers

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}
bool part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
}

bool means_not_finite(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

}  // namespace

void Reader::skip_space() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

std::string_view Reader::word_at(std::size_t begin) const {
  std::size_t end = begin;
  while (end < text_.size() && part_of_word(text_[end])) ++end;
  return text_.substr(begin, end - begin);
}

bool Reader::is_not_finite() const {
  return means_not_finite(word_at(at_));
}

Kind Reader::peek() {
  skip_space();
  switch (next()) {
    case '{':
      return Kind::object;
    case '[':
      return Kind::list;
    case '"':
      return Kind::text;
    case 't':
      expect_word("true");
      return Kind::flag;
    case 'f':
      expect_word("false");
      return Kind::flag;
    case 'n':
      if (is_not_finite()) return Kind::not_finite;
      expect_word("null");
      return Kind::null;
    case '-':
      if (at_ + 1 < text_.size() && !is_digit(text_[at_ + 1]) && is_not_finite()) {
        return Kind::not_finite;
      }
      break;
    default:
      if (!is_digit(next())) {
        if (is_not_finite()) return Kind::not_finite;
        unexpected("a value");
      }
  }
  return Kind::number;
}

void Reader::expect_word(std::string_view word) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (at_ + i < text_.size() && text_[at_ + i] == word[i]) continue;
    malformed(at_ + i, fmt::format("expected {}, got {}", word, in_quotes(word_at(at_))));
  }
}

Number Reader::number() {
  skip_space();
  const std::size_t begin = at_;
  Number number = scan_number(text_, at_);
  if (!std::isfinite(number.value)) {
    complain_of_number(begin, text_.substr(begin, at_ - begin),
                       " within the range of double precision");
    number.value = std::numeric_limits<double>::quiet_NaN();
  }
  return number;
}

bool Reader::flag() {
  skip_space();
  const bool is_true = next() == 't';
  at_ += is_true ? 4 : 5;
  return is_true;
}

void Reader::not_finite() {
  skip_space();
  const std::string_view word = word_at(at_);
  complain_of_number(at_, word, "");
  at_ += word.size();
}

void Reader::complain_of_number(std::size_t begin, std::string_view word, std::string_view within) {
  complaints_.push_back({begin, pointer(),
                         fmt::format("must be a finite number{}, got {} ({})", within, word,
                                     line_and_column(text_, begin))});
}

// Goes to the closing quote; gives the place after it.
std::size_t Reader::scan_text(bool& escaped) {
  escaped = false;
  for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
    const char c = text_[i];
    if (c == '"') return i + 1;
    if (c == '\\') {
      escaped = true;
      ++i;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      malformed(i, fmt::format("a control character in a text must be escaped, as \\u{:04x}",
                               static_cast<unsigned char>(c)));
    }
  }
  throw Malformed{text_.size(), "",
                  "is not complete JSON: the file ends inside a text, it may be cut short"};
}

// Whether it is written with escapes; only then `meant` is set.
bool Reader::take_text(std::string_view& written, std::string& meant) {
  skip_space();
  bool escaped = false;
  const std::size_t begin = at_ + 1;
  const std::size_t end = scan_text(escaped);
  written = text_.substr(begin, end - 1 - begin);
  if (escaped) meant = unescaped(written, begin);
  at_ = end;
  return escaped;
}

std::string Reader::text() {
  std::string_view written;
  std::string meant;
  return take_text(written, meant) ? meant : std::string(written);
}

void Reader::begin(bool list) {
  skip_space();
  if (path_.size() >= kDeepest) {
    throw Malformed{at_, pointer(),
                    fmt::format("is nested deeper than {} lists and objects", kDeepest)};
  }
  ++at_;
  path_.emplace_back();
  path_.back().list = list;
}

bool Reader::next_member() {
  skip_space();
  if (path_.back().first) {
    if (next() == '}') {
      ++at_;
      path_.pop_back();
      return false;
    }
    if (next() != '"') unexpected("a key in quotes or '}'");
  } else {
    if (next() == '}') {
      ++at_;
      path_.pop_back();
      return false;
    }
    if (next() != ',') unexpected("',' or '}' after a member");
    ++at_;
    skip_space();
    if (next() != '"') unexpected("a key in quotes after ','");
  }
  Step& step = path_.back();
  step.escaped = take_text(step.key, step.decoded);
  step.first = false;
  skip_space();
  if (next() != ':') unexpected("':' after a key");
  ++at_;
  return true;
}

bool Reader::next_item() {
  Step& step = path_.back();
  skip_space();
  if (next() == ']') {
    ++at_;
    path_.pop_back();
    return false;
  }
  if (step.first) {
    step.first = false;
    return true;
  }
  if (next() != ',') unexpected("',' or ']' after an item");
  ++at_;
  ++step.index;
  return true;
}

void Reader::skip() {
  switch (peek()) {
    case Kind::null:
      return null();
    case Kind::flag:
      (void)flag();
      return;
    case Kind::number:
      (void)number();
      return;
    case Kind::text:
      (void)text();
      return;
    case Kind::not_finite:
      return not_finite();
    case Kind::list:
      begin_list();
      while (next_item()) skip();
      return;
    case Kind::object:
      break;
  }
  begin_object();
  std::vector<std::string> keys;
  while (next_member()) {
    if (std::find(keys.begin(), keys.end(), key()) != keys.end()) {
      complain_of_second(offset());
    } else {
      keys.emplace_back(key());
    }
    skip();
  }
}

std::string Reader::describe_and_skip() {
  switch (peek()) {
    case Kind::null:
      null();
      return "null";
    case Kind::flag:
      return flag() ? "true" : "false";
    case Kind::number: {
      const Number taken = number();
      if (std::isnan(taken.value)) return "no number";
      if (!taken.is_whole) return fmt::format("{}", taken.value);
      return fmt::format("{}{}", taken.is_negative ? "-" : "", taken.magnitude);
    }
    case Kind::text:
      return in_quotes(text());
    case Kind::list: {
      begin_list();
      std::size_t items = 0;
      for (; next_item(); ++items) skip();
      return items == 0 ? "an empty list" : "a list";
    }
    case Kind::object: {
      const std::size_t begin = at_;
      skip();
      const std::size_t inside = text_.find_first_not_of(" \t\r\n", begin + 1);
      return text_[inside] == '}' ? "an empty object" : "an object";
    }
    case Kind::not_finite:
      not_finite();
      break;
  }
  return "no number";
}

void Reader::end() {
  skip_space();
  if (!ended()) unexpected("the end of the file");
}

std::string Reader::pointer() const {
  std::string place;
  for (const Step& step : path_) {
    if (step.list) {
      place += fmt::format("/{}", step.index);
    } else if (!step.first) {
      place += '/';
      place += pointer_step(step.name());
    }
  }
  return place;
}

void Reader::complain_of_second(std::size_t offset) {
  complaints_.push_back({offset, pointer(), "is given more than once, keep one of them"});
}

// The place of a message is where what was found ends.
void Reader::unexpected(std::string_view expected) {
  if (ended() && !path_.empty()) {
    throw Malformed{
        text_.size(), "",
        fmt::format("is not complete JSON: the file ends inside {}, it may be cut short",
                    path_.back().list ? "a list" : "an object")};
  }
  const std::size_t begin = at_;
  std::string found = "the end of the file";
  if (next() == '"') {
    bool escaped = false;
    const std::size_t end = scan_text(escaped);
    malformed(end - 1, fmt::format("expected {}, got the text {}", expected,
                                   in_quotes(text_.substr(begin + 1, end - begin - 2))));
  }
  for (const std::string_view known : {"true", "false", "null"}) {
    if (next() != known[0]) continue;
    expect_word(known);
    malformed(begin + known.size() - 1, fmt::format("expected {}, got {}", expected, known));
  }
  const std::string_view word = word_at(begin);
  if (!ended() && (is_digit(next()) || next() == '-')) {
    (void)scan_number(text_, at_);
    malformed(at_ - 1, fmt::format("expected {}, got the number {}", expected,
                                   text_.substr(begin, at_ - begin)));
  }
  if (!word.empty()) {
    found = in_quotes(word);
  } else if (!ended()) {
    found = fmt::format("'{}'", printable(first_character(text_.substr(begin))));
  }
  malformed(begin, fmt::format("expected {}, got {}", expected, found));
}

}  // namespace carom::json
