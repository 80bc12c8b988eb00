#include <gtest/gtest.h>

#include <vector>

#include "accuracy/row.hpp"
#include "accuracy/scenario.hpp"
#include "accuracy/study_plan.hpp"

namespace carom::accuracy::plan_test {
namespace {

const std::vector<AccuracyCrew> kCrews{{false, 1}, {false, 2}, {true, 1}};

StudyPlan plan_of(bool attraction = false) {
  Scenario scenario;
  if (attraction) scenario.start.effects.attraction.emplace();
  return {scenario, kCrews};
}

AccuracyRow row(Method method, std::optional<double> step) {
  return new_row({method, step, 16}, kCrews.front(), 5);
}

TEST(StudyPlan, HasTheExactMethodWithThreePrecisionsAndElevenSteps) {
  const StudyPlan plan = plan_of();
  ASSERT_EQ(plan.size(), 1U + 2U + 11U);
  EXPECT_EQ(plan[0].way.digits, 16);
  EXPECT_EQ(plan[1].way.digits, 34);
  EXPECT_EQ(plan[2].way.digits, 50);
  EXPECT_EQ(plan[3].way.step, 1.0 / 30);
  EXPECT_EQ(plan[13].way.step, 1.0 / 30720);
  // Both methods on each of two more crews.
  EXPECT_EQ(plan.expected(), 14U + 4U);
  // Under attraction the exact method has steps, too.
  EXPECT_EQ(plan_of(true).size(), 11U + 2U + 11U);
}

TEST(StudyPlan, ShorterStepsOfOneMethodAreLeftOut) {
  StudyPlan plan = plan_of(true);
  ASSERT_EQ(plan[4].way.method, Method::event);
  EXPECT_TRUE(plan.goes_on_with_shorter_steps(4));
  plan.leave_out_shorter_steps(4);
  EXPECT_FALSE(plan.goes_on_with_shorter_steps(4));
  EXPECT_EQ(plan.size(), 5U + 2U + 11U);
  EXPECT_FALSE(plan.goes_on_with_shorter_steps(5));  // more digits, no step
}

TEST(StudyPlan, OtherCrewsRunTheStepOfTheSceneOrTheNextShorterThatWorked) {
  StudyPlan plan = plan_of();
  std::vector<AccuracyRow> rows{row(Method::event, {}), row(Method::overlap, 0.04),
                                row(Method::overlap, 0.02), row(Method::overlap, 0.01)};
  rows[2].failure = "it failed";
  plan.add_other_crews(rows, 0.03);
  ASSERT_EQ(plan.size(), 14U + 4U);
  EXPECT_EQ(plan.expected(), plan.size());
  EXPECT_EQ(plan[14].same, 0U);
  EXPECT_EQ(plan[15].same, 3U);
  EXPECT_EQ(plan[15].crew.workers, 2U);
  EXPECT_TRUE(plan[17].crew.per_ball);
}

TEST(StudyRow, AWorkerForEachBallIsAsManyWorkersAsBalls) {
  EXPECT_EQ(new_row({}, {true, 1}, 7).workers, 7U);
  EXPECT_EQ(new_row({}, {true, 1}, 0).workers, 1U);
  EXPECT_EQ(new_row({}, {false, 3}, 7).workers, 3U);
}

TEST(StudyRow, SaysWhyNoShorterStepsAreTried) {
  AccuracyRow made = row(Method::overlap, 0.01);
  made.seconds = 2;
  EXPECT_EQ(why_last(made, "overlap", 2), "");
  EXPECT_EQ(why_last(made, "overlap", 1),
            "overlap took 2 s, and the time limit of a run is 1 s; --share raises it");
  made.failure = "it failed";
  EXPECT_EQ(why_last(made, "overlap", 5), "overlap: it failed");
}

}  // namespace
}  // namespace carom::accuracy::plan_test
