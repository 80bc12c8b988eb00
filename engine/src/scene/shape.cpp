#include "scene/shape.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "carom/names.hpp"
#include "scene/keys.hpp"
#include "scene/text_check.hpp"

namespace carom::scene {

namespace {

constexpr double kLargestExact = 0x1p53;  // whole numbers written as 2e2 are taken up to here

std::string_view nearest_key(std::string_view unknown, const Group& group) {
  std::vector<std::string_view> names;
  for (const Key& key : group.keys) names.push_back(key.name);
  return nearest_word(unknown, names);
}

/// As JSON writes numbers, with at most as many digits as any scalar has, and no absurd exponent.
bool is_decimal(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return text.size() <= kLongest && error == std::errc() && stop == end && std::isfinite(value);
}

class Shape {
 public:
  enum class Missing { everywhere, at_the_top, nowhere };  // what is missed where it is required

  void check_object(const Value& value, const std::string& place, const Group& group,
                    Missing missing) {
    if (value.kind != Value::Kind::object) {
      return wrong(value, place,
                   place.empty() ? R"(must be a JSON object, as in {"box": ...})"
                                 : "must be an object in { }");
    }
    for (std::size_t i = 0; i < value.items().size(); ++i) {
      const std::string& name = value.keys()[i];
      const auto key = std::find_if(group.keys.begin(), group.keys.end(),
                                    [&](const Key& known) { return known.name == name; });
      const std::string at = place + "/" + pointer_step(name);
      if (key == group.keys.end()) {
        add(value.items()[i], at,
            fmt::format("is not a key of {}, the nearest known one is \"{}\"", group.name,
                        nearest_key(name, group)));
      } else {
        check(value.items()[i], at, *key,
              missing == Missing::everywhere ? missing : Missing::nowhere);
      }
    }
    if (missing == Missing::nowhere) return;
    for (const Key& key : group.keys) {
      if (key.required && value.find(key.name) == nullptr) {
        add(value, fmt::format("{}/{}", place, key.name),
            fmt::format("is missing: {} needs it, as in \"{}\": {}", group.name, key.name,
                        key.example));
      }
    }
  }

  std::vector<Finding> take() { return std::move(findings_); }

 private:
  void add(const Value& value, const std::string& place, std::string message) {
    findings_.push_back({value.ordinal, {place, std::move(message)}});
  }

  void wrong(const Value& value, const std::string& place, std::string_view demand) {
    if (value.kind == Value::Kind::refused) return;  // it has its own finding
    add(value, place, fmt::format("{}, got {}", demand, describe(value)));
  }

  void check(const Value& value, const std::string& place, const Key& key, Missing missing) {
    switch (key.type) {
      case Type::text:
        if (value.kind != Value::Kind::text) wrong(value, place, "must be a text in quotes");
        return;
      case Type::line_of_text:
        if (value.kind != Value::Kind::text) return wrong(value, place, "must be a text in quotes");
        if (printable(value.text()) != value.text()) {
          wrong(value, place, "must be one line of text without control characters");
        }
        return;
      case Type::glyph:
        return check_glyph(value, place);
      case Type::flag:
        if (value.kind != Value::Kind::flag) wrong(value, place, "must be true or false");
        return;
      case Type::number:
        if (!value.is_number()) wrong(value, place, "must be a number");
        return;
      case Type::whole:
        return check_whole(value, place, "must be a whole number from 0 on");
      case Type::pair:
        return check_pair(value, place);
      case Type::decimal:
        return check_decimal(value, place);
      case Type::decimal_pair:
        return check_decimal_pair(value, place);
      case Type::corners:
        return check_corners(value, place);
      case Type::axes:
        return check_axes(value, place);
      case Type::choice:
        return check_choice(value, place, key.words);
      case Type::workers:
        if (value.kind == Value::Kind::text && value.text() == "per-ball") return;
        return check_whole(value, place, "must be \"per-ball\" or a whole number from 1 on");
      case Type::object:
        return check_object(value, place, *key.group, missing);
      case Type::list:
        return check_list(value, place, *key.group);
    }
  }

  void check_glyph(const Value& value, const std::string& place) {
    const bool good = value.kind == Value::Kind::text && value.text().size() == 1 &&
                      value.text()[0] > ' ' && value.text()[0] <= '~';
    if (!good) wrong(value, place, "must be one printable ASCII character in quotes, as in \"8\"");
  }

  void check_whole(const Value& value, const std::string& place, std::string_view demand) {
    const bool whole = (value.kind == Value::Kind::whole && !value.flag) ||
                       (value.kind == Value::Kind::real && value.number >= 0 &&
                        value.number <= kLargestExact && std::trunc(value.number) == value.number);
    if (!whole) wrong(value, place, demand);
  }

  void check_pair(const Value& value, const std::string& place) {
    if (value.kind != Value::Kind::list || value.items().size() != 2) {
      return wrong(value, place, "must be two numbers, [x, y]");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (!value.items()[i].is_number()) {
        wrong(value.items()[i], fmt::format("{}/{}", place, i), "must be a number");
      }
    }
  }

  void check_decimal(const Value& value, const std::string& place) {
    if (value.kind != Value::Kind::text || !is_decimal(value.text())) {
      wrong(value, place, "must be a decimal number in quotes");
    }
  }

  void check_decimal_pair(const Value& value, const std::string& place) {
    if (value.kind != Value::Kind::list || value.items().size() != 2) {
      return wrong(value, place, R"(must be two decimal numbers in quotes, ["x", "y"])");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      check_decimal(value.items()[i], fmt::format("{}/{}", place, i));
    }
  }

  void check_corners(const Value& value, const std::string& place) {
    if (value.kind != Value::Kind::list || value.items().size() != 2) {
      return wrong(value, place, "must be two corners, [[left, bottom], [right, top]]");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      check_pair(value.items()[i], fmt::format("{}/{}", place, i));
    }
  }

  void check_axes(const Value& value, const std::string& place) {
    if (value.kind != Value::Kind::list) {
      return wrong(value, place, R"(must be a list of "x" and "y", as in ["x"])");
    }
    std::vector<std::string_view> seen;
    for (std::size_t i = 0; i < value.items().size(); ++i) {
      const Value& item = value.items()[i];
      const std::string at = fmt::format("{}/{}", place, i);
      if (item.kind != Value::Kind::text || (item.text() != "x" && item.text() != "y")) {
        wrong(item, at, R"(must be "x" or "y")");
      } else if (std::find(seen.begin(), seen.end(), item.text()) != seen.end()) {
        add(item, at, fmt::format("names \"{}\" a second time", item.text()));
      } else {
        seen.push_back(item.text());
      }
    }
  }

  void check_choice(const Value& value, const std::string& place,
                    std::span<const std::string_view> words) {
    const bool known = value.kind == Value::Kind::text &&
                       std::find(words.begin(), words.end(), value.text()) != words.end();
    if (known) return;
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string_view join = i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
      list += fmt::format("{}\"{}\"", join, words[i]);
    }
    wrong(value, place, "must be " + list);
  }

  void check_list(const Value& value, const std::string& place, const Group& group) {
    if (value.kind != Value::Kind::list) return wrong(value, place, "must be a list in [ ]");
    for (std::size_t i = 0; i < value.items().size(); ++i) {
      const Value& item = value.items()[i];
      const std::string at = fmt::format("{}/{}", place, i);
      if (&group == &kScriptLine) {
        check_script_line(item, at);
      } else {
        check_object(item, at, group, Missing::everywhere);
      }
    }
  }

  void check_script_line(const Value& value, const std::string& place) {
    const Value* command = value.find("command");
    if (command != nullptr && command->kind == Value::Kind::text) {
      const Group& group = script_line_group(command->text());
      if (&group != &kScriptLine) {
        if (command->text() != "set") {
          return check_object(value, place, group, Missing::everywhere);
        }
        if (value.find("effects") == nullptr && value.find("solver") == nullptr) {
          add(value, place, R"(sets nothing, it needs "effects" or "solver")");
        }
        // What a line sets is a part: it needs no key of an effect that keeps its value.
        return check_object(value, place, group, Missing::at_the_top);
      }
    }
    if (value.kind != Value::Kind::object) {
      return check_object(value, place, kScriptLine, Missing::everywhere);
    }
    for (const Key& key : kScriptLine.keys) {
      const Value* item = value.find(key.name);
      if (item != nullptr) {
        check(*item, fmt::format("{}/{}", place, key.name), key, Missing::everywhere);
      } else {
        add(value, fmt::format("{}/{}", place, key.name),
            fmt::format("is missing: a script line needs it, as in \"{}\": {}", key.name,
                        key.example));
      }
    }
  }

  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> find_shape_problems(const Value& root) {
  Shape shape;
  shape.check_object(root, "", kScene, Shape::Missing::everywhere);
  return shape.take();
}

}  // namespace carom::scene
