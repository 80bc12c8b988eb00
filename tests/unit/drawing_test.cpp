// Trails, arrows and numbers, over the balls of a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "view/arrows.hpp"
#include "view/ball_numbers.hpp"
#include "view/trails.hpp"

namespace carom::drawing_test {
namespace {

/// A box of 38 by 18 cells inside its sides.
constexpr int kColumns = 40;
constexpr int kRows = 20;

Frame frame_of(const std::vector<Ball>& balls, double time = 0) {
  Frame frame;
  frame.time = time;
  frame.box = {38, 36};
  frame.walls = true;
  for (const Ball& ball : balls)
    frame.balls.push_back({ball.position, ball.radius, ball.velocity.norm(), ball.fixed, 0});
  return frame;
}

std::string row_of(const Canvas& canvas, int row) {
  std::string text;
  for (int column = 0; column < canvas.columns; ++column) {
    const char32_t sign = canvas.at(column, row).character;
    text += sign < 0x7F ? static_cast<char>(sign) : '?';
  }
  return text;
}

std::size_t count_of(const Canvas& canvas, Ink ink) {
  return static_cast<std::size_t>(
      std::count_if(canvas.cells.begin(), canvas.cells.end(),
                    [ink](const Cell& cell) { return cell.ink == ink; }));
}

TEST(Trails, JoinThePlacesWhereABallWasOnItsShortWay) {
  Trails trails;
  Ball ball{{5, 18.9}, {10, 0}};
  ball.radius = 0.5;
  trails.show(true);
  trails.add(frame_of({ball}, 0));
  ball.position = {15, 18.9};
  const Frame now = frame_of({ball}, 1);
  trails.add(now);
  Canvas canvas(kColumns, kRows);
  paint(now, canvas);
  trails.paint(now, canvas, {});
  // A cell is one wide and two high; columns 6 to 16 within the sides; the ball itself stays.
  EXPECT_EQ(row_of(canvas, 9).substr(5, 13), " ..........o ") << row_of(canvas, 9);
  EXPECT_EQ(count_of(canvas, Ink::trail), 10U);

  // Through a periodic side: two cells at each side and none in between.
  trails.show(true);
  ball.position = {36.5, 18.9};
  Frame first = frame_of({ball}, 2);
  first.box.periodic[0] = true;
  trails.add(first);
  ball.position = {1.5, 18.9};
  Frame second = frame_of({ball}, 3);
  second.box.periodic[0] = true;
  trails.add(second);
  Canvas wrapped(kColumns, kRows);
  trails.paint(second, wrapped, {});
  EXPECT_EQ(row_of(wrapped, 9), " .." + std::string(34, ' ') + ".. ");
}

TEST(Trails, BeginAgainWhereBallsComeOrTimeGoesBackAndAreBounded) {
  Trails trails;
  trails.show(true);
  Ball ball{{5, 18}, {10, 0}};
  const auto dots = [&](const Frame& frame) {
    Canvas canvas(kColumns, kRows);
    trails.paint(frame, canvas, {});
    return count_of(canvas, Ink::trail);
  };
  Frame frame;
  for (int k = 0; k < 100; ++k) {
    ball.position = {3 + 0.3 * k, 18};
    frame = frame_of({ball}, k);
    trails.add(frame);
  }
  EXPECT_LE(dots(frame), Trails::kFrames * 3 / 10 + 2);
  EXPECT_GE(dots(frame), Trails::kFrames * 3 / 10 - 1);
  const Frame earlier = frame_of({ball}, 5);
  trails.add(earlier);
  EXPECT_EQ(dots(earlier), 0U);
  const Frame more = frame_of({ball, ball}, 6);
  trails.add(more);
  EXPECT_EQ(dots(more), 0U);
}

TEST(Arrows, PointWhereTheBallFlies) {
  const struct {
    Vec2 velocity;
    char head;
    int columns;  // of the head beside the middle of the ball
    int rows;
  } cases[] = {{{3, 0}, '>', 1, 0},   {{-3, 0}, '<', -1, 0}, {{0, 3}, '^', 0, -1},
               {{0, -3}, 'v', 0, 1},  {{3, 3}, '/', 1, -1},  {{-3, 3}, '\\', -1, -1},
               {{3, -3}, '\\', 1, 1}, {{-3, -3}, '/', -1, 1}};
  for (const auto& each : cases) {
    Ball ball{{19.5, 18}, each.velocity};
    ball.radius = 0.5;
    const Frame frame = frame_of({ball});
    Canvas canvas(kColumns, kRows);
    paint_arrows(frame, {ball}, canvas, {});
    int heads = 0;
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        if (canvas.at(column, row).character == U' ') continue;
        EXPECT_EQ(canvas.at(column, row).ink, Ink::notice);
        // All of it lies on the side to which the ball flies.
        EXPECT_GE((column - 20) * each.columns, 0) << each.head;
        EXPECT_GE((row - 9.5) * each.rows, -1) << each.head;
        if (canvas.at(column, row).character == static_cast<unsigned char>(each.head)) ++heads;
      }
    }
    EXPECT_GE(heads, 1) << each.head;
  }
}

TEST(Arrows, AreNotDrawnForBallsThatStand) {
  Ball ball{{19.5, 18}, {0, 0}};
  Canvas canvas(kColumns, kRows);
  paint_arrows(frame_of({ball}), {ball}, canvas, {});
  EXPECT_EQ(count_of(canvas, Ink::notice), 0U);
}

TEST(Numbers, StandOnBallsThatAreWideEnough) {
  Ball large{{10, 18}, {0, 0}};
  large.radius = 4;
  Ball small{{30, 18}, {0, 0}};
  small.radius = 1;
  const Frame frame = frame_of({large, small});
  Canvas canvas(kColumns, kRows);
  paint(frame, canvas);
  paint_numbers(frame, {17, 8}, canvas, {});
  EXPECT_EQ(count_of(canvas, Ink::chosen), 2U);
  EXPECT_NE(row_of(canvas, 10).find("17"), std::string::npos) << row_of(canvas, 10);
}

}  // namespace
}  // namespace carom::drawing_test
