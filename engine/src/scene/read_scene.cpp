#include "scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <limits>
#include <optional>
#include <type_traits>

#include "json/reader.hpp"
#include "json/text.hpp"
#include "scene/table.hpp"
#include "scene/value_reader.hpp"

namespace carom::scene {

namespace {

using json::Kind;
using json::Reader;

template <class Object>
std::string_view nearest_key(std::string_view unknown) {
  std::vector<std::string_view> names;
  for_each_key<Object>([&](const auto& key) { names.push_back(key.name); });
  return nearest_word(unknown, names);
}

/// Which keys that are required are missed where they are not there.
enum class Missing { everywhere, at_the_top, nowhere };

/// A line of the script whose effects wait until those before it are known.
struct Line {
  ScriptLine entry;
  std::size_t number = 0;
  std::optional<std::size_t> effects;  ///< where in the text
};

/// Reads the objects of a scene by the table of keys, and its script.
class SceneReader : public ValueReader {
 public:
  using ValueReader::ValueReader;

  void read(Scene& scene) {
    read_object(scene, Missing::everywhere);
    in_.end();
  }
  /// What the object names, on top of what `effects` holds already.
  void read_on_top(Effects& effects) { read_object(effects, Missing::nowhere); }

  std::vector<Line>& lines() { return lines_; }

 private:
  // --- objects ---

  template <class Object>
  void read_object(Object& object, Missing missing) {
    if (in_.peek() != Kind::object) {
      forget(object);
      return wrong(std::is_same_v<Object, Scene>
                       ? std::string_view(R"(must be a JSON object, as in {"box": ...})")
                       : std::string_view("must be an object in { }"));
    }
    const std::size_t begin = in_.offset();
    std::bitset<kKeyCount<Object>> seen;
    std::vector<std::string> unknown;
    in_.begin_object();
    while (in_.next_member()) {
      std::size_t number = 0;
      bool known = false;
      for_each_key<Object>([&](const auto& key) {
        if (!known && key.name == in_.key()) {
          known = true;
          if (seen[number]) in_.complain_of_second(in_.offset());
          seen.set(number);
          read_member(object, key, missing == Missing::everywhere ? missing : Missing::nowhere);
        }
        ++number;
      });
      if (!known) read_unknown<Object>(unknown);
    }
    if (missing != Missing::nowhere) find_missing(object, seen, begin);
  }

  template <class Object>
  void read_unknown(std::vector<std::string>& unknown) {
    const std::string name(in_.key());
    const std::size_t offset = in_.offset();
    if (std::find(unknown.begin(), unknown.end(), name) != unknown.end()) {
      in_.complain_of_second(offset);
    }
    unknown.push_back(name);
    // Of a line whose command is not known other keys may be right.
    if constexpr (!std::is_same_v<Object, AnyLine>) {
      find(offset, in_.pointer(),
           fmt::format("is not a key of {}, the nearest known one is \"{}\"", Table<Object>::kName,
                       nearest_key<Object>(name)));
    }
    in_.skip();
  }

  template <class Object>
  void find_missing(Object& object, const std::bitset<kKeyCount<Object>>& seen,
                    std::size_t offset) {
    std::size_t number = 0;
    for_each_key<Object>([&](const auto& key) {
      if (seen[number++] || !key.is_required()) return;
      find(offset, fmt::format("{}/{}", in_.pointer(), key.name),
           fmt::format("is missing: {} needs it, as in \"{}\": {}", Table<Object>::kName, key.name,
                       key.example));
      forget(object.*key.slot);
    });
  }

  /// Numbers that are required and were not there are not known.
  template <class Object>
  void forget(Object& object) {
    if constexpr (std::is_same_v<Object, double>) {
      object = kUnknown;
    } else if constexpr (std::is_same_v<Object, Vec2>) {
      object = {kUnknown, kUnknown};
    } else if constexpr (HasTable<Object>) {
      for_each_key<Object>([&](const auto& key) {
        if (key.is_required()) forget(object.*key.slot);
      });
    }
  }

  template <class Object, class Member, Form kForm>
  void read_member(Object& object, const Key<Object, Member, kForm>& key, Missing missing) {
    if constexpr (kForm == Form::unused) {
      std::string unused;
      read_text(unused);
    } else if constexpr (kForm == Form::line) {
      read_line(object.*key.slot);
    } else if constexpr (kForm == Form::decimal) {
      read_decimal(object.*key.slot);
    } else if constexpr (kForm == Form::digits) {
      constexpr std::uint64_t kEnough = 1'000'000;
      const auto digits = whole("must be a whole number from 0 on");
      if (digits) object.*key.slot = static_cast<int>(std::min(*digits, kEnough));
    } else if constexpr (kForm == Form::workers) {
      read_workers(object);
    } else if constexpr (kForm == Form::script) {
      read_list([&] { read_script_line(); });
    } else {
      read(object.*key.slot, missing);
    }
  }

  void read(CommandWord&, Missing) {
    std::vector<std::string_view> known;
    for_each_line([&](const auto& line) { known.push_back(std::decay_t<decltype(line)>::kWord); });
    (void)read_word(known);
  }

  template <class Item>
  void read(std::vector<Item>& items, Missing) {
    read_list([&] { read_object(items.emplace_back(), Missing::everywhere); });
  }

  template <class Value>
  void read(Value& value, Missing missing) {
    if constexpr (HasTable<Value>) {
      read_object(value, missing);
    } else {
      ValueReader::read(value);
    }
  }
  template <class T>
  void read(std::optional<T>& optional, Missing missing) {
    if constexpr (std::is_same_v<T, std::size_t>) {
      optional = whole("must be a whole number from 0 on");
    } else {
      if (!optional) optional.emplace();
      read(*optional, missing);
    }
  }

  // --- the script ---

  /// The text of a key of the object that comes next; empty where there is none.
  std::string text_ahead(std::string_view key) const {
    Reader ahead = in_;
    std::string text;
    try {
      if (ahead.peek() != Kind::object) return text;
      ahead.begin_object();
      while (ahead.next_member()) {
        if (ahead.key() == key && ahead.peek() == Kind::text && text.empty()) {
          text = ahead.text();
        } else {
          ahead.skip();
        }
      }
    } catch (const json::Malformed&) {
      text.clear();  // the reader itself will meet it
    }
    return text;
  }

  void read_script_line() {
    const std::size_t number = next_line_++;
    const std::string word = text_ahead("command");
    bool known = false;
    for_each_line([&](auto line) {
      if (known || word != line.kWord) return;
      known = true;
      read_known_line(line, number);
    });
    if (known) return;
    AnyLine line;
    read_object(line, Missing::everywhere);
  }

  template <class LineOf>
  void read_known_line(LineOf& line, std::size_t number) {
    read_object(line, Missing::everywhere);
    if constexpr (std::is_same_v<LineOf, AddLine>) {
      add_line(line.at, number, command::Add{line.ball});
    } else if constexpr (std::is_same_v<LineOf, RemoveLine>) {
      add_line(line.at, number, command::Remove{line.ball});
    } else if constexpr (std::is_same_v<LineOf, PauseLine>) {
      add_line(line.at, number, command::Pause{});
    } else if constexpr (std::is_same_v<LineOf, ResumeLine>) {
      add_line(line.at, number, command::Resume{});
    } else {
      add_line(line.at, number, command::Quit{});
    }
  }
  /// What a line sets is a part: it needs no key of an effect that keeps its value.
  void read_known_line(SetLine& line, std::size_t number) {
    const std::size_t begin = in_.offset();
    const std::string place = in_.pointer();
    effects_begin_.reset();
    read_object(line, Missing::at_the_top);
    if (!line.effects && !line.solver) {
      find(begin, place, R"(sets nothing, it needs "effects" or "solver")");
    }
    if (line.effects) {
      lines_.push_back({{line.at, command::SetEffects{}}, number, effects_begin_});
    }
    if (line.solver && line.solver->step) {
      add_line(line.at, number, command::SetStep{*line.solver->step});
    }
  }
  void read(std::optional<Effects>& effects, Missing missing) {
    effects_begin_ = in_.offset();
    effects.emplace();
    read_object(*effects, missing);
  }

  void add_line(double at, std::size_t number, Command command) {
    lines_.push_back({{at, command}, number, std::nullopt});
  }

  std::vector<Line> lines_;
  std::size_t next_line_ = 0;
  std::optional<std::size_t> effects_begin_;  // of the line that sets them
};

/// Sorts the lines by time.  A line that sets effects sets those that it names, to the present ones
/// with its changes.
void take_script(std::string_view text, std::vector<Line> lines, Draft& draft) {
  // A time that is not known sorts to the end, as a NaN has no order of its own.
  const auto key = [](const Line& line) {
    const double at = line.entry.at;
    return at == at ? at : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(lines.begin(), lines.end(),
                   [&](const Line& a, const Line& b) { return key(a) < key(b); });
  Effects effects = draft.scene.effects;
  for (Line& line : lines) {
    if (line.effects) {
      Effects named;
      SceneReader(text, *line.effects).read_on_top(effects);
      SceneReader(text, *line.effects).read_on_top(named);
      for_each_effect([&](const auto& entry) {
        if (named.*entry.slot) named.*entry.slot = effects.*entry.slot;
      });
      std::get<command::SetEffects>(line.entry.command).effects = named;
    }
    draft.scene.script.push_back(line.entry);
    draft.script_lines.push_back(line.number);
  }
}

}  // namespace

Draft read_draft(std::string_view text) {
  Draft draft;
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    draft.findings.push_back(
        {0,
         {"",
          R"(is empty: a scene is a JSON object, as in {"box": {"width": 20, "height": 10}})"}});
    return draft;
  }
  if (const auto problem = json::find_text_problem(text)) {
    draft.findings.push_back({0, {json::line_and_column(text, problem->offset), problem->message}});
    return draft;
  }
  SceneReader reader(text);
  try {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    draft.complete = text[first] == '{';
    reader.read(draft.scene);
    draft.findings = reader.take_findings();
  } catch (const json::Malformed& malformed) {
    draft.complete = false;
    draft.findings = reader.take_complaints();
    draft.findings.push_back(
        {malformed.offset,
         {malformed.pointer.empty() ? json::line_and_column(text, malformed.offset)
                                    : malformed.pointer,
          malformed.message}});
    return draft;
  }
  take_script(text, std::move(reader.lines()), draft);
  return draft;
}

}  // namespace carom::scene
