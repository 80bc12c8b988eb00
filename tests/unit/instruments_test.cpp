// The instruments against what is known of hard disks in equilibrium.
#include "view/instruments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "view/instruments_panel.hpp"
#include "view/sparkline.hpp"

namespace carom::instruments_test {
namespace {

/// Equal disks on a hexagonal lattice in a periodic box; each has its own direction, all the same
/// speed: an equilibrium of places but not of speeds.
Scene disks(double packing) {
  constexpr int kColumns = 24;
  constexpr int kRows = 26;
  Scene scene;
  scene.box = {kColumns, kRows * std::sqrt(0.75)};
  scene.box.periodic = {true, true};
  scene.effects.collisions.emplace();
  scene.solver.method = Method::event;
  const double count = kColumns * kRows;
  const double radius =
      std::sqrt(packing * scene.box.width * scene.box.height / (count * std::numbers::pi));
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      // Opposite neighbours fly opposite ways: no momentum.
      const int of_two = column / 2;
      const double angle = 2.4 * row + 1.7 * of_two + (column % 2) * std::numbers::pi;
      scene.balls.push_back({{column + (row % 2) * 0.5 + 0.25, (row + 0.5) * std::sqrt(0.75)},
                             {2 * std::cos(angle), 2 * std::sin(angle)},
                             radius});
    }
  }
  return scene;
}

/// The largest distance between the measured and the expected share of slower balls.
double farthest_from_maxwell(const SpeedCounts& speeds) {
  double measured = 0;
  double expected = 0;
  double farthest = 0;
  for (std::size_t k = 0; k < speeds.counts.size(); ++k) {
    measured += speeds.counts[k] / speeds.total;
    expected += speeds.expected[k] / speeds.total;
    farthest = std::max(farthest, std::abs(measured - expected));
  }
  return farthest;
}

TEST(Instruments, AreRightForDisksInEquilibrium) {
  // Source: J. Kolafa, M. Rottner, Mol. Phys. 104 (2006) 3435: Z = 2.1514393 at this packing.
  Simulation simulation(disks(0.314159));
  Instruments instruments;
  instruments.open(simulation, simulation.measure());
  simulation.advance_to(0.001);
  instruments.measure(simulation, simulation.measure());
  EXPECT_GT(farthest_from_maxwell(instruments.readings().speeds), 0.3) << "all equally fast";
  simulation.advance_to(8);  // some seventy impacts of each ball
  instruments.begin_again(simulation, simulation.measure());
  for (int frame = 1; frame <= 300; ++frame) {
    simulation.advance_to(8 + frame / 30.0);
    instruments.measure(simulation, simulation.measure());
  }
  const InstrumentReadings readings = instruments.readings();
  EXPECT_NEAR(readings.span, 10, 0.1);
  // k T = E / (N - 1) at no momentum, all the time.
  const double n = 24 * 26;
  ASSERT_TRUE(readings.temperature && readings.Z && readings.impacts_per_second);
  EXPECT_NEAR(readings.temperature->mean, n * 2 / (n - 1), 1e-9);
  EXPECT_NEAR(readings.temperature->error.value_or(1), 0, 1e-9);
  EXPECT_NEAR(readings.Z->mean, 2.1514393, 0.03);
  ASSERT_TRUE(readings.Z->error.has_value());
  EXPECT_LT(*readings.Z->error, 0.03);
  EXPECT_GT(*readings.Z->error, 0.0005);
  // Each ball has Z - 1 = (rate / N) (sigma / 2) sqrt(pi m / kT) impacts a second for the two.
  const double sigma = 2 * simulation.state().front().radius;
  const double rate = 1.1514393 * n / (sigma / 2 * std::sqrt(std::numbers::pi / 2));
  EXPECT_NEAR(readings.impacts_per_second->mean / rate, 1, 0.03);
  // Maxwell's mean speed is sqrt(pi kT / 2 m); a ball has two of each N impacts.
  ASSERT_TRUE(readings.mean_free_path.has_value());
  EXPECT_NEAR(*readings.mean_free_path * 2 * rate / n / std::sqrt(std::numbers::pi), 1, 0.03);
  EXPECT_LT(farthest_from_maxwell(readings.speeds), 0.02);
  ASSERT_TRUE(readings.theory.has_value());
  EXPECT_NEAR(readings.theory->Z, 2.1514393, 0.004) << "Henderson's is within 0.2 %";
  EXPECT_NEAR(readings.theory->impacts_per_second / rate, 1, 0.005);
  EXPECT_NEAR(readings.kinetic.back(), 2 * n, 1e-9);
  EXPECT_EQ(readings.potential.back(), 0);
  EXPECT_EQ(readings.dissipated.back(), 0);
}

TEST(Instruments, SplitTheEnergyIntoItsParts) {
  Scene scene;
  scene.effects.walls.emplace().restitution = 0.5;
  scene.effects.gravity.emplace().acceleration = {0, -2};
  scene.balls.push_back({{10, 5}, {1, 0}});
  scene.balls.front().radius = 0.5;
  Simulation simulation(scene);
  Instruments instruments;
  instruments.open(simulation, simulation.measure());
  simulation.advance_to(1);
  instruments.measure(simulation, simulation.measure());
  // It has fallen by 1, at 2 a second.
  EXPECT_NEAR(instruments.readings().kinetic.back(), (1 + 4) / 2.0, 1e-12);
  EXPECT_NEAR(instruments.readings().potential.back(), 2 * 4, 1e-12);
  simulation.advance_to(2.2);
  instruments.measure(simulation, simulation.measure());
  // At the floor it was 4.5 lower and lost three quarters of the energy of that fall.
  EXPECT_NEAR(instruments.readings().dissipated.back(), 0.75 * 2 * 4.5, 1e-9);
  EXPECT_LT(instruments.readings().error.back(), 1e-12);
  EXPECT_FALSE(instruments.readings().theory.has_value());
}

TEST(Instruments, BeginAgainWhereTheSimulationIsAnotherOneOrChanged) {
  Simulation simulation(disks(0.2));
  Instruments instruments;
  instruments.open(simulation, simulation.measure());
  const auto run_to = [&](double time) {
    simulation.advance_to(time);
    instruments.measure(simulation, simulation.measure());
  };
  run_to(0.5);
  run_to(1);
  EXPECT_NEAR(instruments.readings().span, 1, 1e-12);
  simulation.apply(command::Remove{});
  run_to(1.5);
  run_to(2);
  EXPECT_NEAR(instruments.readings().span, 0.5, 1e-12);
  simulation = Simulation(disks(0.2));
  run_to(0.25);
  run_to(0.5);
  EXPECT_NEAR(instruments.readings().span, 0.25, 1e-12);
  EXPECT_GT(instruments.readings().Z->mean, 1.2) << "impacts are noted again";
}

std::string text_of(const Canvas& canvas) {
  std::string text;
  for (int row = 0; row < canvas.rows; ++row) {
    for (int column = 0; column < canvas.columns; ++column)
      text += static_cast<char>(canvas.at(column, row).character);
    text += '\n';
  }
  return text;
}

TEST(InstrumentsPanel, IsAsLargeAsItIsTold) {
  Simulation simulation(disks(0.2));
  Instruments instruments;
  instruments.open(simulation, simulation.measure());
  for (int empty = 1; empty >= 0; --empty) {
    for (int columns = 0; columns < 130; columns += 7) {
      for (int rows = 0; rows < 40; rows += 3) {
        const Canvas panel =
            instruments_panel(instruments.readings(), columns, rows, Glyphs::ascii);
        EXPECT_EQ(panel.columns, columns);
        EXPECT_EQ(panel.rows, rows);
      }
    }
    simulation.advance_to(0.1);
    instruments.measure(simulation, simulation.measure());
  }
}

TEST(InstrumentsPanel, DrawsACurveForEachAverageInItsRowOrBelowIt) {
  InstrumentReadings readings;
  readings.temperature = TimeAverage{1, std::nullopt};
  readings.pressure = TimeAverage{2, std::nullopt};
  readings.Z = TimeAverage{3, std::nullopt};
  readings.impacts_per_second = TimeAverage{4, std::nullopt};
  readings.temperatures = {1, 1, 9, 9};
  readings.pressures = {9, 9, 1, 1};
  readings.compressibilities = {1, 9, 1, 9};
  readings.impact_rates = {9, 1, 9, 1};
  // Wide enough: in the row of the value.  Narrow: below it.
  const std::string wide = text_of(instruments_panel(readings, 44, 30, Glyphs::ascii));
  const std::string narrow = text_of(instruments_panel(readings, 78, 11, Glyphs::ascii));
  for (const auto& [name, curve] : {std::pair{"temperature", "__@@"}, std::pair{"pressure", "@@__"},
                                    std::pair{"Z  ", "_@_@"}, std::pair{"impacts / s", "@_@_"}}) {
    for (const bool below : {false, true}) {
      const std::string& text = below ? narrow : wide;
      const std::size_t row = text.find('\n', text.find(name)) + (below ? 1 : 0);
      const std::size_t begin = text.rfind('\n', row - 1) + 1;
      EXPECT_NE(text.substr(begin, text.find('\n', row) - begin).find(curve), std::string::npos)
          << name << '\n'
          << text;
    }
  }
}

TEST(Sparkline, RisesWithItsValuesAndIsLevelWhereTheyAreEqual) {
  EXPECT_EQ(text_of(sparkline({0, 1, 2, 3, 4, 5, 6, 7, 8}, 9, Glyphs::ascii)), "_.-=+*#@@\n");
  EXPECT_EQ(text_of(sparkline({3, 3, 3}, 5, Glyphs::ascii)), "  ---\n");
  EXPECT_EQ(text_of(sparkline({1, 1, 9, 9}, 2, Glyphs::ascii)), "_@\n");
  EXPECT_EQ(text_of(sparkline({}, 3, Glyphs::ascii)), "   \n");
}

}  // namespace
}  // namespace carom::instruments_test
