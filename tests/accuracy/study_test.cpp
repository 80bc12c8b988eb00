// Scenes in which the right answer of every column is known in closed form.
#include <gtest/gtest.h>

#include <algorithm>

#include "accuracy/samples.hpp"
#include "accuracy/scenes.hpp"
#include "carom/simulation.hpp"

namespace carom::study_test {
namespace {

using accuracy::kLongestStep;
using accuracy::kSteps;
using test::HeadOn;
using test::study_of;

std::vector<AccuracyRow> rows_of(const AccuracyStudy& study, Method method) {
  std::vector<AccuracyRow> rows;
  std::copy_if(study.rows.begin(), study.rows.end(), std::back_inserter(rows),
               [&](const AccuracyRow& row) { return row.method == method; });
  return rows;
}

TEST(Study, EveryColumnOfTwoDisksThatMeetHeadOnIsRight) {
  const AccuracyStudy study = study_of(HeadOn::scene(), HeadOn::kTime);
  EXPECT_EQ(study.time, HeadOn::kTime);
  EXPECT_EQ(study.balls, 2U);
  EXPECT_EQ(study.smallest_radius, HeadOn::kRadius);
  EXPECT_EQ(study.reference.ball_ball, 1U);
  EXPECT_EQ(study.reference.ball_wall, 0U);
  EXPECT_FALSE(study.reference.holds_until);

  const auto overlap = rows_of(study, Method::overlap);
  ASSERT_EQ(overlap.size(), static_cast<std::size_t>(kSteps)) << study.sequence_end;
  double step = kLongestStep;
  for (const AccuracyRow& row : overlap) {
    SCOPED_TRACE(step);
    ASSERT_EQ(row.step, step);
    EXPECT_EQ(row.failure, "");
    // The disks are moved apart to where they touched, and fly back late.
    const double late = HeadOn::delay(step);
    ASSERT_TRUE(row.position_error);
    EXPECT_NEAR(*row.position_error, late, 1e-10);
    EXPECT_NEAR(row.max_overlap, 2 * late / HeadOn::kRadius, 1e-10);
    ASSERT_TRUE(row.energy_error);
    EXPECT_LE(*row.energy_error, 1e-15);
    EXPECT_EQ(row.ball_ball, 1U);
    EXPECT_EQ(row.ball_wall, 0U);
    if (late > HeadOn::kRadius / 100) {
      ASSERT_TRUE(row.horizon);
      EXPECT_NEAR(*row.horizon, HeadOn::kTouch + late, 1e-10);
      EXPECT_NEAR(row.horizon_resolution, step, 1e-10) << "it was seen at the step before";
    } else {
      EXPECT_FALSE(row.horizon);
    }
    EXPECT_GT(row.seconds, 0);
    EXPECT_LE(row.fastest, row.quartiles[0]);
    EXPECT_LE(row.quartiles[0], row.seconds);
    EXPECT_LE(row.seconds, row.quartiles[1]);
    EXPECT_LE(row.quartiles[1], row.slowest);
    EXPECT_GE(row.repeats, 3U);
    step /= 2;
  }
  EXPECT_NEAR(*overlap.back().step, 1.0 / 30720, 1e-20);

  const auto event = rows_of(study, Method::event);
  ASSERT_EQ(event.size(), 3U);
  EXPECT_EQ(event[0].digits, 16);
  EXPECT_EQ(event[1].digits, 34);
  EXPECT_EQ(event[2].digits, 50);
  EXPECT_LE(event[0].position_error.value_or(1), 1e-14);
  EXPECT_LE(event[1].position_error.value_or(1), 1e-32);
  EXPECT_LE(event[2].position_error.value_or(1), 1e-48);
  EXPECT_EQ(study.reference.digits, 100);
  EXPECT_EQ(study.reference.checked_digits, 50);
  EXPECT_LE(study.reference.difference, 1e-48);
  EXPECT_EQ(event[0].ball_ball, 1U);
  EXPECT_EQ(event[0].max_overlap, 0);
  EXPECT_FALSE(event[0].horizon);
}

TEST(Study, TheHorizonIsWhenTheRunIsLostHoweverRarelyItIsCompared) {
  // Eight times as long, so that samples are far apart: what is seen must not move.
  const AccuracyStudy study = study_of(HeadOn::scene(), 8 * HeadOn::kTime);
  const auto overlap = rows_of(study, Method::overlap);
  ASSERT_FALSE(overlap.empty());
  int lost = 0;
  for (const AccuracyRow& row : overlap) {
    const double late = HeadOn::delay(*row.step);
    if (!(late > HeadOn::kRadius / 100)) continue;
    ++lost;
    ASSERT_TRUE(row.horizon);
    EXPECT_LE(row.horizon_resolution, std::max(*row.step, 1.0 / 300) * (1 + 1e-9));
    EXPECT_GE(*row.horizon, HeadOn::kTouch);
    EXPECT_LE(*row.horizon - row.horizon_resolution, HeadOn::kTouch + late + 1e-9);
  }
  EXPECT_GE(lost, 2);
}

TEST(Study, TheWayRoundAPeriodicAxisIsTheShorterOne) {
  // One ball flies round and is exactly on the side at the end: seen at either, it is there.
  Scene scene;
  scene.box.width = 4;
  scene.box.periodic = {true, true};
  Ball ball;
  ball.position = {1, 5};
  ball.velocity = {3, 0};
  scene.balls.push_back(ball);
  const AccuracyStudy study = study_of(scene, 5);
  for (const AccuracyRow& row : study.rows) {
    if (!row.failure.empty()) continue;
    ASSERT_TRUE(row.position_error);
    EXPECT_LE(*row.position_error, 1e-10);
    EXPECT_FALSE(row.horizon);
  }
}

TEST(Study, TheRecommendedRunIsTheCheapestThatMeetsTheTarget) {
  AccuracyRequest request;
  request.time = HeadOn::kTime;
  request.share = 20;
  for (const double target : {0.1, 1e-3, 1e-9}) {
    request.target = target;
    const AccuracyStudy study = study_accuracy(HeadOn::scene(), request);
    ASSERT_TRUE(study.recommended);
    const AccuracyRow& chosen = study.rows[*study.recommended];
    EXPECT_LE(chosen.position_error.value_or(1), target);
    for (const AccuracyRow& row : study.rows) {
      if (!row.failure.empty() || row.position_error.value_or(1) > target) continue;
      // Cheaper is only a run with more digits whose time cannot be told apart from that of some
      // run with as many as the chosen one.
      const bool tied =
          row.digits > chosen.digits &&
          std::any_of(study.rows.begin(), study.rows.end(), [&](const AccuracyRow& other) {
            return other.failure.empty() && other.digits == chosen.digits &&
                   other.position_error.value_or(1) <= target &&
                   other.quartiles[0] <= row.quartiles[1];
          });
      EXPECT_TRUE(chosen.seconds <= row.seconds || tied) << row.digits << " digits";
    }
    // Run again, it meets the target: the exact places are known.
    Scene again = HeadOn::scene();
    again.solver.method = chosen.method;
    again.solver.digits = chosen.digits;
    if (chosen.step) again.solver.step = *chosen.step;
    Simulation simulation(again);
    simulation.advance_to(HeadOn::kTime);
    const double left = 3 + HeadOn::kTouch - (HeadOn::kTime - HeadOn::kTouch);
    EXPECT_LE(std::abs(simulation.state()[0].position.x() - left), target * (1 + 1e-9));
  }
}

TEST(Study, OtherCrewsAddTheSameRunsWithTheSameErrors) {
  const AccuracyStudy study =
      study_of(HeadOn::scene(), HeadOn::kTime, {{false, 1}, {false, 2}, {true, 1}});
  std::vector<AccuracyRow> added(study.rows.begin() + 3 + kSteps, study.rows.end());
  ASSERT_EQ(added.size(), 4U);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(added[i].method, Method::event);
    EXPECT_EQ(added[i + 1].method, Method::overlap);
    EXPECT_DOUBLE_EQ(added[i + 1].step.value_or(0), 1.0 / 240);
  }
  for (const AccuracyRow& row : added) {
    EXPECT_EQ(row.failure, "");
    EXPECT_EQ(row.workers, 2U);
    const auto base = std::find_if(study.rows.begin(), study.rows.end(), [&](const auto& other) {
      return other.method == row.method && other.step == row.step && other.digits == row.digits;
    });
    EXPECT_EQ(row.position_error, base->position_error);
    EXPECT_EQ(row.horizon, base->horizon);
  }
  EXPECT_FALSE(added[0].per_ball);
  EXPECT_TRUE(added[2].per_ball);
}

TEST(Study, NothingAtAllAndNoTimeAtAllHaveNoErrors) {
  for (const bool empty : {true, false}) {
    Scene scene = HeadOn::scene();
    if (empty) scene.balls.clear();
    const AccuracyStudy study = study_of(scene, empty ? 1 : 0);
    for (const AccuracyRow& row : study.rows) {
      if (!row.failure.empty()) continue;
      EXPECT_EQ(row.position_error, 0);
      EXPECT_FALSE(row.horizon);
    }
    EXPECT_EQ(study.reference.ball_ball, 0U);
  }
}

TEST(Study, TheScriptIsObeyedAtItsSimulatedTimes) {
  // Paused from 1 to 2 on the frame clock; removed at 2.5 on it, 1.5 simulated: before they meet.
  Scene scene = HeadOn::scene();
  scene.script = {{1, command::Pause{}},
                  {2, command::Resume{}},
                  {2.5, command::Remove{1}},
                  {3.5, command::Quit{}}};
  const AccuracyStudy study = study_of(scene, 10);
  EXPECT_EQ(study.time, 2.5);
  EXPECT_EQ(study.reference.ball_ball, 0U);
  for (const AccuracyRow& row : study.rows) {
    if (!row.failure.empty()) continue;
    EXPECT_EQ(row.ball_ball, 0U);
    EXPECT_LE(row.position_error.value_or(1), 1e-10);
  }
}

TEST(Study, ARunThatTakesMoreThanItsShareEndsTheLadderAndSaysSo) {
  AccuracyRequest request;
  request.time = 30;
  request.share = 1e-4;
  const AccuracyStudy study = study_accuracy(HeadOn::scene(), request);
  EXPECT_LT(rows_of(study, Method::overlap).size(), static_cast<std::size_t>(kSteps));
  EXPECT_NE(study.sequence_end.find("time limit"), std::string::npos) << study.sequence_end;
}

TEST(Study, EveryRunIsCountedAndToldAndAStopKeepsWhatIsDone) {
  AccuracyRequest request;
  request.time = HeadOn::kTime;
  request.share = 20;
  std::size_t rows = 0;
  std::vector<AccuracyProgress> told;
  request.row_done = [&](const AccuracyRow&) { ++rows; };
  request.progress = [&](const AccuracyProgress& progress) { told.push_back(progress); };
  request.stopped = [&] { return rows == 5; };
  const AccuracyStudy study = study_accuracy(HeadOn::scene(), request);
  EXPECT_TRUE(study.stopped);
  EXPECT_EQ(study.rows.size(), 5U);
  EXPECT_EQ(study.runs, static_cast<std::size_t>(kSteps) + 3);
  ASSERT_FALSE(told.empty());
  std::size_t run = 0;
  for (const AccuracyProgress& each : told) {
    EXPECT_GE(each.run, run) << "they come in order";
    run = each.run;
    EXPECT_EQ(each.runs, static_cast<std::size_t>(kSteps) + 3);
    EXPECT_GE(each.left, 0);
    EXPECT_LE(each.part, 1);
  }
  EXPECT_EQ(run, 5U);
  EXPECT_EQ(told.front().what, "reference");
}

}  // namespace
}  // namespace carom::study_test
