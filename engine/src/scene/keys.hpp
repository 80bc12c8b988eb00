#pragma once

#include <span>
#include <string_view>

namespace carom::scene {

/// What a key's value has to be.
enum class Type {
  text,
  line_of_text,  ///< text without control characters
  glyph,         ///< one printable ASCII character
  flag,
  number,
  whole,         ///< a whole number from 0 on
  pair,          ///< [x, y]
  decimal,       ///< a text that holds a decimal number, of any length
  decimal_pair,  ///< [x, y] of such texts
  corners,       ///< [[x, y], [x, y]]
  axes,          ///< a list of "x" and "y"
  choice,        ///< one of some words
  workers,       ///< "per-ball" or a whole number
  object,
  list,  ///< of objects
};

struct Group;

/// A key that a scene can have.
struct Key {
  std::string_view name;
  Type type;
  bool required = false;
  const Group* group = nullptr;                  ///< of objects and lists: what they hold
  std::span<const std::string_view> words = {};  ///< of a choice
  std::string_view example = {};                 ///< of what is required: how it is written
};

/// The keys of one kind of object: the whole list, all others are refused.
struct Group {
  std::string_view name;  ///< as in "a ball"
  std::span<const Key> keys;
};

extern const Group kScene;

/// The keys of a script line depend on its command; the generic group where that is not known.
const Group& script_line_group(std::string_view command);
extern const Group kScriptLine;

}  // namespace carom::scene
