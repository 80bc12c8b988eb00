#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "carom/scene_file.hpp"

namespace carom::scene_round_trip_test {
namespace {

/// Any double a velocity can have: all bit patterns, also -0 and subnormal numbers.
double any_number() {
  while (true) {
    const auto number = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    if (std::isfinite(number) && std::abs(number) <= 1e70) return number;
    if (std::isfinite(number)) return std::ldexp(number, -900);
  }
}

/// A length between 1 and 2 with all its digits.
double some_length() {
  return 1 + static_cast<double>(*rc::gen::arbitrary<std::uint64_t>() >> 12) * 0x1p-52;
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(const Vec2& a, const Vec2& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y());
}

RC_GTEST_PROP(SceneRoundTrip, KeepsEveryBitOfEveryNumber, ()) {
  Scene scene;
  scene.name = *rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~'));
  scene.about = "two lines\nwith \"quotes\" and a \\";
  scene.box.width = 1000 * some_length();
  scene.box.height = 1000 * some_length();
  scene.box.origin = *rc::gen::element(Box::Origin::corner, Box::Origin::center);
  scene.effects.walls = Walls{some_length() - 1};
  scene.effects.gravity = Gravity{{any_number(), any_number()}};
  const auto balls = *rc::gen::inRange<std::size_t>(0, 20);
  for (std::size_t i = 0; i < balls; ++i) {
    Ball ball;
    ball.position = {some_length() + static_cast<double>(i), 3 * some_length()};
    ball.velocity = {any_number(), any_number()};
    ball.radius = some_length() / 4;
    ball.mass = some_length();
    ball.spin = any_number();
    ball.glyph = *rc::gen::element('\0', '"', '\\', '~', '8');
    if (scene.box.origin == Box::Origin::center) ball.position *= -1;
    scene.balls.push_back(ball);
  }
  scene.seed = *rc::gen::arbitrary<std::uint64_t>();
  scene.solver.method = Method::overlap;  // event refuses speeds that cross the box without end
  scene.solver.step = some_length() / 1000;
  scene.duration = some_length();
  scene.frame_rate = 20 * some_length();
  scene.script.push_back({some_length(), command::SetStep{some_length()}});
  scene.script.push_back({2 + some_length(), command::Pause{}});
  Continuation& continuation = scene.continuation.emplace();
  continuation.time = some_length();
  continuation.clock = some_length();
  continuation.paused = true;
  continuation.step_origin = some_length();
  continuation.steps = 12345;
  continuation.tick = 0x1p-60;
  for (std::size_t i = 0; i < balls; ++i) {
    continuation.flights.push_back(
        {"-1152921504606846976", {"0.1", "-12345678901234567890.5e-20"}, {"1e-7", "-0"}, "", {}});
  }

  const std::string text = write_scene(scene);
  const Scene back = parse_scene(text, "written");
  RC_ASSERT(write_scene(back) == text);
  RC_ASSERT(back.name == scene.name);
  RC_ASSERT(back.about == scene.about);
  RC_ASSERT(same(back.box.size(), scene.box.size()));
  RC_ASSERT(same(back.effects.walls->restitution, scene.effects.walls->restitution));
  RC_ASSERT(same(back.effects.gravity->acceleration, scene.effects.gravity->acceleration));
  RC_ASSERT(!back.effects.collisions);
  RC_ASSERT(back.balls.size() == scene.balls.size());
  for (std::size_t i = 0; i < balls; ++i) {
    RC_ASSERT(same(back.balls[i].position, scene.balls[i].position));
    RC_ASSERT(same(back.balls[i].velocity, scene.balls[i].velocity));
    RC_ASSERT(same(back.balls[i].radius, scene.balls[i].radius));
    RC_ASSERT(same(back.balls[i].mass, scene.balls[i].mass));
    RC_ASSERT(same(back.balls[i].spin, scene.balls[i].spin));
    RC_ASSERT(back.balls[i].glyph == scene.balls[i].glyph);
  }
  RC_ASSERT(back.seed == scene.seed);
  RC_ASSERT(same(back.solver.step, scene.solver.step));
  RC_ASSERT(same(back.script[0].at, scene.script[0].at));
  RC_ASSERT(same(std::get<command::SetStep>(back.script[0].command).step,
                 std::get<command::SetStep>(scene.script[0].command).step));
  RC_ASSERT(same(back.continuation->time, scene.continuation->time));
  RC_ASSERT(same(back.continuation->step_origin, scene.continuation->step_origin));
  RC_ASSERT(back.continuation->flights.size() == balls);
  for (const SavedFlight& flight : back.continuation->flights) {
    const SavedFlight& before = scene.continuation->flights.front();
    RC_ASSERT(flight.start == before.start);
    RC_ASSERT(flight.position == before.position && flight.velocity == before.velocity);
  }
  RC_ASSERT(back.continuation->paused && back.continuation->steps == 12345U);
}

/// Text made of pieces of scenes is refused or read, and what is read is sound.
RC_GTEST_PROP(SceneReader, ReadsOrRefusesAnyTextAndNeverFails, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
      "{", "}", "[", "]", ",", ":", "\"box\"", "\"balls\"", "\"position\"", "\"effects\"",
      "\"fill\"", "\"script\"", "\"at\"", "\"command\"", "\"add\"", "\"ball\"", "1", "-1", "1e999",
      "NaN", "2.5", "null", "true", "\"x\"", "{\"width\": 1, \"height\": 1}", "\xff", " "));
  std::string text;
  for (const std::string& piece : pieces) text += piece;
  try {
    const Scene scene = parse_scene(text, "pieces");
    RC_ASSERT(find_problems(scene).empty());
  } catch (const SceneError& error) {
    RC_ASSERT(!error.problems().empty());
    RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
  }
}

}  // namespace
}  // namespace carom::scene_round_trip_test
