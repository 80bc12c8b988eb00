#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "carom/scene_file.hpp"
#include "carom/scene_stream.hpp"
#include "json/writer.hpp"
#include "scene/table.hpp"

namespace carom {

namespace {

using json::Writer;
using scene::Form;
using scene::Key;

/// Whether two values are written the same; -0 is not 0.
template <class T>
bool same(const T& a, const T& b) {
  return a == b;
}
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(const Vec2& a, const Vec2& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y());
}

class SceneWriter {
 public:
  SceneWriter(const SceneStream& more, const TextSink& sink) : more_(more), writer_(sink) {}

  void write(const Scene& scene) {
    writer_.begin_object(Writer::Layout::lines);
    put_members(scene);
    writer_.end_object().finish();
  }

 private:
  template <class Object>
  void put_members(const Object& object) {
    scene::for_each_key<Object>([&](const auto& key) { put_member(object, key); });
  }

  template <class Object, class Member, Form kForm>
  void put_member(const Object& object, const Key<Object, Member, kForm>& key) {
    if constexpr (kForm == Form::unused) {
      return;
    } else if constexpr (kForm == Form::streamed) {
      put_stream(key.name, object.*key.slot);
    } else if constexpr (kForm == Form::workers) {
      if (object.workers) writer_.put(key.name, *object.workers);
      if (object.per_ball) writer_.put(key.name, kPerBall);
    } else {
      if (!key.always_written && is_default(object, key)) return;
      writer_.key(key.name);
      put(object.*key.slot);
    }
  }

  template <class Object, class Key>
  static bool is_default(const Object& object, const Key& key) {
    const auto& value = object.*key.slot;
    if constexpr (requires { value.has_value(); }) {
      return !value.has_value();
    } else if constexpr (requires { value.capacity(); }) {
      return value.empty();
    } else if constexpr (scene::HasTable<std::decay_t<decltype(value)>>) {
      return false;
    } else {
      static const Object kDefaults{};
      return same(value, kDefaults.*key.slot);
    }
  }

  // The values, by their types.

  void put(double number) { writer_.value(number); }
  void put(bool flag) { writer_.value(flag); }
  void put(int number) { writer_.value(number); }
  void put(unsigned number) { writer_.value(number); }
  void put(std::uint64_t number) { writer_.value(number); }
  void put(const std::string& text) { writer_.value(text); }
  void put(char glyph) { writer_.value(std::string_view(&glyph, 1)); }
  void put(const Vec2& pair) { writer_.begin_list().value(pair.x()).value(pair.y()).end_list(); }
  void put(const std::array<bool, 2>& axes) {
    writer_.begin_list();
    if (axes[0]) writer_.value("x");
    if (axes[1]) writer_.value("y");
    writer_.end_list();
  }
  template <class Item>
  void put(const std::array<Item, 2>& items) {
    writer_.begin_list();
    for (const Item& item : items) put(item);
    writer_.end_list();
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void put(Enum value) {
    for (const auto& name : scene::names_of(value)) {
      if (name.value == value) writer_.value(name.word);
    }
  }
  template <class T>
  void put(const std::optional<T>& optional) {
    put(*optional);
  }
  template <class Item>
  void put(const std::vector<Item>& items) {
    writer_.begin_list(Writer::Layout::lines);
    for (const Item& item : items) put(item);
    writer_.end_list();
  }
  void put(const Gravity& gravity) { put(gravity.acceleration); }
  template <scene::HasTable Object>
  void put(const Object& object) {
    writer_.begin_object();
    put_members(object);
    writer_.end_object();
  }

  /// The command of a line is its type.
  template <class Line>
  void put_line(const Line& line) {
    writer_.begin_object();
    scene::for_each_key<Line>([&](const auto& key) {
      if constexpr (std::same_as<std::decay_t<decltype(line.*key.slot)>, scene::CommandWord>) {
        writer_.put(key.name, Line::kWord);
      } else {
        put_member(line, key);
      }
    });
    writer_.end_object();
  }
  void put(const ScriptLine& entry) {
    const double at = entry.at;
    struct Visitor {
      SceneWriter& writer;
      double at;
      void operator()(const command::Add& add) const {
        writer.put_line(scene::AddLine{.at = at, .ball = add.ball});
      }
      void operator()(const command::Remove& remove) const {
        writer.put_line(scene::RemoveLine{.at = at, .ball = remove.ball});
      }
      void operator()(const command::Pause&) const { writer.put_line(scene::PauseLine{.at = at}); }
      void operator()(const command::Resume&) const {
        writer.put_line(scene::ResumeLine{.at = at});
      }
      void operator()(const command::SetEffects& set) const {
        writer.put_line(scene::SetLine{.at = at, .effects = set.effects});
      }
      void operator()(const command::SetStep& set) const {
        writer.put_line(scene::SetLine{.at = at, .solver = scene::NewStep{set.step}});
      }
      void operator()(const command::Quit&) const { writer.put_line(scene::QuitLine{.at = at}); }
    };
    std::visit(Visitor{*this, at}, entry.command);
  }

  /// Nothing is written of an empty list.
  template <class Item, class Each>
  void put_each(std::string_view name, const std::vector<Item>& items, const Each& each) {
    bool begun = false;
    const auto put_item = [&](const Item& item) {
      if (!begun) writer_.key(name).begin_list(Writer::Layout::lines);
      begun = true;
      put(item);
    };
    for (const Item& item : items) put_item(item);
    if (each) each(put_item);
    if (begun) writer_.end_list();
  }
  void put_stream(std::string_view name, const std::vector<Ball>& balls) {
    put_each(name, balls, more_.each_ball);
  }
  void put_stream(std::string_view name, const std::vector<SavedFlight>& flights) {
    put_each(name, flights, more_.each_flight);
  }

  const SceneStream& more_;  // than is in the scene
  Writer writer_;
};

}  // namespace

Scene SceneStream::collect() const {
  Scene scene = head;
  if (each_ball) each_ball([&](const Ball& ball) { scene.balls.push_back(ball); });
  if (each_flight && scene.continuation) {
    each_flight([&](const SavedFlight& flight) { scene.continuation->flights.push_back(flight); });
  }
  return scene;
}

void write_scene(const SceneStream& scene, const TextSink& sink) {
  SceneWriter(scene, sink).write(scene.head);
}

std::string write_scene(const Scene& scene) {
  std::string text;
  const SceneStream no_more;
  SceneWriter(no_more, [&](std::string_view part) { text += part; }).write(scene);
  return text;
}

}  // namespace carom
