#include "view/paint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>

#include "unit/painted.hpp"
#include "view/camera.hpp"
#include "view/disk.hpp"
#include "view/encoder.hpp"
#include "view/text_screen.hpp"

namespace carom::paint_test {
namespace {

int count(const Canvas& canvas, Ink ink) {
  return static_cast<int>(std::count_if(canvas.cells.begin(), canvas.cells.end(),
                                        [ink](const Cell& cell) { return cell.ink == ink; }));
}

TEST(Paint, CoversTheAreaOfADiskToSampling) {
  std::vector<Coverage> coverage;
  for (const double radius : {0.6, 1.0, 2.3, 7.0, 30.0}) {
    for (const double shift : {0.0, 0.21, 0.5, 0.77}) {
      const Ellipse disk{40 + shift, 20 + shift / 3, 2 * radius, radius};
      const CellRange range = cells_of(disk, {-100, -100, 200, 200});
      cover(disk, range, coverage);
      double samples = 0;
      for (const Coverage& cell : coverage) samples += cell.total();
      const double area = std::numbers::pi * disk.across * disk.down;
      // A count of lattice points is off by no more than the boundary crosses.
      const double boundary = 4 * (disk.across + disk.down) / Coverage::kSamples;
      EXPECT_NEAR(samples / (4 * Coverage::kFull), area, boundary / 2 + 0.02) << radius << shift;
    }
  }
}

TEST(Paint, CoversNoCellOutsideTheDiskAndEveryCellWithin) {
  std::vector<Coverage> coverage;
  const Ellipse disk{20.3, 10.1, 8, 4};
  const CellRange range = cells_of(disk, {0, 0, 80, 24});
  cover(disk, range, coverage);
  auto cell = coverage.begin();
  for (int row = range.top; row < range.bottom; ++row) {
    for (int column = range.left; column < range.right; ++column, ++cell) {
      double nearest = 2;
      double farthest = 0;
      for (int i = 0; i <= 10; ++i) {
        for (int j = 0; j <= 10; ++j) {
          const double x = (column + i / 10.0 - disk.x) / disk.across;
          const double y = (row + j / 10.0 - disk.y) / disk.down;
          nearest = std::min(nearest, x * x + y * y);
          farthest = std::max(farthest, x * x + y * y);
        }
      }
      if (farthest <= 1) {
        EXPECT_EQ(cell->total(), 4 * Coverage::kFull);
      }
      if (nearest > 1.05) {
        EXPECT_EQ(cell->total(), 0);
      }
    }
  }
}

TEST(Paint, KeepsTheProportionsOfTheBoxToACellAndCentresIt) {
  for (const auto& [columns, rows] : {std::pair{80, 24}, {300, 100}, {20, 8}, {50, 50}}) {
    for (const double width : {5.0, 10.0, 20.0, 40.0}) {
      Box box;
      box.width = width;
      const Camera camera(box, columns, rows);
      EXPECT_LE(camera.columns() + 2, columns);
      EXPECT_LE(camera.rows() + 2, rows);
      // Fills the room one way or the other, and is right to half a cell the other way.
      EXPECT_TRUE(camera.columns() + 2 == columns || camera.rows() + 2 == rows);
      const double scale = std::min((columns - 2) / width, 2 * (rows - 2) / box.height);
      EXPECT_NEAR(camera.columns(), scale * width, 0.5 + 1e-9);
      EXPECT_NEAR(camera.rows(), scale * box.height / 2, 0.5 + 1e-9);
      EXPECT_LE(std::abs(2 * camera.left() + camera.columns() - columns), 1);
      EXPECT_LE(std::abs(2 * camera.top() + camera.rows() - rows), 1);
    }
  }
}

TEST(Paint, MapsTheSidesOfACentredBoxOntoTheBorder) {
  Box box;
  box.origin = Box::Origin::center;
  const Camera camera(box, 80, 24);
  EXPECT_DOUBLE_EQ(camera.x(-10), camera.left());
  EXPECT_DOUBLE_EQ(camera.x(10), camera.left() + camera.columns());
  EXPECT_DOUBLE_EQ(camera.y(5), camera.top());
  EXPECT_DOUBLE_EQ(camera.y(-5), camera.top() + camera.rows());
}

TEST(Paint, DrawsABallAcrossAPeriodicSideOnBothSides) {
  Frame frame = box_with({ball_at(0, 0, 1)});
  frame.box.periodic = {true, true};
  const Canvas canvas = painted(frame);
  const Camera camera(frame.box, 80, 24);
  const int right = camera.left() + camera.columns() - 1;
  const int bottom = camera.top() + camera.rows() - 1;
  for (const int column : {camera.left(), right}) {
    for (const int row : {camera.top(), bottom}) {
      EXPECT_EQ(canvas.at(column, row).ink, Ink::ball) << column << ' ' << row;
    }
  }
  const int whole = count(painted(box_with({ball_at(10, 5, 1)})), Ink::ball);
  EXPECT_NEAR(count(canvas, Ink::ball), whole, 4);
}

TEST(Paint, PutsABallThatHasNotBeenWrappedYetIntoThePeriodicBox) {
  Frame frame = box_with({ball_at(3, 5)});
  frame.box.periodic = {true, false};
  Frame beyond = frame;
  beyond.balls[0].position.x() += 40;
  EXPECT_EQ(to_text(painted(frame), 0, 0), to_text(painted(beyond), 0, 0));
}

TEST(Paint, ShowsSolidPeriodicAndOpenSidesDifferently) {
  Frame frame = box_with({});
  EXPECT_EQ(count(painted(frame), Ink::periodic), 0);
  EXPECT_GT(count(painted(frame), Ink::wall), 150);
  frame.box.periodic = {true, false};
  Canvas canvas = painted(frame);
  const Camera camera(frame.box, 80, 24);
  EXPECT_EQ(canvas.at(0, 12).character, ':');
  EXPECT_EQ(canvas.at(40, camera.top() - 1).character, '-');
  frame.box.periodic = {false, true};
  frame.walls = false;
  canvas = painted(frame);
  EXPECT_EQ(canvas.at(40, camera.top() - 1).character, '~');
  EXPECT_GT(count(canvas, Ink::open), 8);
}

TEST(Paint, LetsABallLeaveThroughAnOpenSideButNotThroughAWall) {
  const std::vector<FrameBall> leaving = {ball_at(0, 5, 1)};
  EXPECT_EQ(painted(box_with(leaving, true)).at(0, 12).ink, Ink::wall);
  EXPECT_EQ(painted(box_with(leaving, false)).at(0, 12).ink, Ink::ball);
}

TEST(Paint, UsesTheGlyphOfTheSceneAndTellsFixedBallsApart) {
  std::vector<FrameBall> balls = {ball_at(5, 5), ball_at(10, 5), ball_at(15, 5)};
  balls[0].glyph = 'W';
  balls[1].fixed = true;
  const std::string text = to_text(painted(box_with(balls)), 0, 0);
  EXPECT_NE(text.find("WW"), std::string::npos);
  EXPECT_NE(text.find("##", text.find('\n')), std::string::npos);
  EXPECT_EQ(count(painted(box_with(balls)), Ink::fixed), 8);
}

TEST(Paint, ShowsEveryBallHoweverSmall) {
  for (const double radius : {1e-9, 0.01, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4}) {
    for (int i = 0; i < 60; ++i) {
      for (const char glyph : {'\0', '*'}) {
        FrameBall ball = ball_at(5 + i * 0.037, 5 + i * 0.053, radius);
        ball.glyph = glyph;
        EXPECT_GE(count(painted(box_with({ball})), Ink::ball), 1) << radius << ' ' << i;
      }
    }
  }
}

TEST(Paint, HeatsFastBallsMoreThanSlowOnes) {
  std::vector<FrameBall> balls = {ball_at(5, 5), ball_at(10, 5), ball_at(15, 5)};
  balls[0].speed = 0;
  balls[1].speed = 1;
  balls[2].speed = 1e300;
  Canvas canvas = painted(box_with(balls));
  EXPECT_EQ(canvas.at(20, 12).heat, 0);
  EXPECT_GT(canvas.at(59, 12).heat, 0.5F);
  balls[2].speed = 2;
  canvas = painted(box_with(balls));
  EXPECT_GT(canvas.at(40, 12).heat, 0);
  EXPECT_GT(canvas.at(59, 12).heat, canvas.at(40, 12).heat);
}

TEST(Paint, SurvivesAnyCanvasAndAnyPosition) {
  const double huge = std::numeric_limits<double>::max();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const bool periodic : {false, true}) {
    for (const bool walls : {false, true}) {
      Frame frame = box_with({ball_at(3, 3), ball_at(huge, -huge), ball_at(nothing, 1),
                              ball_at(10, 5, 1e6), ball_at(0, 0, 1e-300)},
                             walls);
      frame.box.periodic = {periodic, periodic};
      frame.balls[0].speed = huge;
      for (int columns = 0; columns < 12; ++columns) {
        for (int rows = 0; rows < 6; ++rows) {
          for (const Cell& cell : painted(frame, columns, rows).cells) {
            EXPECT_TRUE(cell.character >= ' ' && cell.character <= '~');
          }
        }
      }
    }
  }
}

TEST(Paint, DumpsExactlyAsManyLinesAsRowsNoneLongerThanTheColumns) {
  const std::string text = to_text(painted(box_with({ball_at(3, 5)}), 33, 11), 7, 0.25);
  EXPECT_EQ(text.substr(0, text.find('\n')), "# frame 7 time 0.25");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 12);
  std::size_t begin = text.find('\n') + 1;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    EXPECT_LE(end - begin, 33U);
    begin = end + 1;
  }
}

TEST(Canvas, ShowsOneQuestionMarkForALetterBeyondAscii) {
  Canvas canvas(4, 1);
  canvas.write(-1, 0,
               "xa\xC3\xA9"
               "b\tz",
               Ink::status);
  std::string text;
  for (const Cell& cell : canvas.cells) append_utf8(cell.character, text);
  EXPECT_EQ(text, "a?b?");
}

}  // namespace
}  // namespace carom::paint_test
