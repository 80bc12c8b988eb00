// What is written ball by ball is what a state in memory would have been written as.
#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>
#include <string>

#include "carom/report.hpp"
#include "carom/scene_file.hpp"
#include "carom/session.hpp"
#include "support/any_scene.hpp"

namespace carom::scene_stream_test {
namespace {

std::string streamed(const Session& session) {
  std::string text;
  write_scene(session.save_stream(), [&](std::string_view part) { text += part; });
  return text;
}

/// Exactly; JSON tells a whole double from a whole number no more than a decimal does.
void expect_same(const nlohmann::json& got, double expected) {
  const double number = got.get<double>();
  EXPECT_EQ(std::bit_cast<std::uint64_t>(number), std::bit_cast<std::uint64_t>(expected));
}

TEST(SceneStream, OfARunIsItsSceneInMemory) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 128; seed += 3) {
    SCOPED_TRACE(seed);
    Session session(test::any_scene(seed));
    try {
      session.advance_clock_to(0.4);
    } catch (const CommandError&) {
      continue;  // a ball that finds no room
    }
    const std::string text = streamed(session);
    ASSERT_EQ(text, write_scene(session.save()));
    if (!find_problems(session.save()).empty()) continue;  // of its script, when balls have gone
    const Scene back = parse_scene(text, "streamed");
    ++compared;
    ASSERT_EQ(text, write_scene(back));
    EXPECT_EQ(Simulation(back).state_hash(), session.simulation().state_hash());
  }
  EXPECT_GT(compared, 20);
}

TEST(SceneStream, AReportsStateIsTheOneInMemory) {
  for (std::uint64_t seed = 2; seed <= 128; seed += 5) {
    SCOPED_TRACE(seed);
    Session session(test::any_scene(seed));
    const Report report = make_report(session);
    std::string text;
    write_report(report, &session.simulation(), [&](std::string_view part) { text += part; });
    const auto json = nlohmann::json::parse(text);
    const std::vector<Ball> balls = session.simulation().state();
    ASSERT_EQ(json["state"].size(), balls.size());
    EXPECT_EQ(json["balls"], balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        expect_same(json["state"][i]["position"][axis], balls[i].position[axis]);
        expect_same(json["state"][i]["velocity"][axis], balls[i].velocity[axis]);
      }
      expect_same(json["state"][i]["radius"], balls[i].radius);
      expect_same(json["state"][i]["mass"], balls[i].mass);
      EXPECT_EQ(json["state"][i].contains("spin"), report.spin);
      if (report.spin) expect_same(json["state"][i]["spin"], balls[i].spin);
    }
    std::string without;
    write_report(report, nullptr, [&](std::string_view part) { without += part; });
    EXPECT_FALSE(nlohmann::json::parse(without).contains("state"));
  }
}

}  // namespace
}  // namespace carom::scene_stream_test
