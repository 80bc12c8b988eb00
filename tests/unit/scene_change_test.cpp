// Changes of single values before a scene is checked: --set and sweeps.
#include "carom/scene_change.hpp"

#include <gtest/gtest.h>

#include "carom/scene_file.hpp"
#include "scene/set_value.hpp"

namespace carom::scene_change_test {
namespace {

std::string changed(const std::string& text, const std::string& change) {
  return scene::set_value(text, parse_change(change));
}

TEST(SceneChange, ReplacesTheValueThatIsThere) {
  EXPECT_EQ(changed(R"({"a": 1, "b": [1, {"c": "x,]}\"" }], "d": 4})", "/b/1/c=7"),
            R"({"a": 1, "b": [1, {"c": 7 }], "d": 4})");
  EXPECT_EQ(changed(R"( { "a" : [ [ ] , { } ] , "b":-1e5 } )", "/b=[2, 3]"),
            R"( { "a" : [ [ ] , { } ] , "b":[2, 3] } )");
  EXPECT_EQ(changed(R"({"a": {"b": 1}})", "/a=null"), R"({"a": null})");
}

TEST(SceneChange, FindsKeysAsThePointerEscapesThem) {
  EXPECT_EQ(changed(R"({"a/b": 1, "m~n": 2})", "/a~1b=5"), R"({"a/b": 5, "m~n": 2})");
  EXPECT_EQ(changed(R"({"a/b": 1, "m~n": 2})", "/m~0n=5"), R"({"a/b": 1, "m~n": 5})");
  EXPECT_EQ(changed(R"({"\u0061": 1})", "/a=5"), R"({"\u0061": 5})");
}

TEST(SceneChange, AddsWhatIsNotThereWithWhatIsAroundIt) {
  EXPECT_EQ(changed("{}", "/seed=7"), R"({"seed": 7})");
  EXPECT_EQ(changed(R"({"a": 1})", "/effects/drag/rate=0.5"),
            R"({"a": 1, "effects": {"drag": {"rate": 0.5}}})");
  EXPECT_EQ(changed(R"({"a": []})", "/a/0=5"), R"({"a": [5]})");
  EXPECT_EQ(changed(R"({"a": [1, 2]})", "/a/2=5"), R"({"a": [1, 2, 5]})");
  EXPECT_EQ(changed(R"({"a": [1, 2]})", "/a/-=5"), R"({"a": [1, 2, 5]})");
  EXPECT_EQ(changed("{}", "/balls/-/radius=5"), R"({"balls": [{"radius": 5}]})");
}

TEST(SceneChange, ABareWordIsAText) {
  EXPECT_EQ(parse_change("/solver/method=event").value, "\"event\"");
  EXPECT_EQ(parse_change("/workers=per-ball").value, "\"per-ball\"");
  EXPECT_EQ(parse_change("/name=a=b").value, "\"a=b\"");
  EXPECT_EQ(parse_change("/x=true").value, "true");
  EXPECT_EQ(parse_change("/x=\"1\"").value, "\"1\"");
}

TEST(SceneChange, RefusesWhatIsNoChange) {
  for (const char* text : {"", "seed=1", "/seed", "/seed=", "/seed=1x", "/seed=[1", "/seed={\"a\"}",
                           "/seed=1e999", "/seed=\"a", "/name=a\"b"}) {
    EXPECT_THROW(parse_change(text), std::invalid_argument) << text;
  }
}

TEST(SceneChange, NamesThePlaceWhereThePointerLeadsNowhere) {
  const auto place = [](const std::string& text, const std::string& change) {
    try {
      changed(text, change);
    } catch (const SceneError& error) {
      return error.problems().front().place;
    }
    return std::string("none");
  };
  EXPECT_EQ(place(R"({"a": {"b": [1, 2]}})", "/a/b/3=1"), "/a/b");
  EXPECT_EQ(place(R"({"a": {"b": [1, 2]}})", "/a/b/x=1"), "/a/b");
  EXPECT_EQ(place(R"({"a": {"b": [1, 2]}})", "/a/b/1/c=1"), "/a/b/1");
  EXPECT_EQ(place("7", "/a=1"), "");
}

TEST(SceneChange, IsJudgedWithTheScene) {
  const std::string text = R"({"box": {"width": 20, "height": 10}, "seed": 1})";
  const std::vector<SceneChange> good{parse_change("/seed=5"),
                                      parse_change("/effects/gravity=[0,-2]")};
  const Scene scene = parse_scene(text, "a", good);
  EXPECT_EQ(scene.seed, 5U);
  EXPECT_EQ(scene.effects.gravity->acceleration, Vec2(0, -2));
  const std::vector<SceneChange> bad{parse_change("/effects/nothing=1")};
  try {
    parse_scene(text, "a", bad);
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_EQ(error.problems().front().place, "/effects/nothing");
  }
}

TEST(SceneChange, AMalformedSceneIsReportedWhereItIsMalformed) {
  const std::vector<SceneChange> changes{parse_change("/box/width=5")};
  try {
    parse_scene("{\"box\": {\"width\": 20,\n \"height\" 10}}", "a", changes);
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_TRUE(error.problems().front().place.starts_with("line 2,")) << error.what();
  }
}

}  // namespace
}  // namespace carom::scene_change_test
