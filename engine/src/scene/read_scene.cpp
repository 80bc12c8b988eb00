#include "scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>

#include "json/reader.hpp"
#include "json/text.hpp"
#include "scene/table.hpp"

namespace carom::scene {

namespace {

using json::Kind;
using json::Reader;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargestExact = 0x1p53;  // whole numbers written as 2e2 are taken up to here

/// As JSON writes numbers, with at most as many digits as any scalar has, and no absurd exponent.
bool is_decimal(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return text.size() <= kLongest && error == std::errc() && stop == end && std::isfinite(value);
}

template <class Object>
std::string_view nearest_key(std::string_view unknown) {
  std::vector<std::string_view> names;
  for_each_key<Object>([&](const auto& key) { names.push_back(key.name); });
  return nearest_word(unknown, names);
}

std::string one_of(std::span<const std::string_view> words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view join = i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    list += fmt::format("{}\"{}\"", join, words[i]);
  }
  return "must be " + list;
}

/// Which keys that are required are missed where they are not there.
enum class Missing { everywhere, at_the_top, nowhere };

/// A line of the script whose effects wait until those before it are known.
struct Line {
  ScriptLine entry;
  std::size_t number = 0;
  std::optional<std::size_t> effects;  ///< where in the text
};

class SceneReader {
 public:
  explicit SceneReader(std::string_view text, std::size_t begin = 0)
      : text_(text), in_(text, begin) {}

  void read(Scene& scene) {
    read_object(scene, Missing::everywhere);
    in_.end();
  }
  /// What the object names, on top of what `effects` holds already.
  void read_on_top(Effects& effects) { read_object(effects, Missing::nowhere); }

  std::vector<Finding> take_findings() {
    for (json::Complaint& complaint : in_.complaints()) {
      findings_.push_back(
          {complaint.offset, {std::move(complaint.pointer), std::move(complaint.message)}});
    }
    return std::move(findings_);
  }
  /// Of a text that is malformed: of the rest only what keeps it from being JSON counts.
  std::vector<Finding> take_complaints() {
    findings_.clear();
    return take_findings();
  }
  std::vector<Line>& lines() { return lines_; }

 private:
  void find(std::size_t offset, std::string place, std::string message) {
    findings_.push_back({offset, {std::move(place), std::move(message)}});
  }
  /// The next value is not what it must be; passes it.
  void wrong(std::string_view demand) {
    const std::size_t offset = in_.offset();
    if (in_.peek() == Kind::not_finite) return in_.not_finite();  // that is a complaint
    std::string place = in_.pointer();
    std::string got = in_.describe_and_skip();
    if (got == "no number") return;
    find(offset, std::move(place), fmt::format("{}, got {}", demand, got));
  }

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

  // --- values, by their types ---

  void read(double& number, Missing) {
    if (in_.peek() == Kind::number) {
      number = in_.number().value;
    } else {
      number = kUnknown;
      wrong("must be a number");
    }
  }

  void read(bool& flag, Missing) {
    if (in_.peek() == Kind::flag) {
      flag = in_.flag();
    } else {
      wrong("must be true or false");
    }
  }

  void read(char& glyph, Missing) {
    const std::size_t offset = in_.offset();
    constexpr std::string_view kDemand =
        "must be one printable ASCII character in quotes, as in \"8\"";
    if (in_.peek() != Kind::text) return wrong(kDemand);
    std::string place = in_.pointer();
    const std::string text = in_.text();
    if (text.size() == 1 && text[0] > ' ' && text[0] <= '~') {
      glyph = text[0];
    } else {
      find(offset, std::move(place), fmt::format("{}, got {}", kDemand, json::in_quotes(text)));
    }
  }

  void read(std::string& text, Missing) { read_text(text); }

  /// A whole number, which may be written as 2e2; nothing where it is none.
  std::optional<std::uint64_t> whole(std::string_view demand) {
    const std::size_t offset = in_.offset();
    if (in_.peek() != Kind::number) {
      wrong(demand);
      return std::nullopt;
    }
    const json::Number number = in_.number();
    if (number.is_whole && !number.is_negative) return number.magnitude;
    if (!number.is_whole && number.value >= 0 && number.value <= kLargestExact &&
        std::trunc(number.value) == number.value) {
      return static_cast<std::uint64_t>(number.value);
    }
    if (std::isnan(number.value)) return std::nullopt;  // that is a complaint
    find(offset, in_.pointer(),
         number.is_whole
             ? fmt::format("{}, got {}{}", demand, number.is_negative ? "-" : "", number.magnitude)
             : fmt::format("{}, got {}", demand, number.value));
    return std::nullopt;
  }
  template <std::unsigned_integral Whole>
  requires(!std::same_as<Whole, bool>) void read(Whole& number, Missing) {
    constexpr std::uint64_t kMost = std::numeric_limits<Whole>::max();
    const auto read = whole("must be a whole number from 0 on");
    if (read) number = static_cast<Whole>(std::min<std::uint64_t>(*read, kMost));
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

  /// A list of two items; `read_item` is asked for each.  False: it is none.
  template <class ReadItem>
  bool read_two(std::string_view demand, ReadItem&& read_item) {
    if (in_.peek() != Kind::list) {
      wrong(demand);
      return false;
    }
    const std::size_t offset = in_.offset();
    const std::size_t before = findings_.size();
    std::size_t count = 0;
    in_.begin_list();
    for (; in_.next_item(); ++count) {
      if (count < 2) {
        read_item(count);
      } else {
        in_.skip();
      }
    }
    if (count == 2) return true;
    findings_.resize(before);  // one fault is told once
    find(offset, in_.pointer(),
         fmt::format("{}, got {}", demand, count == 0 ? "an empty list" : "a list"));
    return false;
  }

  void read(Vec2& pair, Missing missing) {
    const bool two = read_two("must be two numbers, [x, y]",
                              [&](std::size_t axis) { read(pair[axis], missing); });
    if (!two) pair = {kUnknown, kUnknown};
  }

  void read(Gravity& gravity, Missing missing) { read(gravity.acceleration, missing); }

  void read(std::array<Vec2, 2>& corners, Missing missing) {
    const bool two = read_two("must be two corners, [[left, bottom], [right, top]]",
                              [&](std::size_t corner) { read(corners[corner], missing); });
    if (!two) corners = {Vec2{kUnknown, kUnknown}, Vec2{kUnknown, kUnknown}};
  }

  void read(std::array<bool, 2>& axes, Missing) {
    if (in_.peek() != Kind::list) return wrong(R"(must be a list of "x" and "y", as in ["x"])");
    axes = {false, false};
    in_.begin_list();
    while (in_.next_item()) {
      constexpr std::string_view kDemand = R"(must be "x" or "y")";
      const std::size_t offset = in_.offset();
      if (in_.peek() != Kind::text) {
        wrong(kDemand);
        continue;
      }
      const std::string axis = in_.text();
      if (axis != "x" && axis != "y") {
        find(offset, in_.pointer(), fmt::format("{}, got {}", kDemand, json::in_quotes(axis)));
      } else if (bool& is_periodic = axes[axis == "x" ? 0 : 1]; is_periodic) {
        find(offset, in_.pointer(), fmt::format("names \"{}\" a second time", axis));
      } else {
        is_periodic = true;
      }
    }
  }

  /// Passes one of some words; gives its number.
  std::optional<std::size_t> read_word(std::span<const std::string_view> words) {
    const std::size_t offset = in_.offset();
    if (in_.peek() != Kind::text) {
      wrong(one_of(words));
      return std::nullopt;
    }
    const std::string word = in_.text();
    const auto at = std::find(words.begin(), words.end(), word);
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
    find(offset, in_.pointer(), fmt::format("{}, got {}", one_of(words), json::in_quotes(word)));
    return std::nullopt;
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void read(Enum& value, Missing) {
    const auto known = words(names_of(Enum{}));
    if (const auto number = read_word(known)) value = names_of(Enum{})[*number].value;
  }
  void read(CommandWord&, Missing) {
    std::vector<std::string_view> known;
    for_each_line([&](const auto& line) { known.push_back(std::decay_t<decltype(line)>::kWord); });
    (void)read_word(known);
  }

  template <class ReadItem>
  void read_list(ReadItem&& read_item) {
    if (in_.peek() != Kind::list) return wrong("must be a list in [ ]");
    in_.begin_list();
    while (in_.next_item()) read_item();
  }
  template <class Item>
  void read(std::vector<Item>& items, Missing) {
    read_list([&] { read_object(items.emplace_back(), Missing::everywhere); });
  }

  template <HasTable Object>
  void read(Object& object, Missing missing) {
    read_object(object, missing);
  }

  // --- texts ---

  bool read_text(std::string& text) {
    if (in_.peek() != Kind::text) {
      wrong("must be a text in quotes");
      return false;
    }
    text = in_.text();
    return true;
  }
  void read_line(std::string& line) {
    const std::size_t offset = in_.offset();
    if (!read_text(line) || json::printable(line) == line) return;
    find(offset, in_.pointer(),
         fmt::format("must be one line of text without control characters, got {}",
                     json::in_quotes(line)));
  }
  void read_decimal(std::string& decimal) {
    constexpr std::string_view kDemand = "must be a decimal number in quotes";
    const std::size_t offset = in_.offset();
    if (in_.peek() != Kind::text) return wrong(kDemand);
    decimal = in_.text();
    if (is_decimal(decimal)) return;
    find(offset, in_.pointer(), fmt::format("{}, got {}", kDemand, json::in_quotes(decimal)));
  }
  void read_decimal(std::array<std::string, 2>& pair) {
    read_two(R"(must be two decimal numbers in quotes, ["x", "y"])",
             [&](std::size_t axis) { read_decimal(pair[axis]); });
  }

  void read_workers(Scene& scene) {
    constexpr std::string_view kDemand = "must be \"per-ball\" or a whole number from 1 on";
    scene.per_ball = in_.peek() == Kind::text;
    if (!scene.per_ball) {
      scene.workers = whole(kDemand);
      return;
    }
    const std::size_t offset = in_.offset();
    const std::string word = in_.text();
    if (word == kPerBall) return;
    find(offset, in_.pointer(), fmt::format("{}, got {}", kDemand, json::in_quotes(word)));
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
    lines_.push_back({{at, std::move(command)}, number, std::nullopt});
  }

  std::string_view text_;
  Reader in_;
  std::vector<Finding> findings_;
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
    draft.scene.script.push_back(std::move(line.entry));
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
