// The timeline of threads that a run writes, against its report.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "program/written.hpp"

namespace carom::trace_test {
namespace {

using test::Json;
using test::kOverlap;
using test::lossy;
using test::Written;

struct Slice {
  double begin;
  double end;
  std::string name;
};

TEST(Trace, NamesItsThreadsAndTheirSlicesNeverOverlap) {
  const Written run(lossy(kOverlap), {"trace"}, {"--workers", "3", "--trace-frames", "40"});
  const Json trace = Json::parse(run.text("trace"));
  EXPECT_EQ(trace["displayTimeUnit"], "ms");
  std::map<int, std::string> names;
  std::map<int, std::vector<Slice>> slices;
  for (const Json& event : trace["traceEvents"]) {
    EXPECT_EQ(event["pid"], 1);
    if (event["ph"] == "M" && event["name"] == "thread_name") {
      names[event["tid"]] = event["args"]["name"];
    } else if (event["ph"] == "X") {
      const double begin = event["ts"];
      slices[event["tid"]].push_back({begin, begin + double(event["dur"]), event["name"]});
    }
  }
  EXPECT_EQ(names, (std::map<int, std::string>{
                       {1, "control"}, {2, "worker 0"}, {3, "worker 1"}, {4, "worker 2"}}));
  ASSERT_EQ(slices.size(), 4U);
  EXPECT_EQ(slices[1].size(), 40U);
  std::set<std::string> seen;
  for (const auto& [thread, row] : slices) {
    double last = 0;
    for (const Slice& slice : row) {
      EXPECT_LE(last, slice.begin);
      EXPECT_LE(slice.begin, slice.end);
      last = slice.end;
      seen.insert(slice.name);
      if (thread == 1) {
        EXPECT_EQ(slice.name, "do_frame");
      }
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"do_frame", "wait do_frame", "wall_computation",
                                         "wait wall_computation", "pair_computation",
                                         "wait pair_computation", "wait frame_done"}));
  // A phase is computed while control waits for its frame.
  std::size_t frame = 0;
  for (const Slice& slice : slices[2]) {
    if (slice.name.starts_with("wait")) continue;
    while (frame + 1 < slices[1].size() && slices[1][frame].end < slice.begin) ++frame;
    EXPECT_GE(slice.begin, slices[1][frame].begin);
    EXPECT_LE(slice.end, slices[1][frame].end);
  }
}

TEST(Trace, AddsUpToThePhasesOfTheReport) {
  const Written run(lossy(kOverlap), {"trace"}, {"--workers", "2", "--trace-frames", "1000"});
  std::map<std::string, double> spent;  // of worker 0, microseconds
  double frames = 0;
  const Json trace = Json::parse(run.text("trace"));
  for (const Json& event : trace["traceEvents"]) {
    if (event["ph"] != "X") continue;
    if (event["tid"] == 1) frames += double(event["dur"]);
    if (event["tid"] == 2) spent[event["name"]] += double(event["dur"]);
  }
  double phases = 0;
  const Json report = run.report();
  for (const auto& [name, seconds] : report["phases"].items()) {
    const double all = double(seconds) * 1e6;
    phases += all;
    // A phase lasts from before the first worker begins until the last one has arrived.
    EXPECT_GT(spent[name], 0) << name;
    EXPECT_LE(spent[name], all * (1 + 1e-9) + 1) << name;
  }
  EXPECT_LE(phases, frames * (1 + 1e-9) + 1);
}

}  // namespace
}  // namespace carom::trace_test
