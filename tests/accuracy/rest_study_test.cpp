// What comes to rest, with ends that can be written down.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "accuracy_table.hpp"
#include "accuracy_words.hpp"
#include "carom/accuracy.hpp"
#include "export/accuracy_csv.hpp"
#include "export/accuracy_gnuplot.hpp"

namespace carom::rest_study_test {
namespace {

constexpr double kGravity = 9.81;

/// A ball that falls by 1 and bounces with restitution 0.8.
Scene dropped() {
  Scene scene;
  scene.name = "dropped";
  scene.effects.walls = Walls{};
  scene.effects.walls->restitution = 0.8;
  scene.effects.gravity = Gravity{{0, -kGravity}};
  Ball ball;
  ball.radius = 0.5;
  ball.position = {5, 1.5};
  scene.balls.push_back(ball);
  return scene;
}

AccuracyStudy study_of(const Scene& scene, double time, std::size_t seeds = 1) {
  AccuracyRequest request;
  request.time = time;
  request.seeds = seeds;
  request.share = 20;
  return study_accuracy(scene, request);
}

TEST(RestStudy, ADroppedBallRestsWhenTheorySaysAndStands) {
  const AccuracyStudy study = study_of(dropped(), 8);
  ASSERT_TRUE(study.reference.equilibrium);
  EXPECT_EQ(study.starts, 1U) << "without a fill all starts are the same";
  const AccuracyRow& event = study.rows.front();
  ASSERT_EQ(event.failure, "");
  ASSERT_EQ(event.method, Method::event);
  ASSERT_TRUE(event.rest);
  ASSERT_TRUE(event.rest->rest_time);
  // t = sqrt(2 h / g) (1 + e) / (1 - e), seen at the next of 240 looks.
  const double end = std::sqrt(2 / kGravity) * 9;
  EXPECT_GE(event.rest->rest_time->median, end - 1e-3) << "its last bounces are below what is seen";
  EXPECT_LE(event.rest->rest_time->median, end + 8.0 / 240);
  EXPECT_EQ(event.rest->kinetic_energy.median, 0);
  EXPECT_EQ(event.rest->creep.median, 0);
  EXPECT_LE(event.rest->equilibrium_residual.median, 1e-12);
  EXPECT_NEAR(event.rest->height.median, 0.5, 1e-12);
  EXPECT_EQ(event.rest->equilibrium_residual.spread, 0);
}

TEST(RestStudy, WhatNeverRestsHasNoTime) {
  const AccuracyStudy study = study_of(dropped(), 1);
  for (const AccuracyRow& row : study.rows) {
    ASSERT_EQ(row.failure, "");
    EXPECT_FALSE(row.rest->rest_time);
    EXPECT_GT(row.rest->kinetic_energy.median, 1e-3);
  }
  EXPECT_EQ(cheapest_within(study, 10), std::nullopt);
  EXPECT_NE(to_sentences(study).find("No run comes to rest within 1 s"), std::string::npos);
}

TEST(RestStudy, OnlyLossesUnderGravityLeadToRest) {
  Scene scene = dropped();
  EXPECT_TRUE(comes_to_rest(scene));
  scene.effects.walls->restitution = 1;
  EXPECT_FALSE(comes_to_rest(scene));
  scene = dropped();
  scene.effects.gravity.reset();
  EXPECT_FALSE(comes_to_rest(scene));
  scene.effects.gravity = Gravity{{0, 0}};
  EXPECT_FALSE(comes_to_rest(scene));
}

/// One row of each method, made up.
AccuracyStudy made_up() {
  AccuracyStudy study;
  study.scene = "made up";
  study.time = 2;
  study.balls = 3;
  study.smallest_radius = 0.5;
  study.seed = 7;
  study.starts = 8;
  study.drawn = true;
  study.reference.equilibrium = true;
  const auto add = [&](Method method, std::optional<double> step, double seconds, double residual,
                       double overlap, double height) {
    AccuracyRow row;
    row.method = method;
    row.step = step;
    row.seconds = row.cpu_seconds = seconds;
    row.quartiles = {seconds, seconds};
    row.repeats = 8;
    row.max_overlap = overlap;
    row.rest.emplace();
    row.rest->equilibrium_residual = {residual, residual / 2};
    row.rest->rest_time = MedianAndSpread{1, 0.25};
    row.rest->height = {height, 0};
    study.rows.push_back(row);
  };
  add(Method::event, std::nullopt, 0.06, 0, 4e-5, 4.49);
  add(Method::overlap, 1.0 / 30, 0.01, 5e-2, 8e-2, 4.44);
  add(Method::overlap, 1.0 / 60, 0.02, 1e-3, 4e-2, 4.465);
  add(Method::overlap, 1.0 / 120, 0.04, 2e-4, 5e-4, 4.4775);
  return study;
}

TEST(RestText, TheSentenceConcludes) {
  AccuracyStudy study = made_up();
  EXPECT_TRUE(to_sentences(study).starts_with(
      "At rest and in equilibrium, residual and overlap below 0.001: event, 30 ms per simulated "
      "second; overlap needs 1/120 s for that, 20 ms per simulated second.\n"))
      << to_sentences(study);
  // 4.465 and 4.4775: halves of the error each time, so 4.49.
  EXPECT_NE(to_sentences(study).find("(Richardson): 4.49;"), std::string::npos)
      << to_sentences(study);
  study.rows.back().max_overlap = 3e-2;
  EXPECT_NE(to_sentences(study).find("overlap does not get there: with overlap, 1/120 s the "
                                     "residual is 2.0e-04, the overlap 3.0e-02"),
            std::string::npos)
      << to_sentences(study);
  study.rows.front().rest->height.spread = 1;  // no unique end: nothing to extrapolate
  EXPECT_EQ(to_sentences(study).find("Richardson"), std::string::npos);
}

TEST(RestText, AHeightIsExtrapolatedWhereTheEndIsKnownToBeUnique) {
  const auto extrapolates = [](const AccuracyStudy& study) {
    return to_sentences(study).find("Richardson") != std::string::npos;
  };
  AccuracyStudy study = made_up();
  ASSERT_TRUE(extrapolates(study));
  study.starts = 1;
  EXPECT_FALSE(extrapolates(study)) << "another seed may end elsewhere";
  study.drawn = false;
  EXPECT_TRUE(extrapolates(study));
  study.rows.front().rest->rest_time.reset();
  EXPECT_FALSE(extrapolates(study)) << "event has not ended";
}

TEST(RestText, StartsAreNamed) {
  AccuracyStudy study = made_up();
  const auto says = [&](const std::string& what) {
    return to_table(study).find(what) != std::string::npos;
  };
  EXPECT_TRUE(says("medians over 8 starts, seeds 7 to 14"));
  study.starts = 1;
  EXPECT_TRUE(says("medians over one start, seed 7"));
  study.drawn = false;
  EXPECT_TRUE(says("medians over one start, as the scene has no fill"));
}

TEST(RestText, TheTargetIsJudgedByTheLargerOfResidualAndOverlap) {
  const AccuracyStudy study = made_up();
  EXPECT_EQ(cheapest_within(study, 1e-3), 3U);
  EXPECT_EQ(cheapest_within(study, 5e-2), 2U) << "its residual is small, its overlap counts";
  EXPECT_EQ(cheapest_within(study, 1e-4), 0U);
  EXPECT_EQ(cheapest_within(study, 1e-6), std::nullopt);
}

TEST(RestText, EveryFormHasTheFigures) {
  const AccuracyStudy study = made_up();
  EXPECT_NE(to_table(study).find("medians over 8 starts, seeds 7 to 14"), std::string::npos);
  EXPECT_NE(to_table(study).find("5.0e-02  8.0e-02"), std::string::npos) << to_table(study);
  const auto json = nlohmann::json::parse(to_json(study));
  EXPECT_EQ(json["reference"]["method"], "equilibrium");
  for (const auto& row : json["rows"]) {
    for (const char* name :
         {"equilibrium_residual", "creep", "kinetic_energy", "rest_time", "dissipation_error"}) {
      EXPECT_TRUE(row.contains(name)) << name;
      EXPECT_TRUE(row.contains(std::string(name) + "_spread")) << name;
    }
    EXPECT_TRUE(row["position_error"].is_null());
    EXPECT_TRUE(row["horizon"].is_null());
  }
  EXPECT_EQ(json["rows"][1]["equilibrium_residual"], 5e-2);
  EXPECT_EQ(json["rows"][1]["equilibrium_residual_spread"], 2.5e-2);
  EXPECT_NE(to_csv(study).find(",equilibrium_residual,"), std::string::npos);
  EXPECT_NE(to_csv(study).find(",8,0.05,0.025,"), std::string::npos) << to_csv(study);
  const std::string script = gnuplot_script(study, true);
  EXPECT_NE(script.find("0.005 0.05\n"), std::string::npos) << script;
  EXPECT_NE(script.find("0.005 0.08\n"), std::string::npos) << "overlaps too";
}

}  // namespace
}  // namespace carom::rest_study_test
