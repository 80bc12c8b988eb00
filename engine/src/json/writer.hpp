#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/text_sink.hpp"

namespace carom::json {

/// Writes JSON value by value, so that no document is ever in memory as a whole.
///
/// Holds: a double is written as the shortest decimal that is read back to the same bits, -0 with
/// its sign; what is not finite is null.
class Writer {
 public:
  /// How the members of a list or an object stand: each on a line of its own, or all on one.
  enum class Layout { lines, one_line };

  explicit Writer(TextSink sink) : sink_(std::move(sink)) {}

  Writer& begin_object(Layout layout = Layout::one_line) { return begin('{', layout); }
  Writer& end_object() { return end('}'); }
  Writer& begin_list(Layout layout = Layout::one_line) { return begin('[', layout); }
  Writer& end_list() { return end(']'); }
  /// REQUIRES: an object is open; its value comes next.
  Writer& key(std::string_view name);

  Writer& value(double number);
  Writer& value(bool flag) { return word(flag ? "true" : "false"); }
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool> && !std::same_as<Whole, char>) Writer& value(Whole number) {
    if constexpr (std::signed_integral<Whole>) return whole(static_cast<std::int64_t>(number));
    return whole(static_cast<std::uint64_t>(number));
  }
  Writer& value(std::string_view text);
  Writer& value(const std::string& text) { return value(std::string_view(text)); }
  Writer& value(const char* text) { return value(std::string_view(text)); }
  template <class T>
  Writer& value(const std::optional<T>& optional) {
    return optional ? value(*optional) : null();
  }
  Writer& null() { return word("null"); }

  /// A member of the open object.
  template <class T>
  Writer& put(std::string_view name, const T& content) {
    return key(name).value(content);
  }

  /// Ends the text with a line feed and hands over what is left of it.
  /// REQUIRES: all that was begun has been ended.
  void finish();

 private:
  struct Level {
    Layout layout;
    bool empty = true;
  };

  Writer& begin(char bracket, Layout layout);
  Writer& end(char bracket);
  Writer& whole(std::int64_t number);
  Writer& whole(std::uint64_t number);
  Writer& word(std::string_view word);
  void before_item();
  void before_value();
  void new_line();
  void flush();

  TextSink sink_;
  std::string buffer_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace carom::json
