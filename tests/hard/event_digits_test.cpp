#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hard/reference_scene.hpp"
#include "solvers/event/event_loop.hpp"
#include "solvers/event/solver.hpp"
#include "solvers/event/wide_physics.hpp"
#include "support/advance.hpp"

namespace carom::event_digits_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

std::unique_ptr<Solver> run(Scene scene, int digits, double time) {
  scene.solver.digits = digits;
  auto solver = std::make_unique<EventSolver>(scene, populate(scene));
  test::advance(*solver, time);
  return solver;
}

Exact total(const std::vector<double>& parts) {
  Exact sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

double off(const std::vector<double>& got, const nlohmann::json& expected, double period) {
  Exact difference = total(got) - Exact(expected.get<std::string>());
  if (period > 0) difference -= period * round(difference / period);
  return std::abs(static_cast<double>(difference));
}

class EventDigits : public testing::TestWithParam<const char*> {};

// The true ends are written with 25 digits.
TEST_P(EventDigits, ends_nearer_to_the_truth_by_the_digits_it_computes_in) {
  const test::ReferenceScene reference = test::reference_scene(GetParam());
  const auto& [scene, time, condition, expected] = reference;
  const Box& box = scene.box;
  const auto solver = run(scene, 34, time);
  Measurements measured;
  solver->count(measured);
  EXPECT_EQ(measured.ball_ball, expected["ball_ball"].get<std::uint64_t>());
  EXPECT_EQ(measured.ball_wall, expected["ball_wall"].get<std::uint64_t>());
  const auto end = solver->exact_positions();
  double worst = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const auto& position = expected["balls"][i]["position"];
    worst = std::max({worst, off(end[i].x, position[0], box.periodic[0] ? box.width : 0),
                      off(end[i].y, position[1], box.periodic[1] ? box.height : 0)});
  }
  EXPECT_LE(worst, (64 * condition * 0x1p-113 + 1e-24) * reference.size());
  RecordProperty("off", std::to_string(std::log10(worst)));
}

TEST_P(EventDigits, runs_of_more_digits_agree_to_the_digits_of_the_fewer) {
  const test::ReferenceScene reference = test::reference_scene(GetParam());
  const auto best = run(reference.scene, 100, reference.time)->exact_positions();
  const auto allowed = [&](double unit) {
    return 64 * reference.condition * unit * reference.size();
  };
  const auto distance_of = [&](int digits) {
    const auto end = run(reference.scene, digits, reference.time)->exact_positions();
    double worst = 0;
    for (std::size_t i = 0; i < end.size(); ++i) {
      worst = std::max(worst, distance(end[i], best[i], reference.scene.box));
    }
    return worst;
  };
  EXPECT_LE(distance_of(16), allowed(0x1p-53));
  EXPECT_LE(distance_of(34), allowed(0x1p-113));
  EXPECT_LE(distance_of(50), allowed(0x1p-166));
  EXPECT_GT(distance_of(34), 0) << "the digits must make a difference";
}

INSTANTIATE_TEST_SUITE_P(Scenes, EventDigits,
                         testing::Values("gas", "channel", "mixture", "open", "ideal", "periodic",
                                         "gravity", "pegs", "pegs-and-gravity", "inelastic", "drag",
                                         "drag-and-gravity", "friction"));

template <class P>
using Flights = std::vector<typename P::Disk>;

/// How far from its start a gas comes back that runs, turns all velocities round, and runs as long.
template <class P>
double return_error(double seconds) {
  using S = typename P::Scalar;
  Box box;
  box.width = 12;
  box.height = 10;
  event::BasicRules<S> rules{Domain(box, true), typename P::Clock(2)};
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  Flights<P> start;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 5; ++column) {
      typename P::Disk disk;
      disk.x = 1.2 + 2.4 * column;
      disk.y = 1.25 + 2.5 * row;
      disk.vx = normal(random);
      disk.vy = normal(random);
      start.push_back(disk);
    }
  }
  const typename P::Time end = rules.scale.ticks(S(seconds));
  Flights<P> flights = start;
  for (int way = 0; way < 2; ++way) {
    event::EventLoop<P> loop(rules);
    loop.reset(flights, 0);
    loop.advance_to(end);
    EXPECT_GT(loop.counts().ball_ball, 50U);
    flights.assign(loop.disks().begin(), loop.disks().end());
    for (auto& disk : flights) {
      loop.motion().carry(disk, end);
      disk.vx = -disk.vx;
      disk.vy = -disk.vy;
      disk.start = 0;
    }
  }
  double worst = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    worst = std::max({worst, std::abs(static_cast<double>(S(flights[i].x - start[i].x))),
                      std::abs(static_cast<double>(S(flights[i].y - start[i].y)))});
  }
  return worst;
}

// What is left over is the rounding that the collisions have amplified: it must shrink with the
// unit of rounding, whatever the amplification is.
TEST(EventReversal, more_digits_come_back_nearer_to_the_start_by_the_digits) {
  constexpr double kSeconds = 15;
  const double in_double = return_error<event::Ballistic>(kSeconds);
  const auto in_digits = [](int digits) {
    const WidePrecision precision(digits);
    return return_error<event::WidePhysics>(kSeconds);
  };
  const double in_34 = in_digits(34);
  const double in_50 = in_digits(50);
  const double in_100 = in_digits(100);
  EXPECT_LT(in_double, 1e-1);
  EXPECT_GT(in_double, 0);
  EXPECT_LT(in_34, in_double * 0x1p-53);
  EXPECT_LT(in_50, in_34 * 0x1p-45);
  EXPECT_LT(in_100, in_50 * 0x1p-150);
}

}  // namespace
}  // namespace carom::event_digits_test
