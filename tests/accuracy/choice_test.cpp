#include <gtest/gtest.h>

#include "carom/accuracy.hpp"

namespace carom::choice_test {
namespace {

AccuracyRow row(double seconds, double error) {
  AccuracyRow row;
  row.seconds = seconds;
  row.position_error = error;
  return row;
}

TEST(Choice, ARunIsABestChoiceWhereNoOtherIsBothCheaperAndBetter) {
  AccuracyStudy study;
  study.rows = {row(1, 1e-1), row(2, 1e-2), row(3, 1e-2), row(2.5, 1e-3), row(0.5, 1e-12)};
  EXPECT_EQ(best_choices(study), (std::vector<bool>{false, false, false, false, true}));
  study.rows.back().failure = "it failed";
  EXPECT_EQ(best_choices(study), (std::vector<bool>{true, true, false, true, false}));
}

TEST(Choice, TheCheapestWithinATargetIsAmongTheRunsThatWork) {
  AccuracyStudy study;
  study.rows = {row(1, 1e-1), row(2, 1e-2), row(3, 1e-3), row(4, 0), row(0.1, 0)};
  study.rows[4].failure = "it failed";
  EXPECT_EQ(cheapest_within(study, 1), 0U);
  EXPECT_EQ(cheapest_within(study, 1e-2), 1U);
  EXPECT_EQ(cheapest_within(study, 9e-4), 3U);
  study.rows[3].position_error.reset();
  EXPECT_EQ(cheapest_within(study, 9e-4), std::nullopt);
}

TEST(Choice, TimesThatCannotBeToldApartGoToFewerDigits) {
  AccuracyStudy study;
  study.rows = {row(1.1, 0), row(1, 0)};
  study.rows[0].quartiles = {0.9, 1.2};
  study.rows[1].quartiles = {0.95, 1.05};
  study.rows[1].digits = 34;
  EXPECT_EQ(cheapest_within(study, 1e-9), 0U);
  EXPECT_EQ(best_choices(study), (std::vector<bool>{true, false}));
  study.rows[0].quartiles = {1.06, 1.2};  // now they can
  EXPECT_EQ(cheapest_within(study, 1e-9), 1U);
  EXPECT_EQ(best_choices(study), (std::vector<bool>{false, true}));
}

TEST(Choice, OfTiesWithAsFewDigitsTheCheapestIsNamed) {
  AccuracyStudy study;
  study.rows = {row(1.2, 0), row(1.1, 0), row(1, 0)};
  for (AccuracyRow& each : study.rows) each.quartiles = {0.9, 1.3};
  study.rows[2].digits = 34;
  EXPECT_EQ(cheapest_within(study, 1e-9), 1U);
}

TEST(Choice, WhereEveryRunIsLostTheyAreJudgedByHowLongTheyWereNot) {
  AccuracyStudy study;
  study.rows = {row(1, 5), row(2, 3), row(3, 7)};
  study.rows[0].horizon = 0.5;
  study.rows[1].horizon = 0.4;
  EXPECT_FALSE(study.judged_by_horizon());
  study.rows[2].horizon = 0.9;
  EXPECT_TRUE(study.judged_by_horizon());
  EXPECT_EQ(best_choices(study), (std::vector<bool>{true, false, true}));
}

}  // namespace
}  // namespace carom::choice_test
