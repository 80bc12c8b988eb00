// What conflict groups know of each ball in a window.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "solvers/event/groups/tracks.hpp"
#include "solvers/event/physics.hpp"

namespace carom::event::tracks_test {
namespace {

/// A ball at (-2, 0) that flies right at a speed of 2, and a fixed one at (3, 1), of radius 0.5, in
/// a box of 8 by 6.
class TracksOfTwo : public testing::Test {
 protected:
  static std::shared_ptr<const Motion<Ballistic>> motion() {
    Box box;
    box.width = 8;
    box.height = 6;
    box.origin = Box::Origin::center;
    const Species free;
    Species fixed;
    fixed.inverse_mass = 0;
    const Rules rules{Domain(box, true), FixedTimeClock(0.5), {0, 0}, true, 1, 1, {free, fixed}};
    return std::make_shared<const Motion<Ballistic>>(rules);
  }
  static std::vector<Disk> disks() {
    std::vector<Disk> both(2);
    both[0].x = -2;
    both[0].vx = 2;
    both[1].x = 3;
    both[1].y = 1;
    both[1].species = 1;
    return both;
  }
  [[nodiscard]] FixedTime ticks(double seconds) const {
    return motion_->rules().scale.ticks(seconds);
  }

  const std::shared_ptr<const Motion<Ballistic>> motion_ = motion();
  Tracks<Ballistic> tracks_{motion_};
  const double lost_ = tracks_.reset(disks(), 0, {}, {});
};

TEST_F(TracksOfTwo, KnowWhatMovesAndWhatIsFixed) {
  EXPECT_EQ(lost_, 0);
  EXPECT_EQ(tracks_.size(), 2U);
  EXPECT_EQ(tracks_.movers(), std::vector<Index>{0});
  EXPECT_EQ(tracks_.fixed(), (std::vector<char>{0, 1}));
  EXPECT_EQ(tracks_.radii(), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(tracks_.last(1).flight.start, Ballistic::Clock::ever());
}

TEST_F(TracksOfTwo, AreBoxedByWhatTheCentreSweepsInTheWindow) {
  tracks_.set_box(0, 0, ticks(1.5));
  EXPECT_NEAR(tracks_[0].box.centre[0], -0.5, 1e-6);  // from -2 to 1
  EXPECT_NEAR(tracks_[0].box.half[0], 1.5, 1e-5);
  EXPECT_GE(tracks_[0].box.half[0], 1.5);
  EXPECT_NEAR(tracks_[0].box.half[1], 0, 1e-9);
  EXPECT_EQ(tracks_[1].box.centre[0], 3);
  EXPECT_EQ(tracks_[1].box.half[0], 0);
}

TEST_F(TracksOfTwo, LeaveTheirRegionWhenTheySweepMoreThanItsMargin) {
  tracks_.set_regions(1);
  tracks_.set_box(0, 0, ticks(0.4));
  EXPECT_TRUE(tracks_.inside_region(0));
  tracks_.set_box(0, 0, ticks(0.6));
  EXPECT_FALSE(tracks_.inside_region(0));
  EXPECT_TRUE(tracks_.inside_region(1));
}

// It is at the wall, 3.5 from the middle, after 5.5 / 2 s.
TEST_F(TracksOfTwo, FlyOnUntilTheyMeetAWall) {
  EXPECT_TRUE(tracks_.flies_on(0, ticks(2.74)));
  EXPECT_FALSE(tracks_.flies_on(0, ticks(2.76)));
}

TEST_F(TracksOfTwo, BeginAWindowWithTheFlightThatTheLastOneEndedWith) {
  Segment<Ballistic> next = tracks_[0].first;
  next.flight.start = ticks(1);
  next.flight.vx = -1;
  tracks_[0].path.push_back(next);
  EXPECT_EQ(tracks_.begin(0).first.flight.vx, -1);
  EXPECT_EQ(tracks_[0].path.size(), 1U);
  tracks_.rebase(ticks(1));
  EXPECT_EQ(tracks_.last(0).flight.start, 0);
  EXPECT_EQ(tracks_.last(1).flight.start, Ballistic::Clock::ever());
}

// One ball of two that can move, of diameter 1.
TEST_F(TracksOfTwo, TellHowFastTheBallsAreThatMove) {
  const Spacing spacing = tracks_.spacing();
  EXPECT_EQ(spacing.diameter, 1);
  EXPECT_EQ(spacing.speed, 2);
}

}  // namespace
}  // namespace carom::event::tracks_test
