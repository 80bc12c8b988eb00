#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "carom/scene_file.hpp"

namespace carom::scene {

/// A problem and where in the file it was met, so that problems can be told in the file's order.
struct Finding {
  std::size_t ordinal = 0;
  Problem problem;
};

/// One JSON value, with its place in the order of the file.
struct Value {
  enum class Kind { null, flag, whole, real, text, list, object, refused };
  struct Parts {
    std::string text;
    std::vector<Value> items;
    std::vector<std::string> keys;  ///< of an object: the key of each item
  };

  Kind kind = Kind::null;  ///< `refused`: a number that has been complained about already
  bool flag = false;       ///< the value of a flag; of a whole number: it is negative
  std::size_t ordinal = 0;
  double number = 0;             ///< of whole and real numbers
  std::uint64_t magnitude = 0;   ///< of whole numbers
  std::unique_ptr<Parts> parts;  ///< of texts, lists and objects

  [[nodiscard]] bool is_number() const { return kind == Kind::whole || kind == Kind::real; }
  [[nodiscard]] const std::string& text() const { return parts->text; }
  [[nodiscard]] const std::vector<Value>& items() const { return parts->items; }
  [[nodiscard]] const std::vector<std::string>& keys() const { return parts->keys; }
  /// The item of an object with this key; null where it has none or is no object.
  [[nodiscard]] const Value* find(std::string_view key) const;
};

/// A JSON text as a tree.  A key given twice and a number that is not finite are findings, and the
/// tree goes on without them; anything else that is wrong with the text is one finding and no tree.
struct Tree {
  bool complete = false;
  Value root;
  std::vector<Finding> findings;
};

Tree parse_tree(std::string_view text);

/// A key as a step of a JSON pointer (RFC 6901), with what would not print on one line escaped.
std::string pointer_step(std::string_view key);

/// What a message says was got instead: `-1`, `"big"`, `a list`.
std::string describe(const Value& value);

/// A text in quotes on one line, cut where it is long.
std::string in_quotes(std::string_view text);

}  // namespace carom::scene
