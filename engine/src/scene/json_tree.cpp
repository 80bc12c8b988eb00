#include "scene/json_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "scene/text_check.hpp"

namespace carom::scene {

namespace {

constexpr std::size_t kDeepest = 64;       // containers within containers
constexpr std::size_t kMostRefused = 100;  // numbers that are not finite, each parsed around

/// Builds the tree while nlohmann's parser reads, and keeps what it says where it stops.
class Builder {
 public:
  using Json = nlohmann::json;

  Builder(Tree& tree, const std::set<std::size_t>& refused) : tree_(tree), refused_(refused) {}

  bool null() { return put({}); }
  bool boolean(bool flag) {
    Value value;
    value.kind = Value::Kind::flag;
    value.flag = flag;
    return put(std::move(value));
  }
  bool number_integer(Json::number_integer_t number) {
    Value value;
    value.kind = Value::Kind::whole;
    value.flag = number < 0;
    value.magnitude =
        value.flag ? ~static_cast<std::uint64_t>(number) + 1 : static_cast<std::uint64_t>(number);
    value.number = static_cast<double>(number);
    return put(std::move(value));
  }
  bool number_unsigned(Json::number_unsigned_t number) {
    Value value;
    value.kind = Value::Kind::whole;
    value.magnitude = number;
    value.number = static_cast<double>(number);
    return put(std::move(value));
  }
  bool number_float(Json::number_float_t number, const std::string&) {
    Value value;
    value.kind = Value::Kind::real;
    value.number = number;
    return put(std::move(value));
  }
  bool string(std::string& text) {
    Value value;
    value.kind = Value::Kind::text;
    value.parts = std::make_unique<Value::Parts>();
    value.parts->text = std::move(text);
    return put(std::move(value));
  }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Value::Kind::object); }
  bool start_array(std::size_t) { return open(Value::Kind::list); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& key) {
    open_.back()->parts->keys.push_back(std::move(key));
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& e) {
    position_ = position;
    error_ = e.what();
    overflow_ = e.id == 406;
    return false;
  }

  /// The place of the value that comes next.
  [[nodiscard]] std::string pointer() const {
    std::string place;
    for (const Value* value : open_) {
      if (value->kind == Value::Kind::list) {
        const bool inside = value != open_.back();
        place += fmt::format("/{}", value->items().size() - (inside ? 1 : 0));
      } else if (!value->keys().empty()) {
        place += fmt::format("/{}", pointer_step(value->keys().back()));
      }
    }
    return place;
  }
  [[nodiscard]] std::size_t ordinal() const { return ordinal_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// What comes next is a value, and no key.
  [[nodiscard]] bool at_value() const {
    if (open_.empty() || open_.back()->kind == Value::Kind::list) return true;
    return open_.back()->keys().size() > open_.back()->items().size();
  }
  [[nodiscard]] bool overflow() const { return overflow_; }  ///< of a number
  [[nodiscard]] bool too_deep() const { return too_deep_; }
  [[nodiscard]] const Value* innermost() const { return open_.empty() ? nullptr : open_.back(); }

 private:
  Value* place_value(Value value) {
    value.ordinal = ordinal_++;
    if (open_.empty()) {
      tree_.root = std::move(value);
      return &tree_.root;
    }
    Value::Parts& parent = *open_.back()->parts;
    parent.items.push_back(std::move(value));
    return &parent.items.back();
  }

  bool put(Value value) {
    if (refused_.contains(ordinal_)) value.kind = Value::Kind::refused;
    place_value(std::move(value));
    return true;
  }

  bool open(Value::Kind kind) {
    if (open_.size() >= kDeepest) {
      too_deep_ = true;
      return false;
    }
    Value value;
    value.kind = kind;
    value.parts = std::make_unique<Value::Parts>();
    open_.push_back(place_value(std::move(value)));
    return true;
  }

  bool close() {
    const Value& value = *open_.back();
    if (value.kind == Value::Kind::object) find_duplicates(value);
    open_.pop_back();
    return true;
  }

  void find_duplicates(const Value& object) {
    const std::vector<std::string>& keys = object.keys();
    if (keys.size() < 2) return;
    std::vector<std::size_t> order(keys.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    const std::string place = pointer_of_innermost();
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (keys[order[i]] != keys[order[i - 1]]) continue;
      tree_.findings.push_back({object.items()[order[i]].ordinal,
                                {fmt::format("{}/{}", place, pointer_step(keys[order[i]])),
                                 "is given more than once, keep one of them"}});
    }
  }

  [[nodiscard]] std::string pointer_of_innermost() const {
    std::string place;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      const Value& value = *open_[i];
      place += value.kind == Value::Kind::list
                   ? fmt::format("/{}", value.items().size() - 1)
                   : fmt::format("/{}", pointer_step(value.keys().back()));
    }
    return place;
  }

  Tree& tree_;
  const std::set<std::size_t>& refused_;
  std::vector<Value*> open_;  // a container's parent does not grow while it is open
  std::size_t ordinal_ = 0;
  std::size_t position_ = 0;
  std::string error_;
  bool overflow_ = false;
  bool too_deep_ = false;
};

struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
};

bool part_of_token(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
}

/// The word or number that the parser was in when it stopped after `position` bytes.
Token token_at(std::string_view text, std::size_t position) {
  Token token;
  token.end = std::min(position, text.size());
  token.begin = token.end;
  while (token.begin > 0 && part_of_token(text[token.begin - 1])) --token.begin;
  while (token.end < text.size() && part_of_token(text[token.end])) ++token.end;
  return token;
}

bool means_not_finite(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

/// The parser's own words, without its name and position: "unexpected '}'; expected ...".
std::string parser_words(const std::string& what) {
  std::size_t from = what.find(" - ");
  from = from == std::string::npos ? what.rfind(": ") : from + 1;
  std::string words = from == std::string::npos ? what : what.substr(from + 2);
  const std::size_t read = words.find("; last read: ");
  if (read != std::string::npos) {
    const std::size_t end = words.find("; expected", read);
    words.erase(read, end == std::string::npos ? std::string::npos : end - read);
  }
  return words;
}

std::string malformed(const Builder& builder, std::string_view text) {
  if (builder.too_deep()) {
    return fmt::format("is nested deeper than {} lists and objects", kDeepest);
  }
  if (builder.position() > text.size() ||
      text.substr(builder.position()).find_first_not_of(" \t\r\n") == std::string_view::npos) {
    const Value* inside = builder.innermost();
    if (builder.error().find("end of input") != std::string::npos && inside != nullptr) {
      return fmt::format("is not complete JSON: the file ends inside {}, it may be cut short",
                         inside->kind == Value::Kind::list ? "a list" : "an object");
    }
    if (builder.error().find("missing closing quote") != std::string::npos) {
      return "is not complete JSON: the file ends inside a text, it may be cut short";
    }
  }
  return "is not JSON: " + parser_words(builder.error());
}

}  // namespace

const Value* Value::find(std::string_view key) const {
  if (kind != Kind::object) return nullptr;
  for (std::size_t i = 0; i < keys().size(); ++i) {
    if (keys()[i] == key) return &items()[i];
  }
  return nullptr;
}

Tree parse_tree(std::string_view text) {
  if (std::optional<Problem> problem = find_text_problem(text)) {
    Tree tree;
    tree.findings.push_back({0, *problem});
    return tree;
  }
  std::vector<Finding> not_finite;
  std::set<std::size_t> refused;
  std::string patched;  // the text with numbers that are not finite blanked out
  while (true) {
    Tree tree;
    Builder builder(tree, refused);
    tree.complete = nlohmann::json::sax_parse(text, &builder);
    if (tree.complete) {
      std::move(not_finite.begin(), not_finite.end(), std::back_inserter(tree.findings));
      return tree;
    }
    const Token token = token_at(text, builder.position());
    const std::string word(text.substr(token.begin, token.end - token.begin));
    const bool overflow = builder.overflow();
    if (!word.empty() && builder.at_value() && (overflow || means_not_finite(word)) &&
        refused.size() < kMostRefused && !refused.contains(builder.ordinal())) {
      not_finite.push_back(
          {builder.ordinal(),
           {builder.pointer(), fmt::format("must be a finite number{}, got {} ({})",
                                           overflow ? " within the range of double precision" : "",
                                           word, line_and_column(text, token.begin))}});
      refused.insert(builder.ordinal());
      if (patched.empty()) patched = text;
      std::fill(patched.begin() + static_cast<std::ptrdiff_t>(token.begin),
                patched.begin() + static_cast<std::ptrdiff_t>(token.end), ' ');
      patched[token.begin] = '0';
      text = patched;
      continue;
    }
    Tree broken;
    broken.findings = std::move(not_finite);
    const std::size_t at = builder.position() == 0 ? 0 : builder.position() - 1;
    broken.findings.push_back(
        {builder.ordinal(),
         {line_and_column(text, builder.too_deep() ? std::string_view::npos : at),
          malformed(builder, text)}});
    if (builder.too_deep()) broken.findings.back().problem.place = builder.pointer();
    return broken;
  }
}

std::string pointer_step(std::string_view key) {
  std::string step;
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return printable(step);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return fmt::format("\"{}\"", printable(text));
  std::size_t cut = kLongest;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) --cut;
  return fmt::format("\"{}...\"", printable(text.substr(0, cut)));
}

std::string describe(const Value& value) {
  switch (value.kind) {
    case Value::Kind::null:
      return "null";
    case Value::Kind::flag:
      return value.flag ? "true" : "false";
    case Value::Kind::whole:
      return fmt::format("{}{}", value.flag ? "-" : "", value.magnitude);
    case Value::Kind::real:
      return fmt::format("{}", value.number);
    case Value::Kind::text:
      return in_quotes(value.text());
    case Value::Kind::list:
      return value.items().empty() ? "an empty list" : "a list";
    case Value::Kind::object:
      return value.items().empty() ? "an empty object" : "an object";
    case Value::Kind::refused:
      break;
  }
  return "no number";
}

}  // namespace carom::scene
