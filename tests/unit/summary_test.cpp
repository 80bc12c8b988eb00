// What the summary of a run says beside its numbers.
#include "summary.hpp"

#include <gtest/gtest.h>

#include <string>

namespace carom::summary_test {
namespace {

Report run_of(std::size_t workers, double computing, double waiting) {
  Report report;
  report.workers = workers;
  report.measurements.computing = computing;
  report.measurements.waiting = waiting;
  return report;
}

bool says(const Report& report, const std::string& words) {
  return to_summary(report).find(words) != std::string::npos;
}

// Seen to fail: without the words, and said of a run that shared its work.
TEST(Summary, SaysWhereWorkersMostlyWaited) {
  const std::string advice = "--workers 1 gives the same bits faster";
  EXPECT_TRUE(
      says(run_of(200, 0.03, 0.62),
           "200: computing 0.03 s, waiting 0.62 s; --workers 1 gives the same bits faster"));
  EXPECT_FALSE(says(run_of(2, 3.1, 0.1), advice));
  EXPECT_FALSE(says(run_of(2, 0.0001, 0.001), advice));
  EXPECT_FALSE(says(run_of(1, 0, 0), advice));
}

TEST(Summary, SaysWhyOverlapWasChosenForAPile) {
  Report report = run_of(1, 0, 0);
  EXPECT_FALSE(says(report, kPilesUp));
  report.piles_up = true;
  EXPECT_TRUE(says(report, kPilesUp));
}

// Seen to fail: without the row.
TEST(Summary, PassesOnTheWarning) {
  Report report = run_of(1, 0, 0);
  EXPECT_FALSE(says(report, "warning"));
  report.warning = "balls overlapped";
  EXPECT_TRUE(says(report, "warning                    balls overlapped"));
}

// What impacts take is no error.
TEST(Summary, BooksLosses) {
  Report report = run_of(1, 0, 0);
  report.measurements.energy_initial = 20;
  report.measurements.energy_input = 2;
  report.measurements.energy_dissipated = 12;
  report.measurements.energy_final = 10;
  EXPECT_TRUE(says(report, "10 (initially 20, input 2, dissipated 12)"));
  EXPECT_TRUE(says(report, "energy error               0.00e+00 relative"));
  report.measurements.energy_final = 9;
  EXPECT_TRUE(says(report, "energy error               5.00e-02 relative"));
}

}  // namespace
}  // namespace carom::summary_test
