#include "solvers/event/impact_notes.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom::event::impact_notes_test {
namespace {

Impact line(std::size_t a, std::uint64_t event = 0, double lost = 0) {
  Impact impact;
  impact.a = a;
  impact.event = event;
  impact.energy_lost = lost;
  return impact;
}

Impact slide(std::size_t a, double time) {
  Impact impact;
  impact.a = a;
  impact.time = time;
  return impact;
}

/// As "event:a" each.
std::string listed(const ImpactLog& log) {
  std::string text;
  for (const Impact& each : log.impacts) {
    text += std::to_string(each.event) + ':' + std::to_string(each.a) + ' ';
  }
  return text;
}

TEST(ImpactNotes, KeepNothingWithoutALog) {
  ImpactNotes notes;
  EXPECT_FALSE(notes.wanted());
  notes.add(line(1));
  notes.add(std::vector<Impact>{line(2), line(3)});
  notes.add_slide(slide(4, 1));
  notes.tell_loss(0, 5);
  EXPECT_EQ(notes.lines(), 0U);
  ImpactLog log;
  notes.write_to(&log);
  notes.keep_slides();
  EXPECT_EQ(listed(log), "");
}

TEST(ImpactNotes, NumberJointImpactsByTheirFirstLine) {
  ImpactLog log;
  ImpactNotes notes;
  notes.write_to(&log);
  notes.add(line(1));
  notes.add({line(2, notes.next_event()), line(3, notes.next_event())});
  notes.add({line(4, notes.next_event()), line(5, notes.next_event())});
  EXPECT_EQ(listed(log), "0:1 2:2 2:3 4:4 4:5 ");
}

// What is left is what would have been noted without it.
TEST(ImpactNotes, TakeLinesBackAsIfTheyHadNotBeen) {
  const auto noted = [](bool single, bool joint) {
    ImpactLog log;
    ImpactNotes notes;
    notes.write_to(&log);
    const auto add_joint = [&notes](std::size_t a) {
      const std::uint64_t event = notes.next_event();
      notes.add({line(a, event), line(a + 1, event)});
    };
    add_joint(10);
    const std::size_t first = notes.lines();
    if (single) notes.add(line(1));
    const std::size_t second = notes.lines();
    if (joint) add_joint(20);
    const std::size_t after = notes.lines();
    add_joint(30);
    notes.add(line(2));
    std::vector<std::string> result{listed(log)};
    notes.take_back(second, after - second);
    notes.take_back(first, second - first);
    result.push_back(listed(log));
    return result;
  };
  const std::string neither = noted(false, false)[0];
  EXPECT_EQ(neither, "1:10 1:11 3:30 3:31 0:2 ");
  EXPECT_EQ(noted(true, true)[0], "1:10 1:11 0:1 4:20 4:21 6:30 6:31 0:2 ");
  EXPECT_EQ(noted(true, true)[1], neither);
  EXPECT_EQ(noted(true, false)[1], neither);
  EXPECT_EQ(noted(false, true)[1], neither);
}

TEST(ImpactNotes, TellALossWithTheFirstOfSeveralLines) {
  ImpactLog log;
  ImpactNotes notes;
  notes.write_to(&log);
  notes.add({line(1, 0, 8), line(2, 0, 1), line(3, 0, 2)});
  notes.tell_loss(1, 7);
  EXPECT_EQ(log.impacts[0].energy_lost, 8);
  EXPECT_EQ(log.impacts[1].energy_lost, 5);  // with the 2 of the other it makes 7
  EXPECT_EQ(log.impacts[2].energy_lost, 2);
  notes.tell_loss(3, 100);  // there is no line that could tell it
  EXPECT_EQ(log.impacts[2].energy_lost, 2);
}

TEST(ImpactNotes, PutSlidesDownWhenTheInstantIsOverButForThoseThatGoOn) {
  ImpactLog log;
  ImpactNotes notes;
  notes.write_to(&log);
  notes.add_slide(slide(1, 2));
  notes.add_slide(slide(1, 3));
  notes.add_slide(slide(2, 3));
  notes.take_back_slides(1, 3);
  EXPECT_EQ(listed(log), "");
  notes.keep_slides();
  ASSERT_EQ(listed(log), "0:1 0:2 ");
  EXPECT_EQ(log.impacts[0].time, 2);
  notes.keep_slides();
  EXPECT_EQ(listed(log), "0:1 0:2 ");
  notes.add_slide(slide(1, 5));
  notes.forget_slides();
  notes.keep_slides();
  EXPECT_EQ(listed(log), "0:1 0:2 ");
}

}  // namespace
}  // namespace carom::event::impact_notes_test
