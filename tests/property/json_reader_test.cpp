// The reader that keeps nothing of a text, held against one that makes a tree of it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "carom/scene_file.hpp"
#include "json/reader.hpp"
#include "json/text.hpp"
#include "json/well_formed.hpp"
#include "support/any_scene.hpp"
#include "support/random_numbers.hpp"

namespace carom::json_reader_test {
namespace {

using json::Kind;
using json::Reader;
using Tree = nlohmann::ordered_json;

/// The next value as a tree.
Tree tree_of(Reader& reader) {
  switch (reader.peek()) {
    case Kind::null:
      reader.null();
      return nullptr;
    case Kind::flag:
      return reader.flag();
    case Kind::number: {
      const json::Number number = reader.number();
      if (!number.is_whole) return number.value;
      if (number.is_negative) return static_cast<std::int64_t>(0 - number.magnitude);
      return number.magnitude;
    }
    case Kind::text:
      return reader.text();
    case Kind::list: {
      Tree list = Tree::array();
      reader.begin_list();
      while (reader.next_item()) list.push_back(tree_of(reader));
      return list;
    }
    case Kind::object: {
      Tree object = Tree::object();
      reader.begin_object();
      while (reader.next_member()) {
        const std::string key(reader.key());
        object[key] = tree_of(reader);
      }
      return object;
    }
    case Kind::not_finite:
      break;
  }
  ADD_FAILURE() << "no value at " << reader.pointer();
  reader.not_finite();
  return nullptr;
}

/// What a malformed text is cut, changed and mended with.
constexpr std::string_view kPieces[] = {"{",  "}",  "[",    "]",    ",",       ":",      "\"",
                                        "\\", "0",  "7",    "-",    ".",       "e",      "+",
                                        " ",  "\n", "true", "null", "\\u00e9", "\u00e9", "1e5"};

/// A scene's text with a few pieces put in, put over, or taken out.
std::string changed(std::string text, test::RandomNumbers& random) {
  for (int changes = 1 + random.below(3); changes > 0; --changes) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
    const std::string_view piece = kPieces[random.below(static_cast<int>(std::size(kPieces)))];
    const int way = random.below(3);
    text.replace(at, way == 0 ? 0 : 1, way == 2 ? "" : piece);
  }
  return text;
}

TEST(JsonReader, GivesTheTreeOfATreeReaderForRandomScenes) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const std::string text = write_scene(test::any_scene(seed));
    Reader reader(text);
    const Tree tree = tree_of(reader);
    reader.end();
    ASSERT_EQ(tree, Tree::parse(text)) << "seed " << seed;
    ASSERT_TRUE(reader.complaints().empty());
  }
}

struct BeyondDouble {};

/// The place where nlohmann's reader stops; nothing: it does not.
/// Errors: BeyondDouble for a number that it refuses; here that is a complaint.
std::optional<std::size_t> refused_at(const std::string& text) {
  try {
    const Tree tree = Tree::parse(text);
    return std::nullopt;
  } catch (const Tree::parse_error& error) {
    return error.byte == 0 ? 0 : error.byte - 1;
  } catch (const Tree::out_of_range&) {
    throw BeyondDouble{};
  }
}

TEST(JsonReader, RefusesWhatATreeReaderRefusesAtTheSamePlace) {
  int refused = 0;
  int read = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    test::RandomNumbers random(seed);
    const std::string text = changed(write_scene(test::any_scene(seed % 64)), random);
    if (json::find_text_problem(text)) continue;
    std::optional<std::size_t> expected;
    try {
      expected = refused_at(text);
    } catch (const BeyondDouble&) {
      continue;
    }
    std::optional<std::size_t> got;
    std::string why;
    Reader reader(text);
    try {
      (void)reader.skip();
      reader.end();
    } catch (const json::Malformed& malformed) {
      got = malformed.offset;
      why = malformed.message;
    }
    ASSERT_EQ(got.has_value(), expected.has_value()) << "seed " << seed << why << "\n" << text;
    (got ? refused : read) += 1;
    if (!got) {
      Reader again(text);
      ASSERT_EQ(tree_of(again), Tree::parse(text)) << "seed " << seed;
    } else if (why.find("complete") == std::string::npos &&
               why.find("control character") == std::string::npos) {
      ASSERT_EQ(*got, *expected) << "seed " << seed << ": " << why << "\n"
                                 << text.substr(*got > 20 ? *got - 20 : 0, 40);
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 50);
}

TEST(JsonReader, TellsTextsWithEscapesLikeATreeReader) {
  for (const char* text :
       {R"("\u00e9\n\t\"\\\/\b\f\r")", R"("\ud83d\ude00 z")", R"({"\u0061b": [1, {"~/": 2}]})",
        R"([-0, 0, -0.0, 1E5, 1e-7, 18446744073709551615, -9223372036854775808, 1e400])"}) {
    Reader reader(text);
    if (std::string_view(text).find("1e400") != std::string_view::npos) {
      reader.skip();
      ASSERT_EQ(reader.complaints().size(), 1U);
      EXPECT_EQ(reader.complaints().front().pointer, "/7");
      continue;
    }
    EXPECT_EQ(tree_of(reader), Tree::parse(text)) << text;
  }
  for (const char* text : {R"("\ud83d")", R"("\ude00")", R"("\x")", "\"\n\"", R"("\u12g4")"}) {
    EXPECT_FALSE(json::is_well_formed(text)) << text;
    EXPECT_FALSE(Tree::accept(text)) << text;
  }
}

}  // namespace
}  // namespace carom::json_reader_test
