#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::json {

/// What kind of value comes next.
enum class Kind {
  null,
  flag,
  number,
  text,
  list,
  object,
  not_finite,  ///< NaN or Infinity, which is no JSON; a complaint when it is taken
};

struct Number {
  bool is_whole = false;  ///< without fraction and exponent, and within 64 bits
  bool is_negative = false;
  std::uint64_t magnitude = 0;  ///< of a whole number
  double value = 0;
};

/// Something of a text that is no value, though all that follows can be read; or what is told of
/// it.
struct Complaint {
  std::size_t offset = 0;  ///< of the value in the text
  std::string pointer;     ///< to the value (RFC 6901), printable
  std::string message;
};

/// The text is no JSON from here on.
struct Malformed {
  std::size_t offset = 0;
  std::string pointer;  ///< empty: the offset says where
  std::string message;
};

/// Reads JSON (RFC 8259) value by value, in its order, and keeps nothing of it in memory.
///
///     reader.begin_list();
///     while (reader.next_item()) use(reader.number());
///
/// Holds: knows at any time where it is, as a JSON pointer.  Numbers that are not finite and keys
/// that are given twice are complaints; reading goes on behind them.
/// REQUIRES: UTF-8; the text outlives the reader.
/// Errors: throws Malformed.
class Reader {
 public:
  explicit Reader(std::string_view text, std::size_t begin = 0) : text_(text), at_(begin) {}

  /// The kind of the next value, and where it begins.
  [[nodiscard]] Kind peek();
  [[nodiscard]] std::size_t offset() {
    skip_space();
    return at_;
  }

  // Each takes the next value.
  // REQUIRES: `peek` says that it is of this kind.
  /// One beyond double precision is a complaint, and NaN.
  Number number();
  bool flag();
  void null() { at_ += 4; }
  std::string text();
  void not_finite();
  void begin_object() { begin(false); }
  void begin_list() { begin(true); }

  /// Goes to the next member of the innermost object, of which `key` then tells the name; false:
  /// the object has ended.
  bool next_member();
  /// The name of the present member.
  [[nodiscard]] std::string_view key() const { return path_.back().name(); }
  /// Goes to the next item of the innermost list; false: the list has ended.
  bool next_item();

  /// Passes the next value, of any kind.
  void skip();
  /// Passes the next value, and says what it is in a message: `-1`, `"big"`, `a list`.
  std::string describe_and_skip();
  /// REQUIRES: the last value has been taken; nothing but space may follow it.
  void end();

  /// Of the value that is being read, or comes next.
  [[nodiscard]] std::string pointer() const;
  [[nodiscard]] std::vector<Complaint>& complaints() { return complaints_; }
  /// Tells of a key that is given twice; its value comes next.
  void complain_of_second(std::size_t offset);

 private:
  struct Step {
    bool list = false;
    bool first = true;
    std::size_t index = 0;
    std::string_view key;  // as it is written in the text
    std::string decoded;   // where that is with escapes: what it means
    bool escaped = false;
    [[nodiscard]] std::string_view name() const { return escaped ? decoded : key; }
  };

  void begin(bool list);
  void skip_space();
  [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] bool ended() const { return at_ >= text_.size(); }
  [[nodiscard]] std::string_view word_at(std::size_t begin) const;
  [[nodiscard]] bool is_not_finite() const;
  void complain_of_number(std::size_t begin, std::string_view word, std::string_view within);
  std::size_t scan_text(bool& escaped);
  bool take_text(std::string_view& written, std::string& meant);
  void expect_word(std::string_view word);
  [[noreturn]] void unexpected(std::string_view expected);

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Step> path_;
  std::vector<Complaint> complaints_;
};

}  // namespace carom::json
