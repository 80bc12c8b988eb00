#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "carom/scene_file.hpp"
#include "json/writer.hpp"
#include "scene/table.hpp"

namespace carom {

namespace {

using json::Writer;
using scene::Form;
using scene::Key;
using scene::Limit;
using scene::Table;

constexpr auto kOnLines = Writer::Layout::lines;

/// Writes the JSON Schema of scenes: a definition for each table of keys, in the tables' words.
class SchemaWriter {
 public:
  explicit SchemaWriter(const TextSink& sink) : writer_(sink) {}

  void write() {
    writer_.begin_object(kOnLines);
    writer_.put("$schema", "http://json-schema.org/draft-07/schema#");
    writer_.put("title", "A scene of carom");
    put_object<Scene>();
    writer_.key("definitions").begin_object(kOnLines);
    define<Box>("box");
    define<Effects>("effects");
    define<Ball>("ball");
    define<Fill>("fill");
    define<SolverChoice>("solver");
    define_script();
    define<SavedFlight>("flight");
    define<Continuation>("continuation");
    writer_.end_object().end_object().finish();
  }

 private:
  template <class Object>
  void define(std::string_view name) {
    writer_.key(name).begin_object(kOnLines);
    put_object<Object>();
    writer_.end_object();
  }

  /// The members of the schema of an object.
  template <class Object>
  void put_object() {
    writer_.put("type", "object");
    if (!Table<Object>::kAbout.empty()) writer_.put("description", Table<Object>::kAbout);
    writer_.put("additionalProperties", false);
    if (!partial_) put_required<Object>();
    writer_.key("properties").begin_object(kOnLines);
    scene::for_each_key<Object>([&](const auto& key) {
      writer_.key(key.name).begin_object();
      put_type(key);
      put_default(key);
      if (!key.about.empty()) writer_.put("description", key.about);
      writer_.end_object();
    });
    writer_.end_object();
  }

  template <class Object>
  void put_required() {
    bool any = false;
    scene::for_each_key<Object>([&](const auto& key) { any = any || key.is_required(); });
    if (!any) return;
    writer_.key("required").begin_list();
    scene::for_each_key<Object>([&](const auto& key) {
      if (key.is_required()) writer_.value(key.name);
    });
    writer_.end_list();
  }

  template <class Object, class Member, Form kForm>
  void put_type(const Key<Object, Member, kForm>& key) {
    if constexpr (kForm == Form::workers) {
      writer_.key("anyOf").begin_list();
      writer_.begin_object().put("const", kPerBall).end_object();
      writer_.begin_object().put("type", "integer").put("minimum", 1);
      writer_.put("maximum", key.most).end_object().end_list();
    } else if constexpr (kForm == Form::digits) {
      writer_.key("enum").begin_list();
      for (const int digits : kDigits) writer_.value(digits);
      writer_.end_list();
    } else if constexpr (kForm == Form::decimal) {
      put_decimal(Member{});
    } else if constexpr (kForm == Form::script) {
      writer_.put("type", "array").key("items").begin_object();
      writer_.put("$ref", "#/definitions/script_line").end_object();
    } else if constexpr (std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool> &&
                         !std::is_same_v<Member, char>) {
      put_number(Member{}, key);
    } else {
      put(Member{});
      if constexpr (std::is_same_v<Member, std::optional<double>>) put_limit(key.limit);
    }
  }

  template <class Number, class Key>
  void put_number(Number, const Key& key) {
    if constexpr (std::is_floating_point_v<Number>) {
      put(Number{});
      put_limit(key.limit);
    } else {
      put(Number{});
      if (key.most > 0) {
        writer_.put("maximum", key.most);
      } else if (key.name == "seed") {
        writer_.put("maximum", std::numeric_limits<std::uint64_t>::max());
      }
    }
  }
  void put_limit(Limit limit) {
    if (limit == Limit::positive || limit == Limit::power_of_two)
      writer_.put("exclusiveMinimum", 0);
    if (limit == Limit::not_negative) writer_.put("minimum", 0);
    if (limit == Limit::fraction) writer_.put("minimum", 0).put("maximum", 1);
  }

  // The types of values, by examples.

  void put(double) { writer_.put("type", "number"); }
  void put(bool) { writer_.put("type", "boolean"); }
  void put(const std::string&) { writer_.put("type", "string"); }
  void put(char) { writer_.put("type", "string").put("pattern", "^[!-~]$"); }
  template <std::unsigned_integral Whole>
  requires(!std::same_as<Whole, bool>) void put(Whole) {
    writer_.put("type", "integer").put("minimum", 0);
  }
  template <class Item>
  void put_two(const Item& item) {
    writer_.put("type", "array").key("items").begin_object();
    put(item);
    writer_.end_object().put("minItems", 2).put("maxItems", 2);
  }
  void put(const Vec2&) { put_two(0.0); }
  void put(const Gravity&) {
    put_two(0.0);
    writer_.put("description", "A uniform acceleration [x, y], as in [0, -9.81].");
  }
  void put(const std::array<Vec2, 2>&) { put_two(Vec2{}); }
  void put(const std::array<bool, 2>&) {
    writer_.put("type", "array").key("items").begin_object().key("enum").begin_list();
    writer_.value("x").value("y").end_list().end_object().put("uniqueItems", true);
    writer_.key("default").begin_list().end_list();
  }
  void put_decimal(const std::string&) {
    writer_.put("type", "string");
    writer_.put("pattern", "^-?[0-9]+([.][0-9]+)?([eE][-+]?[0-9]+)?$").put("maxLength", 200);
  }
  void put_decimal(const std::array<std::string, 2>&) {
    writer_.put("type", "array").key("items").begin_object();
    put_decimal(std::string());
    writer_.end_object().put("minItems", 2).put("maxItems", 2);
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void put(Enum) {
    writer_.key("enum").begin_list();
    for (const auto& name : scene::names_of(Enum{})) writer_.value(name.word);
    writer_.end_list();
  }
  template <class T>
  void put(const std::optional<T>&) {
    put(T{});
  }
  template <class Item>
  void put(const std::vector<Item>&) {
    writer_.put("type", "array").key("items").begin_object();
    put_reference(Item{});
    writer_.end_object();
  }
  template <scene::HasTable Object>
  void put(const Object& object) {
    if constexpr (requires { put_reference(object); }) {
      put_reference(object);
    } else {
      put_object<Object>();
    }
  }
  void put_reference(const Ball&) { refer_to("ball"); }
  void put_reference(const Fill&) { refer_to("fill"); }
  void put_reference(const Box&) { refer_to("box"); }
  void put_reference(const SolverChoice&) { refer_to("solver"); }
  void put_reference(const SavedFlight&) { refer_to("flight"); }
  void put_reference(const Continuation&) { refer_to("continuation"); }
  /// Of a script line: an effect that keeps a value need not name it.
  void put(const Effects&) {
    if (partial_) {
      put_object<Effects>();
    } else {
      refer_to("effects");
    }
  }
  void refer_to(std::string_view name) { writer_.put("$ref", reference_to(name)); }
  static std::string reference_to(std::string_view name) {
    return "#/definitions/" + std::string(name);
  }

  /// Only where a default is a plain value, and where the scene would be the same with it.
  template <class Object, class Member, Form kForm>
  void put_default(const Key<Object, Member, kForm>& key) {
    if (key.is_required() || partial_) return;
    constexpr bool kPlain = kForm != Form::unused && kForm != Form::workers &&
                            kForm != Form::decimal &&
                            (std::is_same_v<Member, double> || std::is_same_v<Member, bool> ||
                             std::is_same_v<Member, int> || std::is_same_v<Member, Vec2> ||
                             std::is_same_v<Member, std::uint64_t> || std::is_enum_v<Member>);
    if constexpr (kPlain) {
      const Object defaults{};
      writer_.key("default");
      put_value(defaults.*key.slot);
    }
  }
  void put_value(double number) { writer_.value(number); }
  void put_value(bool flag) { writer_.value(flag); }
  void put_value(int number) { writer_.value(number); }
  void put_value(std::uint64_t number) { writer_.value(number); }
  void put_value(const Vec2& pair) {
    writer_.begin_list().value(pair.x()).value(pair.y()).end_list();
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void put_value(Enum value) {
    for (const auto& name : scene::names_of(value)) {
      if (name.value == value) writer_.value(name.word);
    }
  }

  // --- the script ---

  void define_script() {
    writer_.key("script_line").begin_object(kOnLines).put("type", "object").key("oneOf");
    writer_.begin_list(kOnLines);
    scene::for_each_line([&](const auto& line) {
      writer_.begin_object();
      refer_to(line.kWord);
      writer_.end_object();
    });
    writer_.end_list().end_object();
    scene::for_each_line([&]<class Line>(const Line& line) {
      word_ = line.kWord;
      writer_.key(line.kWord).begin_object(kOnLines);
      put_line<Line>();
      writer_.end_object();
    });
  }
  template <class Line>
  void put_line() {
    writer_.put("type", "object").put("additionalProperties", false);
    put_required<Line>();
    partial_ = std::is_same_v<Line, scene::SetLine>;
    writer_.key("properties").begin_object(kOnLines);
    scene::for_each_key<Line>([&](const auto& key) {
      writer_.key(key.name).begin_object();
      put_type(key);
      if (!key.about.empty()) writer_.put("description", key.about);
      writer_.end_object();
    });
    writer_.end_object();
    partial_ = false;
  }
  void put(scene::CommandWord) { writer_.put("const", word_); }

  Writer writer_;
  bool partial_ = false;   // a part of an object is enough
  std::string_view word_;  // of the present line
};

}  // namespace

std::string scene_schema() {
  std::string text;
  SchemaWriter([&](std::string_view part) { text += part; }).write();
  return text;
}

}  // namespace carom
