#include "json/writer.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace carom::json {

namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 16;

}  // namespace

Writer& Writer::begin(char bracket, Layout layout) {
  before_value();
  buffer_ += bracket;
  levels_.push_back({layout});
  return *this;
}

Writer& Writer::end(char bracket) {
  const Level level = levels_.back();
  levels_.pop_back();
  if (level.layout == Layout::lines && !level.empty) new_line();
  buffer_ += bracket;
  return *this;
}

Writer& Writer::key(std::string_view name) {
  before_item();
  after_key_ = true;
  value(name);
  buffer_ += ": ";
  after_key_ = true;
  return *this;
}

Writer& Writer::value(double number) {
  if (!std::isfinite(number)) return null();
  before_value();
  const std::size_t begin = buffer_.size();
  fmt::format_to(std::back_inserter(buffer_), FMT_COMPILE("{}"), number);
  if (number == 0 && buffer_.size() == begin + 2) buffer_ += ".0";  // "-0" would be a whole number
  return *this;
}

Writer& Writer::whole(std::int64_t number) {
  before_value();
  fmt::format_to(std::back_inserter(buffer_), FMT_COMPILE("{}"), number);
  return *this;
}

Writer& Writer::whole(std::uint64_t number) {
  before_value();
  fmt::format_to(std::back_inserter(buffer_), FMT_COMPILE("{}"), number);
  return *this;
}

Writer& Writer::value(std::string_view text) {
  before_value();
  buffer_ += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      buffer_ += '\\';
      buffer_ += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(buffer_), "\\u{:04x}", static_cast<unsigned char>(c));
    } else {
      buffer_ += c;
    }
  }
  buffer_ += '"';
  return *this;
}

Writer& Writer::word(std::string_view word) {
  before_value();
  buffer_ += word;
  return *this;
}

void Writer::finish() {
  buffer_ += '\n';
  flush();
}

void Writer::before_item() {
  if (levels_.empty()) return;
  if (buffer_.size() >= kBufferSize) flush();
  Level& level = levels_.back();
  if (!level.empty) buffer_ += level.layout == Layout::lines ? "," : ", ";
  level.empty = false;
  if (level.layout == Layout::lines) new_line();
}

void Writer::before_value() {
  if (after_key_) {
    after_key_ = false;
  } else {
    before_item();
  }
}

void Writer::new_line() {
  buffer_ += '\n';
  buffer_.append(2 * levels_.size(), ' ');
}

void Writer::flush() {
  sink_(buffer_);
  buffer_.clear();
}

}  // namespace carom::json
