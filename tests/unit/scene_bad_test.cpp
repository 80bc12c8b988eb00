#include <gtest/gtest.h>

#include <algorithm>

#include <ostream>
#include <string>
#include <vector>

#include "carom/scene_file.hpp"

namespace carom::scene_bad_test {
namespace {

struct BadScene {
  const char* name;
  std::string text;
  std::string place;  ///< of the first problem
  std::string words;  ///< the beginning of its message

  friend void PrintTo(const BadScene& bad, std::ostream* out) { *out << bad.name; }
};

/// A scene with the usual box and these keys.
std::string with(const std::string& keys) {
  return R"({"box": {"width": 20, "height": 10}, )" + keys + "}";
}
/// The same with solid walls and collisions.
std::string solid(const std::string& keys) {
  return with(R"("effects": {"walls": {}, "collisions": {}}, )" + keys);
}
std::string ball(const std::string& keys) {
  return solid(R"("balls": [{"position": [3, 5]}, {"position": [8, 5], )" + keys + "}]");
}
std::string fill(const std::string& keys) {
  return solid(R"("fill": [{)" + keys + "}]");
}
std::string line(const std::string& keys) {
  return solid(R"("balls": [{"position": [3, 5]}], "script": [{)" + keys + "}]");
}

/// The same where balls can come to rest on each other.
std::string lying(const std::string& balls, const std::string& keys) {
  return with(R"("effects": {"walls": {"restitution": 0.5}, "collisions": {"restitution": 0.5},
                             "gravity": [0, -9.81]}, "balls": [)" +
              balls + "]" + keys);
}

const std::vector<BadScene> kBad{
    // Masses
    {"HeavyOnLight", lying(R"({"position": [3, 5]}, {"position": [8, 5], "mass": 2e9})", ""),
     "/balls/1/mass", "is 2e+09 times the lightest mass"},
    {"HeavyOnLightByTheScript",
     lying(R"({"position": [3, 5]})",
           R"(, "script": [{"at": 1, "command": "add",
                            "ball": {"position": [8, 5], "mass": 1e12}}])"),
     "/script/0/ball/mass", "is 1e+12 times the lightest mass"},
    // The text
    {"EmptyFile", "", "", "is empty"},
    {"OnlySpace", " \n\t ", "", "is empty"},
    {"TruncatedInObject", "{\"box\": {\"width\": 20,\n", "line 2, column 1",
     "is not complete JSON"},
    {"TruncatedInText", "{\"name\": \"gas", "line 1, column 14", "is not complete JSON"},
    {"MissingComma", "{\n  \"seed\": 1\n  \"name\": \"x\"\n}", "line 3, column 8", "is not JSON"},
    {"TrailingComma", "{\"seed\": 1,}", "line 1, column 12", "is not JSON"},
    {"Comment", "{ // a scene\n}", "line 1, column 3", "is not JSON"},
    {"TextAfterTheScene", with("\"seed\": 1") + " x", "line 1, column 49", "is not JSON"},
    {"NotUtf8", "{\"name\": \"\xff\"}", "line 1, column 11",
     "is not text in UTF-8: found the byte 0xFF"},
    {"OverlongUtf8", "{\"name\": \"\xc0\xaf\"}", "line 1, column 11", "is not text in UTF-8"},
    {"ZeroByte", std::string("{\"seed\": \0}", 11), "line 1, column 10", "is not text in UTF-8"},
    {"NestedTooDeep", std::string(100, '['), std::string("/0/0/0"), "is nested deeper than"},
    {"ListInPlaceOfScene", "[1, 2]", "", "must be a JSON object"},
    {"NumberInPlaceOfScene", "17", "", "must be a JSON object"},
    // Keys
    {"NoBox", "{}", "/box", "is missing"},
    {"NoWidth", R"({"box": {"height": 3}})", "/box/width", "is missing"},
    {"UnknownKeyOfScene", with(R"("efects": {})"), "/efects",
     "is not a key of a scene, the nearest known one is \"effects\""},
    {"UnknownKeyOfBall", ball(R"("radios": 1)"), "/balls/1/radios",
     "is not a key of a ball, the nearest known one is \"radius\""},
    {"UnknownEffect", with(R"("effects": {"gravty": [0, 1]})"), "/effects/gravty",
     "is not a key of effects, the nearest known one is \"gravity\""},
    {"UnknownKeyWithSlashAndTilde", with(R"("a/b~c": 1)"), "/a~1b~0c", "is not a key"},
    {"UnknownKeyWithControlCharacter", with(R"("\u001b[2J": 1)"), "/\\u001B[2J", "is not a key"},
    {"DuplicateKey", with(R"("seed": 1, "name": "x", "seed": 2)"), "/seed",
     "is given more than once"},
    {"DuplicateKeyDeep", ball(R"("mass": 1, "mass": 1)"), "/balls/1/mass",
     "is given more than once"},
    // Numbers
    {"NotANumber", ball(R"("mass": NaN)"), "/balls/1/mass",
     "must be a finite number, got NaN (line 1,"},
    {"Infinity", ball(R"("velocity": [Infinity, 0])"), "/balls/1/velocity/0",
     "must be a finite number, got Infinity"},
    {"MinusInfinity", ball(R"("velocity": [0, -Infinity])"), "/balls/1/velocity/1",
     "must be a finite number, got -Infinity"},
    {"NotANumberForAKey", R"({NaN: 1})", "line 1, column 2", "is not JSON"},
    {"TextThatQuotesTheParser", R"({"a": "out_of_range.406" x})", "line 1, column 26",
     "is not JSON"},
    {"Overflow", R"({"box": {"width": 1e999, "height": 1}})", "/box/width",
     "must be a finite number within the range of double precision, got 1e999"},
    {"HugeNumber", R"({"box": {"width": 1e200, "height": 1}})", "/box/width",
     "must be at most 1e+70 in size"},
    {"SubnormalRadius", ball(R"("radius": 5e-324)"), "/balls/1/radius", "must be at least 1e-70"},
    {"VanishingMass", ball(R"("mass": 1e-200)"), "/balls/1/mass", "must be at least 1e-70"},
    {"HugeVelocity", ball(R"("velocity": [1e300, 0])"), "/balls/1/velocity/0",
     "must be at most 1e+70"},
    {"TextForNumber", ball(R"("radius": "big")"), "/balls/1/radius",
     "must be a number, got \"big\""},
    {"NullForNumber", ball(R"("radius": null)"), "/balls/1/radius", "must be a number, got null"},
    {"ListForNumber", ball(R"("radius": [1])"), "/balls/1/radius", "must be a number, got a list"},
    // The box
    {"ZeroWidth", R"({"box": {"width": 0, "height": 1}})", "/box/width",
     "must be greater than 0, got 0"},
    {"NegativeHeight", R"({"box": {"width": 1, "height": -2.5}})", "/box/height",
     "must be greater than 0, got -2.5"},
    {"UnknownOrigin", R"({"box": {"width": 1, "height": 1, "origin": "left"}})", "/box/origin",
     "must be \"corner\" or \"center\", got \"left\""},
    {"UnknownAxis", R"({"box": {"width": 1, "height": 1, "periodic": ["z"]}})", "/box/periodic/0",
     "must be \"x\" or \"y\", got \"z\""},
    {"AxisTwice", R"({"box": {"width": 1, "height": 1, "periodic": ["x", "x"]}})",
     "/box/periodic/1", "names \"x\" a second time"},
    {"AxesNoList", R"({"box": {"width": 1, "height": 1, "periodic": "x"}})", "/box/periodic",
     "must be a list"},
    {"BoxTooSmallForPeriodicImages",
     R"({"box": {"width": 1.5, "height": 9, "periodic": ["x"]}, "effects": {"collisions": {}},
         "balls": [{"position": [1, 1]}]})",
     "/balls/0/radius", "is too large for the periodic box: its width must be at least 2,"},
    {"BoxTooLargeForTheRadius",
     R"({"box": {"width": 1e20, "height": 1}, "balls": [{"position": [1, 1]}]})", "/balls/0/radius",
     "must be at least 1e+08"},
    // Effects
    {"EffectsNoObject", with(R"("effects": ["walls"])"), "/effects", "must be an object"},
    {"RestitutionAboveOne", with(R"("effects": {"walls": {"restitution": 1.5}})"),
     "/effects/walls/restitution", "must be from 0 to 1, got 1.5"},
    {"RestitutionNegative", with(R"("effects": {"collisions": {"restitution": -0.1}})"),
     "/effects/collisions/restitution", "must be from 0 to 1, got -0.1"},
    {"GravityOneNumber", with(R"("effects": {"gravity": -9.81})"), "/effects/gravity",
     "must be two numbers, [x, y], got -9.81"},
    {"GravityThreeNumbers", with(R"("effects": {"gravity": [0, 0, -9.81]})"), "/effects/gravity",
     "must be two numbers"},
    {"DragWithoutRate", with(R"("effects": {"drag": {}})"), "/effects/drag/rate", "is missing"},
    // Balls
    {"BallWithoutPosition", solid(R"("balls": [{"radius": 1}])"), "/balls/0/position",
     "is missing"},
    {"BallNoObject", solid(R"("balls": [3])"), "/balls/0", "must be an object in { }, got 3"},
    {"BallsNoList", solid(R"("balls": {})"), "/balls", "must be a list in [ ]"},
    {"NegativeRadius", ball(R"("radius": -1)"), "/balls/1/radius",
     "must be greater than 0, got -1"},
    {"ZeroMass", ball(R"("mass": 0)"), "/balls/1/mass", "must be greater than 0, got 0"},
    {"FixedIsNoFlag", ball(R"("fixed": 1)"), "/balls/1/fixed", "must be true or false, got 1"},
    {"FixedMoves", ball(R"("fixed": true, "velocity": [1, 0])"), "/balls/1/velocity",
     "must be 0 for a fixed ball"},
    {"GlyphTwoCharacters", ball(R"("glyph": "ab")"), "/balls/1/glyph", "must be one printable"},
    {"GlyphNotAscii", ball("\"glyph\": \"\u00e9\""), "/balls/1/glyph", "must be one printable"},
    {"BallOutsideTheWalls", solid(R"("balls": [{"position": [25, 5]}])"), "/balls/0/position/0",
     "must keep the ball inside the walls, x from 0.5 to 19.5 for its radius of 0.5, got 25"},
    {"BallThroughTheFloor", solid(R"("balls": [{"position": [5, 0.25]}])"), "/balls/0/position/1",
     "must keep the ball inside the walls, y from 0.5 to 9.5"},
    {"BallLargerThanTheBox", solid(R"("balls": [{"position": [10, 5], "radius": 6}])"),
     "/balls/0/radius", "must be at most 5 to fit between the walls in y, got 6"},
    {"OverlappingBalls",
     solid(R"("balls": [{"position": [3, 5]}, {"position": [9, 5]}, {"position": [3.75, 5]}])"),
     "/balls/2", "overlaps /balls/0 by 0.25"},
    {"CoincidentBalls", solid(R"("balls": [{"position": [3, 5]}, {"position": [3, 5]}])"),
     "/balls/1", "overlaps /balls/0 by 1"},
    {"OverlapAroundThePeriodicSide",
     R"({"box": {"width": 20, "height": 10, "periodic": ["x"]}, "effects": {"collisions": {}},
         "balls": [{"position": [0.25, 5]}, {"position": [19.75, 5]}]})",
     "/balls/1", "overlaps /balls/0 by 0.5"},
    // Fills
    {"FillWithoutCount", fill(R"("radius": 1)"), "/fill/0/count", "is missing"},
    {"FillFraction", fill(R"("count": 2.5)"), "/fill/0/count",
     "must be a whole number from 0 on, got 2.5"},
    {"FillNegative", fill(R"("count": -3)"), "/fill/0/count",
     "must be a whole number from 0 on, got -3"},
    {"FillAbsurd", fill(R"("count": 100000000, "radius": 1e-9)"), "/fill/0/count",
     "makes more balls than the 10000000"},
    {"FillTooTight", fill(R"("count": 400)"), "/fill/0/count",
     "does not fit: 400 balls of radius 0.5 cover 157 % of the region"},
    {"FillCold", fill(R"("count": 3, "temperature": -1)"), "/fill/0/temperature",
     "must be 0 or greater, got -1"},
    {"FillUnknownArrangement", fill(R"("count": 3, "arrangement": "cubic")"), "/fill/0/arrangement",
     "must be \"random\", \"square\" or \"hexagonal\", got \"cubic\""},
    {"FillRegionOutside", fill(R"("count": 3, "region": [[0, 0], [21, 10]])"), "/fill/0/region/1/0",
     "must be inside the box, x from 0 to 20, got 21"},
    {"FillRegionUpsideDown", fill(R"("count": 3, "region": [[0, 5], [10, 2]])"),
     "/fill/0/region/1/1", "must be greater than 5"},
    {"FillRegionNarrow", fill(R"("count": 3, "region": [[0, 0], [0.5, 10]])"), "/fill/0/radius",
     "must be at most 0.25 to fit into the region in x, got 0.5"},
    {"FillRegionOneCorner", fill(R"("count": 3, "region": [[0, 0]])"), "/fill/0/region",
     "must be two corners"},
    // The rest
    {"SeedNegative", with(R"("seed": -1)"), "/seed", "must be a whole number from 0 on, got -1"},
    {"SeedBeyond64Bits", with(R"("seed": 18446744073709551616)"), "/seed",
     "must be a whole number"},
    {"UnknownMethod", with(R"("solver": {"method": "euler"})"), "/solver/method",
     "must be \"overlap\" or \"event\", got \"euler\""},
    {"ManyDigitsOfOverlap", with(R"("solver": {"method": "overlap", "digits": 34})"),
     "/solver/digits", "method \"overlap\" computes in 16 digits: use 16, or method \"event\""},
    {"ShortPeriodicAxisOfEvent",
     R"({"box": {"width": 4, "height": 9, "periodic": ["x"]}, "effects": {"collisions": {}},
         "balls": [{"position": [1, 1], "radius": 1}], "solver": {"method": "event"}})",
     "/solver/method",
     "\"event\" needs periodic axes longer than 4.001 radii of the largest ball, use \"overlap\""},
    {"PeriodicAxisOfEventThatJustFits",
     R"({"box": {"width": 4.000001, "height": 9, "periodic": ["x"]}, "effects": {"collisions": {}},
         "balls": [{"position": [1, 1], "radius": 1}], "solver": {"method": "event"}})",
     "/solver/method",
     "\"event\" needs periodic axes longer than 4.001 radii of the largest ball, use \"overlap\""},
    {"DigitsUnknown", with(R"("solver": {"digits": 17})"), "/solver/digits",
     "must be 16, 34, 50 or 100, got 17"},
    {"TickThatIsNoPowerOfTwo", with(R"("continuation": {"tick": 0.3})"), "/continuation/tick",
     "must be a power of two, got 0.3"},
    {"JamOfUnknownTime", with(R"("continuation": {"jam": {"impacts": 3}})"),
     "/continuation/jam/since",
     "is missing: what was counted of jams needs it, as in \"since\": \"-1234\""},
    {"JamThatLastsTooLong", with(R"("continuation": {"jam": {"since": "5", "lasts": 65}})"),
     "/continuation/jam/lasts", "must be at most 64, got 65"},
    {"JamFoundTooOften", with(R"("continuation": {"jam": {"since": "5", "found": 1001}})"),
     "/continuation/jam/found", "must be at most 1000, got 1001"},
    {"FlightsWithoutClock", solid(R"("balls": [{"position": [3, 5]}], "continuation": {"flights":
              [{"start": "0", "position": ["3", "5"], "velocity": ["0", "0"]}]})"),
     "/continuation/tick", "is missing: flights need it"},
    {"FlightWithoutBall", with(R"("continuation": {"tick": 0.5, "flights":
              [{"start": "0", "position": ["1", "2"], "velocity": ["1", "2"]}]})"),
     "/continuation/flights", "must be one for each of the 0 balls, got 1"},
    {"FlightThatIsNoNumber", with(R"("continuation": {"tick": 0.5, "flights":
              [{"start": "0", "position": ["1", "two"], "velocity": ["1", "2"]}]})"),
     "/continuation/flights/0/position/1", "must be a decimal number in quotes, got \"two\""},
    {"FlightThatLeftABallThatFlies",
     solid(R"("balls": [{"position": [3, 5]}], "continuation": {"tick": 0.5, "flights":
              [{"start": "0", "position": ["3", "5"], "velocity": ["0", "0"], "left": 0}]})"),
     "/continuation/flights/0/left", "must be the number of a fixed ball, got 0"},
    {"StepZero", with(R"("solver": {"step": 0})"), "/solver/step", "must be greater than 0, got 0"},
    {"WorkersZero", with(R"("workers": 0)"), "/workers", "must be \"per-ball\" or a whole number"},
    {"WorkersWord", with(R"("workers": "many")"), "/workers",
     "must be \"per-ball\" or a whole number"},
    {"WorkersAbsurd", with(R"("workers": 1000000000)"), "/workers", "must be at most 1000000"},
    {"DurationNegative", with(R"("duration": -1)"), "/duration", "must be 0 or greater, got -1"},
    {"DurationBeyondCounting", with(R"("duration": 1e60)"), "/duration", "is 3e+61 frames"},
    {"FrameRateZero", with(R"("frame_rate": 0)"), "/frame_rate", "must be greater than 0, got 0"},
    {"SchemaIsNoText", with(R"("$schema": 7)"), "/$schema", "must be a text in quotes, got 7"},
    {"NameWithControlCharacter", with(R"("name": "a\u001b[2J")"), "/name",
     "must be one line of text"},
    // The script
    {"ScriptUnknownCommand", line(R"("at": 1, "command": "stop")"), "/script/0/command",
     "must be \"add\", \"remove\", \"pause\", \"resume\", \"set\" or \"quit\", got \"stop\""},
    {"ScriptWithoutTime", line(R"("command": "pause")"), "/script/0/at", "is missing"},
    {"ScriptSetWithoutTime", line(R"("command": "set", "solver": {"step": 1})"), "/script/0/at",
     "is missing"},
    {"ScriptBeforeTheStart", line(R"("at": -1, "command": "pause")"), "/script/0/at",
     "must be 0 or greater, got -1"},
    {"ScriptAddWithoutBall", line(R"("at": 1, "command": "add")"), "/script/0/ball", "is missing"},
    {"ScriptAddsOutside", line(R"("at": 1, "command": "add", "ball": {"position": [-1, 5]})"),
     "/script/0/ball/position/0", "must keep the ball inside the walls"},
    {"ScriptRemovesUnknownBall", line(R"("at": 1, "command": "remove", "ball": 1)"),
     "/script/0/ball", "must be the number of a ball, at that time from 0 to 0, got 1"},
    {"ScriptPauseWithBall", line(R"("at": 1, "command": "pause", "ball": 0)"), "/script/0/ball",
     "is not a key of the command \"pause\""},
    {"ScriptSetsUnnamedEffect",
     line(R"("at": 1, "command": "set", "effects": {"gravity": [0, 1]})"),
     "/script/0/effects/gravity", "sets an effect that the scene does not name"},
    {"ScriptSetsNothing", line(R"("at": 1, "command": "set")"), "/script/0", "sets nothing"},
    {"ContinuationWithFill",
     with(R"("fill": [{"count": 1}], "continuation": {"time": 1, "clock": 1})"), "/fill",
     "cannot stand beside \"continuation\""},
};

class BadSceneIsRefused : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneIsRefused, WithItsExactPlaceAndAClearLine) {
  const BadScene& bad = GetParam();
  try {
    parse_scene(bad.text, "FILE");
    FAIL() << "it was read";
  } catch (const SceneError& error) {
    ASSERT_FALSE(error.problems().empty());
    const Problem& problem = error.problems().front();
    if (std::string_view(bad.name) == "NestedTooDeep") {
      EXPECT_EQ(problem.place.substr(0, bad.place.size()), bad.place);
    } else {
      EXPECT_EQ(problem.place, bad.place) << problem.message;
    }
    EXPECT_EQ(problem.message.substr(0, bad.words.size()), bad.words);
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos) << "more than one line";
    EXPECT_EQ(line, bad.place.empty() ? "FILE: " + problem.message
                                      : "FILE: " + problem.place + ": " + problem.message);
    EXPECT_EQ(error.problems().size(), 1U)
        << "one fault is told once: " << error.problems().back().place << ": "
        << error.problems().back().message;
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, BadSceneIsRefused, testing::ValuesIn(kBad),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(BadScene, IsNoneWithMassesOfOneToABillionOrWhereNoneCanLieOnAnother) {
  EXPECT_NO_THROW(
      parse_scene(lying(R"({"position": [3, 5]}, {"position": [8, 5], "mass": 1e9})", ""), "x"));
  EXPECT_NO_THROW(parse_scene(ball(R"("mass": 1e12)"), "x"));
}

TEST(BadScene, TellsEveryProblemInTheOrderOfTheFile) {
  try {
    parse_scene(R"({
      "seed": -1,
      "box": {"width": 20, "height": 0},
      "efects": {},
      "effects": {"collisions": {"restitution": 2}, "drag": {"rate": -1}},
      "balls": [{"position": [1, 2], "mass": NaN}, {"radius": "r"}],
      "script": [{"at": 2, "command": "remove", "ball": 7}, {"at": 1, "command": "halt"}]
    })",
                "FILE");
    FAIL() << "it was read";
  } catch (const SceneError& error) {
    std::vector<std::string> places;
    for (const Problem& problem : error.problems()) places.push_back(problem.place);
    const std::vector<std::string> expected{
        "/seed",
        "/box/height",
        "/efects",
        "/effects/collisions/restitution",
        "/effects/drag/rate",
        "/balls/0/mass",
        "/balls/1/position",
        "/balls/1/radius",
        "/script/0/ball",
        "/script/1/command",
    };
    EXPECT_EQ(places, expected);
  }
}

TEST(BadScene, NamesTheFileThatIsMissingOrADirectory) {
  const auto line = [](const char* file) -> std::string {
    try {
      read_scene(file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "it was read";
  };
  EXPECT_EQ(line("/no/such/scene.json"),
            "/no/such/scene.json: cannot be opened: No such file or directory");
  EXPECT_EQ(line("/usr"), "/usr: is a directory, name a scene file");
  EXPECT_EQ(line("/dev/zero").substr(0, 31), "/dev/zero: line 1, column 1: is");
}

TEST(BadScene, MadeInTheProgramIsToldByTheSamePointers) {
  Scene scene = builtin_scene();
  EXPECT_TRUE(find_problems(scene).empty());
  scene.solver.step = -1;
  scene.balls[3].radius = 0;
  scene.workers = 0;
  const auto problems = find_problems(scene);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].place, "/balls/3/radius");
  EXPECT_EQ(problems[1].place, "/solver/step");
  EXPECT_EQ(problems[2].place, "/workers");
}

TEST(SceneBad, AHeapOfBallsIsRefusedWithAShortList) {
  std::string balls;
  for (int i = 0; i < 3000; ++i) {
    balls += std::string(i == 0 ? "" : ", ") + R"({"position": [5, 5], "radius": 0.5})";
  }
  try {
    parse_scene(
        R"({"box": {"width": 20, "height": 10}, "effects": {"collisions": {}}, "balls": [)" +
            balls + "]}",
        "a");
    ADD_FAILURE();
  } catch (const SceneError& error) {
    EXPECT_LE(error.problems().size(), 21U);
    EXPECT_EQ(error.problems().back().place.rfind("/balls/", 0), 0U);
    EXPECT_NE(std::count_if(error.problems().begin(), error.problems().end(),
                            [](const Problem& problem) {
                              return problem.place == "/balls" &&
                                     problem.message.ends_with("more balls that overlap others");
                            }),
              0);
  }
}

}  // namespace
}  // namespace carom::scene_bad_test
