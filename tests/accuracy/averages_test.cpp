// Averages of gases of hard disks, against published values and kinetic theory.
#include "accuracy/averages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "accuracy_averages.hpp"
#include "carom/accuracy.hpp"
#include "carom/scene_file.hpp"
#include "export/accuracy_csv.hpp"

namespace carom::averages_test {
namespace {

constexpr double kStandardErrors = 3;

/// Equal disks of diameter 1 and mass 1 on a square lattice, periodic, with k T about 1.
Scene gas(std::size_t side, double packing) {
  const auto n = static_cast<double>(side * side);
  Scene scene;
  scene.name = "gas";
  scene.box.width = scene.box.height = std::sqrt(n * std::numbers::pi / 4 / packing);
  scene.box.periodic = {true, true};
  scene.effects.collisions = Collisions{};
  Fill fill;
  fill.count = side * side;
  fill.radius = 0.5;
  fill.temperature = 1;
  fill.arrangement = Fill::Arrangement::square;
  scene.fills = {fill};
  scene.seed = 11;
  scene.solver.method = Method::event;
  return scene;
}

std::vector<std::optional<MeanAndError>> means(const Scene& scene, const accuracy::Way& way,
                                               double time, std::size_t starts) {
  std::vector<accuracy::Averages> runs;
  Scene drawn = scene;
  for (std::size_t i = 0; i < starts; ++i) {
    drawn.seed = scene.seed + i;
    const std::vector<Observable> all(kObservables.begin(), kObservables.end());
    runs.push_back(
        accuracy::averages_of(all, accuracy::scenario_of(drawn, time), way, {}, [](double) {}));
  }
  return accuracy::mean_over(runs);
}

const MeanAndError& of(const std::vector<std::optional<MeanAndError>>& all, Observable which) {
  return *all.at(static_cast<std::size_t>(which));
}

constexpr accuracy::Way kExact{Method::event, std::nullopt, 16};
constexpr double kPacking = 0.314159;
constexpr double kPublished = 2.1514393;  // Kolafa, Rottner, Mol. Phys. 104 (2006) 3435

TEST(Averages, ZOfTheFluidIsThePublishedOne) {
  const auto all = means(gas(20, kPacking), kExact, 20, 8);
  const MeanAndError& z = of(all, Observable::Z);
  ASSERT_TRUE(z.standard_error);
  EXPECT_LT(*z.standard_error, 0.01 * kPublished);
  // k T = E / (N - 1) is the microcanonical one: 1 / N of Z is left.
  EXPECT_NEAR(z.mean, kPublished, kStandardErrors * *z.standard_error + kPublished / 400);
}

TEST(Averages, ADiluteGasCollidesAsEnskogSaysAndFliesAsMaxwellSays) {
  constexpr double kDilute = 0.02;
  const auto all = means(gas(16, kDilute), kExact, 100, 8);
  const double temperature = of(all, Observable::temperature).mean;
  // The rate of a ball: 8 eta chi / sigma sqrt(T / (pi m)); its mean speed: sqrt(pi T / (2 m)).
  const double chi = (1 - 7 * kDilute / 16) / ((1 - kDilute) * (1 - kDilute));
  const double rate = 8 * kDilute * chi * std::sqrt(temperature / std::numbers::pi);
  const MeanAndError& found = of(all, Observable::collision_rate);
  EXPECT_NEAR(found.mean, rate, kStandardErrors * *found.standard_error + rate / 256);
  const double path = std::sqrt(std::numbers::pi * temperature / 2) / rate;
  const MeanAndError& flown = of(all, Observable::mean_free_path);
  EXPECT_NEAR(flown.mean, path, kStandardErrors * *flown.standard_error + path / 256);
  EXPECT_LT(*flown.standard_error, path / 50);
}

TEST(Averages, ABiasedMethodIsCaught) {
  // Steps of 1/30 s see contacts late: fewer collisions, and Z too small by many standard errors.
  const Scene scene = gas(12, 0.6);
  const auto exact = means(scene, kExact, 10, 6);
  const auto coarse = means(scene, {Method::overlap, 1.0 / 30, 16}, 10, 6);
  const MeanAndError& right = of(exact, Observable::Z);
  const MeanAndError& wrong = of(coarse, Observable::Z);
  EXPECT_GT(std::abs(wrong.mean - right.mean),
            kStandardErrors * std::hypot(*wrong.standard_error, *right.standard_error));
}

TEST(Averages, TheMeanAndItsStandardErrorAreThoseOfTheBooks) {
  const auto means = accuracy::mean_over({{1.0, std::nullopt}, {2.0, 1.0}, {6.0, 1.0}});
  ASSERT_TRUE(means[0]);
  EXPECT_DOUBLE_EQ(means[0]->mean, 3);
  EXPECT_DOUBLE_EQ(*means[0]->standard_error, std::sqrt(7.0 / 3));  // variance 7, of 3
  EXPECT_FALSE(means[1]);
  EXPECT_FALSE(accuracy::mean_over({{1.0}})[0]->standard_error);
}

TEST(Averages, TheStudyPricesThemBesideTheReference) {
  AccuracyRequest request;
  request.time = 2;
  request.share = 20;
  request.seeds = 3;
  request.observables = {Observable::Z, Observable::temperature};
  const AccuracyStudy study = study_accuracy(gas(5, 0.3), request);
  ASSERT_EQ(study.averages.size(), 2U);
  EXPECT_EQ(study.starts, 3U);
  EXPECT_EQ(study.average_digits, 34);
  for (const AccuracyRow& row : study.rows) {
    ASSERT_EQ(row.averages.size(), 2U);
    // Nothing changes the energy, so that all starts have the temperature they were drawn with.
    EXPECT_NEAR(row.averages[1]->mean, study.rows.front().averages[1]->mean, 1e-9);
  }
  const auto json = nlohmann::json::parse(to_json(study));
  const auto& row = json["rows"][3]["observables"]["Z"];
  EXPECT_NEAR(
      row["difference"].get<double>(),
      row["mean"].get<double>() - json["reference"]["observables"]["Z"]["mean"].get<double>(),
      1e-12);
  EXPECT_TRUE(row["standard_error"].is_number());
  EXPECT_NE(to_csv(study).find(",Z,Z_standard_error,Z_difference,temperature,"), std::string::npos);
  EXPECT_NE(to_average_sentences(study).find("For Z to 1 %: overlap"), std::string::npos);
  EXPECT_NE(to_average_table(study).find("reference"), std::string::npos);
}

}  // namespace
}  // namespace carom::averages_test
