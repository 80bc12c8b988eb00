// The series of measurements that a run writes, against theory.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "program/written.hpp"

namespace carom::series_test {
namespace {

using test::number;
using test::periodic_gas;
using test::Row;
using test::Written;

/// The mean of a column and its standard error, from means over blocks.
std::pair<double, double> mean_and_error(const std::vector<Row>& rows, const char* name,
                                         std::size_t from) {
  constexpr std::size_t kBlocks = 20;
  const std::size_t length = (rows.size() - from) / kBlocks;
  std::vector<double> blocks(kBlocks, 0);
  for (std::size_t b = 0; b < kBlocks; ++b) {
    for (std::size_t k = 0; k < length; ++k) blocks[b] += number(rows[from + b * length + k], name);
    blocks[b] /= static_cast<double>(length);
  }
  double mean = 0;
  for (const double block : blocks) mean += block / kBlocks;
  double squares = 0;
  for (const double block : blocks) squares += (block - mean) * (block - mean);
  return {mean, std::sqrt(squares / (kBlocks - 1) / kBlocks)};
}

// Kolafa and Rottner, Molecular Physics 104 (2006) 3435.
TEST(Series, ZOfThePeriodicFluidIsTheKnownOne) {
  struct Known {
    double packing;
    double Z;
  };
  for (const Known& known : {Known{.314159, 2.1514393}, Known{.471239, 3.663691}}) {
    constexpr std::size_t kBalls = 400;
    const double radius = std::sqrt(known.packing * 100 / kBalls / 3.14159265358979);
    const Written run(periodic_gas(kBalls, radius, 60), {"series"});
    const auto rows = run.table("series");
    const auto [Z, error] = mean_and_error(rows, "Z", 21);
    EXPECT_LT(error, 0.01 * known.Z);
    EXPECT_NEAR(Z, known.Z, 3 * error + known.Z / kBalls);
    // E = (N - 1) k T without net flow.
    const Row& last = rows.back();
    EXPECT_NEAR(number(last, "temperature"), number(last, "kinetic") / (kBalls - 1), 1e-12);
    EXPECT_NEAR(number(last, "pressure") * 100 / kBalls / number(last, "temperature"),
                number(last, "Z"), 1e-12);
  }
}

// The ideal gas between walls: the centres have the box less the radii.
TEST(Series, ThePressureOnTheWallsOfADiluteGasIsThatOfTheVirial) {
  const Written run(R"({"box": {"width": 10, "height": 10}, "solver": {"method": "event"},
    "effects": {"collisions": {}, "walls": {}}, "seed": 5, "duration": 400, "frame_rate": 1,
    "fill": [{"count": 100, "radius": 0.01, "temperature": 1}]})",
                    {"series", "events"});
  double push = 0;
  std::size_t hits = 0;
  for (const Row& row : run.table("events")) {
    if (row.at("wall").empty()) continue;
    push += number(row, "impulse");
    ++hits;
  }
  const auto rows = run.table("series");
  const double temperature = number(rows.back(), "kinetic") / 100;
  const double side = 10 - 2 * 0.01;
  const double ideal = 100 * temperature / (side * side);
  // Hits come nearly at random; the mean square of their impulses is 4/pi of the squared mean.
  const double error = ideal * std::sqrt(1.3 / static_cast<double>(hits));
  EXPECT_LT(error, 0.02 * ideal);
  EXPECT_NEAR(push / (4 * side * 400), ideal, 3 * error);
  const auto [virial, spread] = mean_and_error(rows, "pressure", 1);
  EXPECT_NEAR(virial, 100 * temperature / 100, 3 * spread + 0.02);
}

}  // namespace
}  // namespace carom::series_test
