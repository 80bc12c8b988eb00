#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>

#include "carom/scene_file.hpp"
#include "fill/random.hpp"

namespace carom::scene_populate_test {
namespace {

Scene gas(std::size_t count, Fill::Arrangement arrangement = Fill::Arrangement::random) {
  Scene scene;
  scene.box.width = 40;
  scene.box.height = 30;
  scene.effects.walls.emplace();
  scene.effects.collisions.emplace();
  Fill fill;
  fill.count = count;
  fill.radius = 0.2;
  fill.mass = 2;
  fill.temperature = 3;
  fill.arrangement = arrangement;
  scene.fills.push_back(fill);
  scene.seed = 7;
  return scene;
}

/// The scene with its fills expanded has nothing wrong with it: no overlap, nothing outside.
void expect_valid(Scene scene) {
  scene.balls = populate(scene);
  scene.fills.clear();
  const auto problems = find_problems(scene);
  EXPECT_TRUE(problems.empty()) << problems.front().place << ": " << problems.front().message;
}

bool same_bits(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto bits = [](const Vec2& v) {
      return std::pair(std::bit_cast<std::uint64_t>(v.x()), std::bit_cast<std::uint64_t>(v.y()));
    };
    if (bits(a[i].position) != bits(b[i].position)) return false;
    if (bits(a[i].velocity) != bits(b[i].velocity)) return false;
  }
  return true;
}

TEST(Random, LogarithmAgreesWithTheLibraryToAFewUnitsInTheLastPlace) {
  scene::Random random(1, 1);
  for (int i = 0; i < 10'000; ++i) {
    const double x = std::ldexp(random.uniform() + 0x1p-60, i % 40 - 30);
    const double expected = std::log(x);
    // Near 1 the logarithm is small, and so is the error.
    EXPECT_NEAR(scene::portable_log(x), expected, 4 * 0x1p-53 * std::abs(expected) + 0x1p-60);
  }
}

TEST(Random, GaussianHasTheMomentsOfTheNormalDistribution) {
  scene::Random random(42, 0);
  constexpr int kNumbers = 200'000;
  double first = 0;
  double second = 0;
  double fourth = 0;
  int beyond_two = 0;
  for (int i = 0; i < kNumbers; ++i) {
    const double x = random.gaussian();
    first += x;
    second += x * x;
    fourth += x * x * x * x;
    if (std::abs(x) > 2) ++beyond_two;
  }
  // Five standard errors: of the mean 1, of x^2 sqrt 2, of x^4 sqrt 96.
  const double root = std::sqrt(kNumbers);
  EXPECT_NEAR(first / kNumbers, 0, 5 / root);
  EXPECT_NEAR(second / kNumbers, 1, 5 * std::sqrt(2) / root);
  EXPECT_NEAR(fourth / kNumbers, 3, 5 * std::sqrt(96) / root);
  EXPECT_NEAR(double(beyond_two) / kNumbers, std::erfc(std::sqrt(2)), 5 * 0.21 / root);
}

TEST(Random, StreamsAndSeedsDiffer) {
  EXPECT_NE(scene::Random(1, 0).uniform(), scene::Random(1, 1).uniform());
  EXPECT_NE(scene::Random(1, 0).uniform(), scene::Random(2, 0).uniform());
}

TEST(Populate, PutsEveryBallInsideAndNoneOnAnother) {
  for (const auto arrangement :
       {Fill::Arrangement::random, Fill::Arrangement::square, Fill::Arrangement::hexagonal}) {
    Scene scene = gas(2000, arrangement);
    Ball obstacle;
    obstacle.position = {20, 15};
    obstacle.radius = 4;
    scene.balls.push_back(obstacle);
    Fill second = scene.fills[0];
    second.count = 20;
    second.radius = 0.25;
    scene.fills.push_back(second);
    EXPECT_EQ(populate(scene).size(), 2021U);
    expect_valid(scene);
  }
}

TEST(Populate, StaysInTheRegion) {
  for (const auto arrangement :
       {Fill::Arrangement::random, Fill::Arrangement::square, Fill::Arrangement::hexagonal}) {
    Scene scene = gas(50, arrangement);
    scene.fills[0].region = {Vec2{3, 4}, Vec2{9, 8}};
    for (const Ball& ball : populate(scene)) {
      EXPECT_GE(ball.position.x() - 0.2, 3 - 1e-12);
      EXPECT_LE(ball.position.x() + 0.2, 9 + 1e-12);
      EXPECT_GE(ball.position.y() - 0.2, 4 - 1e-12);
      EXPECT_LE(ball.position.y() + 0.2, 8 + 1e-12);
    }
  }
}

TEST(Populate, GivesTheSameBitsForTheSameSeedAndOthersForAnother) {
  Scene scene = gas(500);
  const auto balls = populate(scene);
  EXPECT_TRUE(same_bits(balls, populate(scene)));
  scene.seed = 8;
  EXPECT_FALSE(same_bits(balls, populate(scene)));
}

TEST(Populate, GivesVelocitiesOfTheTemperatureAndNoMomentum) {
  const auto balls = populate(gas(4000));
  Vec2 momentum{0, 0};
  Vec2 squares{0, 0};
  double size = 0;
  for (const Ball& ball : balls) {
    momentum += ball.mass * ball.velocity;
    const Vec2& v = ball.velocity;
    squares += ball.mass * Vec2{v.x() * v.x(), v.y() * v.y()};
    size += ball.mass * ball.velocity.norm();
  }
  const double n = 4000;
  EXPECT_LT(momentum.norm(), 1e-13 * size);
  // m v^2 / kT has mean 1 and variance 2: five standard errors.
  EXPECT_NEAR(squares.x() / n / 3, 1, 5 * std::sqrt(2 / n));
  EXPECT_NEAR(squares.y() / n / 3, 1, 5 * std::sqrt(2 / n));
}

TEST(Populate, ScaledByPowersOfTwoGivesTheScaledBits) {
  for (const auto arrangement : {Fill::Arrangement::random, Fill::Arrangement::hexagonal}) {
    const Scene scene = gas(400, arrangement);
    Scene scaled = scene;
    const double length = 0x1p13;
    const double time = 0x1p-9;
    const double mass = 0x1p5;
    scaled.box.width *= length;
    scaled.box.height *= length;
    scaled.fills[0].radius *= length;
    scaled.fills[0].mass *= mass;
    scaled.fills[0].temperature *= mass * length * length / (time * time);
    auto balls = populate(scene);
    for (Ball& ball : balls) {
      ball.position *= length;
      ball.velocity *= length / time;
    }
    EXPECT_TRUE(same_bits(balls, populate(scaled)));
  }
}

TEST(Populate, FillsAPeriodicBoxWithAPerfectHexagonalCrystal) {
  // 16 columns a spacing of 1.25 apart and 10 rows sqrt(3)/2 of that: packed to 90 %.
  Scene scene;
  scene.box.width = 20;
  scene.box.height = 10 * 1.25 * std::sqrt(3) / 2;
  scene.box.periodic = {true, true};
  scene.effects.collisions.emplace();
  Fill fill;
  fill.count = 160;
  fill.radius = 0.6225;
  fill.arrangement = Fill::Arrangement::hexagonal;
  scene.fills.push_back(fill);
  EXPECT_GT(160 * M_PI * 0.6225 * 0.6225 / (20 * scene.box.height), 0.899);
  const auto balls = populate(scene);
  // Each ball has six neighbours at the distance of the lattice.
  for (const Ball& a : balls) {
    int neighbours = 0;
    for (const Ball& b : balls) {
      Vec2 r = b.position - a.position;
      r.x() -= 20 * std::round(r.x() / 20);
      r.y() -= scene.box.height * std::round(r.y() / scene.box.height);
      if (std::abs(r.norm() - 1.25) < 1e-12) ++neighbours;
    }
    EXPECT_EQ(neighbours, 6);
  }
  expect_valid(scene);
}

TEST(Populate, FillsASquareLatticeToTheLastPlace) {
  Scene scene = gas(48, Fill::Arrangement::square);
  scene.box.width = 8;
  scene.box.height = 6;
  scene.fills[0].radius = 0.5;
  const auto balls = populate(scene);
  EXPECT_EQ(balls.size(), 48U);
  EXPECT_EQ(balls[0].position, Vec2(0.5, 0.5));
  EXPECT_EQ(balls[47].position, Vec2(7.5, 5.5));
  expect_valid(scene);
}

TEST(Populate, SaysHowManyFoundRoomWhereThereIsTooLittle) {
  Scene scene = gas(60);
  scene.box.width = 8;
  scene.box.height = 6;
  scene.fills[0].radius = 0.45;
  scene.source = "FILE";
  try {
    populate(scene);
    FAIL() << "it was filled";
  } catch (const SceneError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.substr(0, 39), "FILE: /fill/0/count: does not fit: only");
    EXPECT_NE(line.find("of 60 balls found room at random"), std::string::npos) << line;
    EXPECT_NE(line.find("hexagonal"), std::string::npos);
  }
  scene.fills[0].arrangement = Fill::Arrangement::square;
  EXPECT_THROW(populate(scene), SceneError);
}

TEST(Populate, GivesEveryBallOfAFillItsGlyph) {
  Scene scene = gas(3);
  scene.fills[0].glyph = '@';
  for (const Ball& ball : populate(scene)) EXPECT_EQ(ball.glyph, '@');
}

// As the contract has it.
TEST(WorkerCount, IsOnePerBallThatCanMoveUpTo256WhereTheSceneIsPlayed) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  Scene scene;
  scene.played = true;
  EXPECT_EQ(worker_count(scene, 0, 0), 1U);
  EXPECT_EQ(worker_count(scene, 300, 256), 256U);
  EXPECT_EQ(worker_count(scene, 300, 257), cores);
  scene.played = false;
  scene.per_ball = true;
  EXPECT_EQ(worker_count(scene, 257), 257U);
}

// A few balls, and what one worker does while the others wait, are not shared.
TEST(WorkerCount, IsOneElsewhereWhereSharingDoesNotPay) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  Scene scene;
  scene.effects.walls = Walls{};
  scene.effects.collisions = Collisions{};
  for (const Method method : {Method::event, Method::overlap}) {
    scene.solver.method = method;
    for (const std::size_t balls : {0U, 1U, 200U, 1000U}) EXPECT_EQ(worker_count(scene, balls), 1U);
    EXPECT_EQ(worker_count(scene, 1'000'000), cores);
  }
  scene.solver.method = Method::event;
  scene.effects.friction = Friction{};
  EXPECT_EQ(worker_count(scene, 1'000'000), cores);
  scene.effects.gravity = Gravity{};
  EXPECT_EQ(worker_count(scene, 1'000'000), 1U) << "balls that spin and fall are in one event loop";
  scene.workers = 3;
  EXPECT_EQ(worker_count(scene, 257), 3U);
}

}  // namespace
}  // namespace carom::scene_populate_test
