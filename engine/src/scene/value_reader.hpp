#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "carom/names.hpp"
#include "carom/scene.hpp"
#include "json/reader.hpp"
#include "scene/finding.hpp"
#include "scene/table.hpp"

namespace carom::scene {

/// Reads the values of a scene's keys by their types.  One that is not what it must be is a
/// finding, and is passed; in place of a number there is then a NaN.
class ValueReader {
 public:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  explicit ValueReader(std::string_view text, std::size_t begin = 0) : in_(text, begin) {}

  /// All that was found so far.
  std::vector<Finding> take_findings();
  /// Of a text that is malformed: of the rest only what keeps it from being JSON counts.
  std::vector<Finding> take_complaints();

 protected:
  void find(std::size_t offset, std::string place, std::string message);
  /// The next value is not what it must be; passes it.
  void wrong(std::string_view demand);

  void read(double& number);
  void read(bool& flag);
  void read(char& glyph);
  void read(std::string& text) { (void)read_text(text); }
  void read(Vec2& pair);
  void read(Gravity& gravity) { read(gravity.acceleration); }
  void read(std::array<Vec2, 2>& corners);
  void read(std::array<bool, 2>& axes);
  template <std::unsigned_integral Whole>
  requires(!std::same_as<Whole, bool>) void read(Whole& number) {
    constexpr std::uint64_t kMost = std::numeric_limits<Whole>::max();
    const auto read = whole("must be a whole number from 0 on");
    if (read) number = static_cast<Whole>(std::min<std::uint64_t>(*read, kMost));
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void read(Enum& value) {
    const auto known = words(names_of(Enum{}));
    if (const auto number = read_word(known)) value = names_of(Enum{})[*number].value;
  }

  /// A whole number, which may be written as 2e2; nothing where it is none.
  std::optional<std::uint64_t> whole(std::string_view demand);
  /// Passes one of some words; gives its number.
  std::optional<std::size_t> read_word(std::span<const std::string_view> words);
  bool read_text(std::string& text);
  void read_line(std::string& line);
  void read_decimal(std::string& decimal);
  void read_decimal(std::array<std::string, 2>& pair);
  void read_workers(Scene& scene);

  template <class ReadItem>
  void read_list(ReadItem&& read_item) {
    if (in_.peek() != json::Kind::list) return wrong("must be a list in [ ]");
    in_.begin_list();
    while (in_.next_item()) read_item();
  }

  json::Reader in_;

 private:
  /// A list of two items; `read_item` is asked for each.  False: it is none.
  template <class ReadItem>
  bool read_two(std::string_view demand, ReadItem&& read_item);

  std::vector<Finding> findings_;
};

}  // namespace carom::scene
