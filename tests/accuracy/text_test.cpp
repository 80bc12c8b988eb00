// What a study says: the words, the plot in characters, and the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "accuracy_plot.hpp"
#include "accuracy_table.hpp"
#include "accuracy_words.hpp"
#include "carom/accuracy.hpp"
#include "export/accuracy_csv.hpp"
#include "export/accuracy_gnuplot.hpp"

namespace carom::text_test {
namespace {

AccuracyRow row(Method method, std::optional<double> step, int digits, double seconds,
                double error) {
  AccuracyRow row;
  row.method = method;
  row.step = step;
  row.digits = digits;
  row.seconds = row.fastest = row.slowest = seconds;
  row.quartiles = {seconds, seconds};
  row.cpu_seconds = seconds;
  row.repeats = 5;
  row.position_error = error;
  row.energy_error = 1e-16;
  row.ball_ball = 12;
  row.ball_wall = 3;
  return row;
}

/// Two seconds: event exact and cheap, overlap of first order.
AccuracyStudy made_up() {
  AccuracyStudy study;
  study.scene = "made, \"up\"";
  study.time = 2;
  study.balls = 7;
  study.smallest_radius = 0.5;
  study.reference.digits = 100;
  study.reference.checked_digits = 50;
  study.reference.difference = 3e-49;
  study.reference.ball_ball = 12;
  study.reference.ball_wall = 3;
  study.machine = {"a processor", 2, "a system", "a compiler"};
  study.rows.push_back(row(Method::event, std::nullopt, 16, 2e-3, 1e-15));
  study.rows.push_back(row(Method::event, std::nullopt, 34, 4e-2, 1e-33));
  double seconds = 1e-3;
  double step = 1.0 / 30;
  for (int rung = 0; rung < 4; ++rung) {
    study.rows.push_back(row(Method::overlap, step, 16, seconds, step));
    seconds *= 2;
    step /= 2;
  }
  study.rows[2].horizon = 0.25;
  study.rows[2].horizon_resolution = 1.0 / 30;
  return study;
}

TEST(Text, TheTableHasALineForEachRunAndMarksTheBest) {
  AccuracyStudy study = made_up();
  study.rows.push_back(study.rows.back());
  study.rows.back().failure = "it failed, and this is why";
  const std::string table = to_table(study);
  std::istringstream lines(table);
  std::vector<std::string> runs;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("event, ") != std::string::npos || line.find("overlap, ") != std::string::npos)
      runs.push_back(line);
  }
  ASSERT_EQ(runs.size(), study.rows.size()) << table;
  EXPECT_TRUE(runs[0].starts_with(" *  event, 16 digits")) << runs[0];
  EXPECT_NE(runs[0].find("1 ms"), std::string::npos) << "of each of two seconds";
  EXPECT_NE(runs[0].find("1.0e-15"), std::string::npos);
  EXPECT_TRUE(runs[0].ends_with("to the end"));
  EXPECT_TRUE(runs[1].starts_with(" *  event, 34 digits")) << runs[1];
  EXPECT_TRUE(runs[2].starts_with(" *  overlap, 1/30 s")) << runs[2];
  EXPECT_TRUE(runs[2].ends_with("0.25 s"));
  EXPECT_TRUE(runs[3].starts_with("    overlap, 1/60 s")) << runs[3];
  EXPECT_TRUE(runs[6].ends_with("it failed, and this is why"));
  EXPECT_NE(table.find("with 100 digits; reference error (100 against 50 digits): 3.0e-49"),
            std::string::npos);
  EXPECT_NE(table.find("collisions of the reference: 12 of balls, 3 with walls"),
            std::string::npos);
  EXPECT_NE(table.find("compared every 33.3 ms"), std::string::npos);
}

TEST(Text, TheSentenceNamesTheCheapestAndWhatTheOtherMethodCosts) {
  AccuracyStudy study = made_up();
  study.target = 1e-6;
  study.recommended = cheapest_within(study, 1e-6);
  EXPECT_EQ(to_sentences(study),
            "For 1e-06: event, 16 digits, 1 ms per simulated second; overlap does not reach it: at "
            "1/240 s its error is 4.2e-03 and it costs 4 times as much.\n"
            "\nPut into the scene:\n\n"
            "\"solver\": {\"method\": \"event\", \"digits\": 16},\n\"workers\": 1,\n");
  study.target = 0.1;
  study.recommended = cheapest_within(study, 0.1);
  EXPECT_EQ(to_sentences(study),
            "For 0.1: overlap, 1/30 s, 500 us per simulated second; event reaches it too, at 2 "
            "times the cost (event, 16 digits).\n"
            "\nPut into the scene:\n\n\"solver\": {\"method\": \"overlap\", \"step\": "
            "0.03333333333333333},\n\"workers\": 1,\n");
  study.rows.erase(study.rows.begin(), study.rows.begin() + 2);
  study.target = 1e-9;
  study.recommended = cheapest_within(study, 1e-9);
  EXPECT_EQ(to_sentences(study),
            "No run reaches 1e-09. Nearest with overlap: overlap, 1/240 s, 4.2e-03.\n");
}

TEST(Text, AThreadForEachBallHasItsPriceSaid) {
  AccuracyStudy study = made_up();
  study.rows.push_back(study.rows[3]);
  study.rows.back().per_ball = true;
  study.rows.back().workers = 7;
  study.rows.back().seconds *= 25;
  EXPECT_NE(to_sentences(study).find(
                "A thread per ball, overlap, 1/60 s: 25 times the time of 1 worker.\n"),
            std::string::npos)
      << to_sentences(study);
}

TEST(Text, WhereEveryRunIsLostTheSentenceSaysSo) {
  AccuracyStudy study = made_up();
  for (AccuracyRow& each : study.rows) each.horizon = 0.5;
  study.rows[1].horizon = 1.5;
  const std::string text = to_sentences(study);
  EXPECT_TRUE(text.starts_with("Chaotic: no run is known to be right until 2 s")) << text;
  EXPECT_NE(text.find("Right for longest: event, 34 digits, 1.5 s"), std::string::npos) << text;
}

TEST(Text, ThePlotHasAMarkForEachRunAndALineForEachMethod) {
  const std::string plot = to_plot(made_up());
  std::istringstream lines(plot);
  std::vector<std::string> rows;  // what stands right of the axis
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 10 && line[10] == '|') rows.push_back(line.substr(11));
  }
  ASSERT_EQ(rows.size(), 18U) << plot;
  const auto count = [&](char letter) {
    std::ptrdiff_t sum = 0;
    for (const std::string& row : rows) sum += std::count(row.begin(), row.end(), letter);
    return sum;
  };
  // The cheapest overlap and both of event are the best choices.
  EXPECT_EQ(count('O'), 1);
  EXPECT_EQ(count('o'), 3);
  EXPECT_EQ(count('E'), 2);
  EXPECT_EQ(count('e'), 0);
  EXPECT_GT(count('.'), 20) << "lines join them";
  // 0.5 ms is the left end, 20 ms the right one; 1 ms lies log 2 / log 40 of 63 between.
  EXPECT_EQ(rows.front()[0], 'O');
  EXPECT_EQ(rows[15][12], 'E') << plot;
  EXPECT_EQ(rows.back().size(), 64U);
  EXPECT_EQ(rows.back().back(), 'E') << "more digits than double's are at the lower edge";
  EXPECT_NE(plot.find("0 or less |"), std::string::npos);
  EXPECT_NE(plot.find(" 3.3e-02 |O"), std::string::npos);
  EXPECT_NE(plot.find(" 1e-3 "), std::string::npos);
}

TEST(Text, ThePlotOfEqualErrorsSpansADecade) {
  AccuracyStudy study = made_up();
  for (AccuracyRow& each : study.rows) {
    each.position_error = 1;
    each.digits = 16;
  }
  const std::string plot = to_plot(study);
  EXPECT_NE(plot.find(" 3.2e+00 |"), std::string::npos) << plot;
  EXPECT_EQ(plot.find("0 or less |"), std::string::npos);
  for (AccuracyRow& each : study.rows) each.position_error = 0;
  const std::string at_edge = to_plot(study);
  EXPECT_NE(at_edge.find("0 or less |"), std::string::npos);
  EXPECT_EQ(at_edge.find("e+00 |"), std::string::npos) << "there is nothing to number\n" << at_edge;
}

TEST(Text, RunsWithoutErrorAreDrawnOnALineOfTheirOwn) {
  AccuracyStudy study = made_up();
  study.rows[0].position_error = 0;
  const std::string script = gnuplot_script(study, true);
  // A decade below the least error that is not 0, and named on the axis.
  EXPECT_NE(script.find("0.001 1e-34\n"), std::string::npos) << script;
  EXPECT_NE(script.find("set ytics add (\"0 or less\" 1e-34)"), std::string::npos) << script;
  for (AccuracyRow& each : study.rows) each.position_error = 0;
  EXPECT_NE(gnuplot_script(study, true).find("0.001 0.1\n"), std::string::npos);
  EXPECT_EQ(gnuplot_script(made_up(), true).find("0 or less"), std::string::npos);
}

TEST(Text, WhereTheReferenceEndsFirstTheHorizonIsTheAnswer) {
  AccuracyStudy study = made_up();
  study.reference.holds_until = 1.25;
  for (AccuracyRow& each : study.rows) {
    each.position_error.reset();
    each.horizon = 0.5;
  }
  study.rows[1].horizon.reset();  // right for at least as long as the reference
  ASSERT_TRUE(study.judged_by_horizon());
  EXPECT_NE(to_sentences(study).find("Right for longest: event, 34 digits, 1.25 s"),
            std::string::npos);
  EXPECT_NE(to_plot(study).find("predictability horizon, s"), std::string::npos);
  EXPECT_NE(gnuplot_script(study, false).find("0.02 1.25\n"), std::string::npos);
}

TEST(Text, ABusyMachineIsSaid) {
  AccuracyStudy study = made_up();
  EXPECT_EQ(to_table(study).find("busy"), std::string::npos);
  for (AccuracyRow& each : study.rows) each.cpu_seconds = each.seconds / 2;
  EXPECT_NE(to_table(study).find("busy machine: the runs got 50 % of the processor"),
            std::string::npos);
  for (AccuracyRow& each : study.rows) each.cpu_seconds = 3 * each.seconds;  // several workers
  EXPECT_EQ(to_table(study).find("busy"), std::string::npos);
}

TEST(Text, NothingThatRanIsNoPlot) {
  AccuracyStudy study = made_up();
  for (AccuracyRow& each : study.rows) each.failure = "it failed";
  EXPECT_EQ(to_plot(study), "");
}

TEST(Text, TheCsvHasAsManyFieldsInEveryLineAndQuotesWhatNeedsIt) {
  AccuracyStudy study = made_up();
  study.rows[1].failure = "it failed";
  std::istringstream lines(to_csv(study));
  std::vector<std::size_t> fields;
  for (std::string line; std::getline(lines, line);) {
    std::size_t count = 1;
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (c == ',' && !quoted) ++count;
    }
    EXPECT_FALSE(quoted);
    fields.push_back(count);
  }
  ASSERT_EQ(fields.size(), study.rows.size() + 1);
  for (const std::size_t count : fields) EXPECT_EQ(count, fields.front());
  EXPECT_NE(to_csv(study).find(",\"made, \"\"up\"\"\",2,"), std::string::npos) << to_csv(study);
}

TEST(Text, TheJsonHasWhatIsPromised) {
  AccuracyStudy study = made_up();
  study.rows[1].failure = "it failed";
  study.target = 0.1;
  study.recommended = cheapest_within(study, 0.1);
  const auto json = nlohmann::json::parse(to_json(study));
  EXPECT_EQ(json["scene"], study.scene);
  EXPECT_EQ(json["time"], 2);
  EXPECT_EQ(json["reference"]["method"], "event");
  EXPECT_EQ(json["reference"]["digits"], 100);
  ASSERT_EQ(json["rows"].size(), study.rows.size());
  EXPECT_TRUE(json["rows"][0]["step"].is_null());
  EXPECT_TRUE(json["rows"][0]["horizon"].is_null());
  EXPECT_EQ(json["rows"][0]["seconds"], 2e-3);
  EXPECT_EQ(json["rows"][0]["seconds_per_simulated_second"], 1e-3);
  EXPECT_FALSE(json["rows"][0].contains("failed"));
  EXPECT_EQ(json["rows"][1]["failed"], "it failed");
  EXPECT_TRUE(json["rows"][1]["seconds"].is_null());
  EXPECT_EQ(json["rows"][2]["step"], 1.0 / 30);
  EXPECT_EQ(json["rows"][2]["horizon"], 0.25);
  for (const char* name :
       {"method", "step", "digits", "seconds", "seconds_per_simulated_second", "position_error",
        "energy_error", "max_overlap", "ball_ball", "ball_wall", "horizon"}) {
    for (const auto& each : json["rows"]) EXPECT_TRUE(each.contains(name)) << name;
  }
  EXPECT_EQ(json["recommended"], json["rows"][2]);
}

TEST(Text, GnuplotIsToldEveryRunThatHasAPlaceOnTheDrawing) {
  AccuracyStudy study = made_up();
  study.rows[3].failure = "it failed";
  const std::string script = gnuplot_script(study, true);
  EXPECT_TRUE(script.starts_with("set terminal pngcairo"));
  EXPECT_NE(script.find("0.001 1e-15\n"), std::string::npos) << script;
  EXPECT_NE(script.find("0.02 1e-33\n"), std::string::npos) << script;
  EXPECT_NE(script.find("0.0005 0.03333333333333333\n"), std::string::npos) << script;
  EXPECT_EQ(script.find("0.016666"), std::string::npos) << "a run that failed has none";
  EXPECT_NE(script.find("made, up (7 balls"), std::string::npos) << script;
}

}  // namespace
}  // namespace carom::text_test
