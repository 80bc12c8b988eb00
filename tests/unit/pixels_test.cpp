// Disks of pixels and dots.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "view/camera.hpp"
#include "view/paint.hpp"

namespace carom::pixels_test {
namespace {

constexpr int kColumns = 82;
constexpr int kRows = 42;

Frame one_disk(double x, double y, double radius) {
  Frame frame;
  frame.walls = true;
  FrameBall ball;
  ball.position = {x, y};
  ball.radius = radius;
  ball.speed = 1;
  frame.box.width = 20;
  frame.box.height = 20;
  frame.balls.push_back(ball);
  return frame;
}

struct Dot {
  double x = 0;  // scene units
  double y = 0;
};

/// The middles of the pixels that are set, as the characters' definitions have them.
std::vector<Dot> dots_of(const Canvas& canvas, const Camera& camera, Glyphs glyphs) {
  std::vector<Dot> dots;
  const auto add = [&](double column, double row) {
    dots.push_back({camera.scene_x(column), camera.scene_y(row)});
  };
  // Unicode: dots 1 2 3 7 down the left column, 4 5 6 8 down the right one, as bits from the
  // lowest.
  constexpr int kLeft[] = {0, 1, 2, 6};
  constexpr int kRight[] = {3, 4, 5, 7};
  for (int row = 0; row < canvas.rows; ++row) {
    for (int column = 0; column < canvas.columns; ++column) {
      const Cell& cell = canvas.at(column, row);
      if (cell.ink != Ink::ball) continue;
      if (glyphs == Glyphs::braille) {
        const unsigned bits = cell.character - 0x2800;
        for (int i = 0; i < 4; ++i) {
          if ((bits >> static_cast<unsigned>(kLeft[i]) & 1U) != 0)
            add(column + 0.25, row + (i + 0.5) / 4);
          if ((bits >> static_cast<unsigned>(kRight[i]) & 1U) != 0)
            add(column + 0.75, row + (i + 0.5) / 4);
        }
      } else {
        if (cell.character == U'█' || cell.character == U'▀') add(column + 0.5, row + 0.25);
        if (cell.character == U'█' || cell.character == U'▄') add(column + 0.5, row + 0.75);
      }
    }
  }
  return dots;
}

TEST(Pixels, ADiskIsRoundWithinADot) {
  for (const Glyphs glyphs : {Glyphs::blocks, Glyphs::braille}) {
    for (const double radius : {1.0, 2.3, 5.0}) {
      for (const double shift : {0.0, 0.03, 0.11}) {
        const Frame frame = one_disk(10 + shift, 9.7 - shift, radius);
        Canvas canvas(kColumns, kRows);
        Drawing drawing;
        drawing.glyphs = glyphs;
        paint(frame, canvas, drawing);
        const Camera camera(frame.box, kColumns, kRows);
        const double dot = (glyphs == Glyphs::blocks ? 1.0 : 0.5) / camera.across();
        const std::vector<Dot> dots = dots_of(canvas, camera, glyphs);
        std::set<std::pair<double, double>> set;
        for (const Dot& each : dots) {
          EXPECT_LE(std::hypot(each.x - frame.balls[0].position.x(),
                               each.y - frame.balls[0].position.y()),
                    radius * (1 + 1e-12));
          set.insert({each.x, each.y});
        }
        EXPECT_EQ(set.size(), dots.size());
        // Every middle of a dot within the disk is set: as many as there are, counted afresh.
        std::size_t within = 0;
        for (int i = -200; i < 400; ++i) {
          for (int j = -200; j < 400; ++j) {
            const double x = camera.scene_x((i + 0.5) * dot * camera.across());
            const double y = camera.scene_y((j + 0.5) * dot * camera.across() / 2);
            within += std::hypot(x - frame.balls[0].position.x(),
                                 y - frame.balls[0].position.y()) <= radius
                          ? 1
                          : 0;
          }
        }
        EXPECT_NEAR(static_cast<double>(dots.size()), static_cast<double>(within), 2);
        EXPECT_NEAR(static_cast<double>(dots.size()) * dot * dot,
                    std::numbers::pi * radius * radius, 4 * radius * dot);
      }
    }
  }
}

TEST(Pixels, ADiskThatMovesByADotMovesItsDots) {
  Drawing drawing;
  drawing.glyphs = Glyphs::braille;
  std::set<std::u32string> pictures;
  for (int i = 0; i < 4; ++i) {
    const Frame frame = one_disk(10 + i * 0.125, 10, 1.6);  // half a column each
    Canvas canvas(kColumns, kRows);
    paint(frame, canvas, drawing);
    std::u32string text;
    for (const Cell& cell : canvas.cells) text += cell.character;
    pictures.insert(text);
  }
  EXPECT_EQ(pictures.size(), 4U);
}

TEST(Pixels, EveryBallHasAPixelAndFixedOnesDiffer) {
  for (const Glyphs glyphs : {Glyphs::blocks, Glyphs::braille}) {
    Drawing drawing;
    drawing.glyphs = glyphs;
    for (int i = 0; i < 50; ++i) {
      Canvas canvas(kColumns, kRows);
      paint(one_disk(5 + 0.137 * i, 5 + 0.091 * i, 1e-3), canvas, drawing);
      EXPECT_EQ(std::count_if(canvas.cells.begin(), canvas.cells.end(),
                              [](const Cell& cell) { return cell.ink == Ink::ball; }),
                1);
    }
    Canvas free(kColumns, kRows);
    Canvas fixed(kColumns, kRows);
    Frame frame = one_disk(10, 10, 3);
    paint(frame, free, drawing);
    frame.balls[0].fixed = true;
    paint(frame, fixed, drawing);
    EXPECT_NE(free.at(40, 21).character, fixed.at(40, 21).character);
  }
}

TEST(Pixels, TwoBallsInOneCellHaveTheirOwnColours) {
  Frame frame = one_disk(10.1, 10.375, 0.12);
  frame.balls.push_back(frame.balls[0]);
  frame.balls[0].speed = 0;
  frame.balls[1].position.y() -= 0.25;
  frame.balls[1].speed = 3;
  Canvas canvas(kColumns, kRows);
  Drawing drawing;
  drawing.glyphs = Glyphs::blocks;
  paint(frame, canvas, drawing);
  const auto both = std::find_if(canvas.cells.begin(), canvas.cells.end(),
                                 [](const Cell& cell) { return cell.back != Ink::none; });
  ASSERT_NE(both, canvas.cells.end());
  EXPECT_EQ(both->character, U'▀');
  EXPECT_LT(both->heat, both->back_heat);
}

TEST(Pixels, SidesAreLinesAndPeriodicOnesDashed) {
  Frame frame = one_disk(10, 10, 1);
  Drawing drawing;
  drawing.glyphs = Glyphs::blocks;
  Canvas canvas(kColumns, kRows);
  paint(frame, canvas, drawing);
  EXPECT_EQ(canvas.at(0, 0).character, U'┌');
  EXPECT_EQ(canvas.at(10, 0).character, U'─');
  EXPECT_EQ(canvas.at(0, 10).character, U'│');
  frame.box.periodic = {true, true};
  paint(frame, canvas, drawing);
  EXPECT_EQ(canvas.at(10, 0).character, U'┄');
  EXPECT_EQ(canvas.at(0, 10).character, U'┆');
}

TEST(Camera, NearerShowsAPartOfTheBoxLarger) {
  Box box;
  Viewpoint near;
  near.zoom = 4;
  near.x = 0.25;
  near.y = 0.75;
  const Camera far(box, 80, 24);
  const Camera camera(box, 80, 24, near);
  EXPECT_NEAR(camera.across(), 4 * far.across(), 0.5);
  EXPECT_NEAR(camera.x(5), 40, 1);  // a quarter of the width is in the middle of the canvas
  EXPECT_NEAR(camera.y(7.5), 12, 1);
  for (const double x : {0.0, 3.0, 20.0}) EXPECT_NEAR(camera.scene_x(camera.x(x)), x, 1e-12);
  for (const double y : {0.0, 3.0, 10.0}) EXPECT_NEAR(camera.scene_y(camera.y(y)), y, 1e-12);
}

TEST(Camera, AnyViewOfAnySceneIsDrawn) {
  for (const Glyphs glyphs : {Glyphs::ascii, Glyphs::blocks, Glyphs::braille}) {
    for (const double zoom : {1.0, 2.0, 256.0}) {
      for (const double x : {0.0, 0.5, 1.0}) {
        for (const double width : {20.0, 1e-6, 1e9}) {
          Frame frame = one_disk(10, 10, 1);
          frame.box.width = width;
          frame.box.periodic = {true, false};
          Drawing drawing{glyphs, {zoom, x, 1 - x}};
          for (const auto& [columns, rows] : {std::pair{80, 24}, {1, 1}, {300, 100}}) {
            Canvas canvas(columns, rows);
            paint(frame, canvas, drawing);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom::pixels_test
