// What a terminal is sent: held against libvterm, which shows it.
#include "view/encoder.hpp"

#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <string>

#include "support/vterm_screen.hpp"

namespace carom::encoder_test {
namespace {

Palette many() {
  return {Colors::many, Background::any};
}

Canvas random_canvas(std::mt19937& random, int columns, int rows) {
  static constexpr char32_t kCharacters[] = U"   oo8()▀▄█⣿─│";
  const auto draw = [&random](std::size_t below) { return random() % below; };
  Canvas canvas(columns, rows);
  for (Cell& cell : canvas.cells) {
    if (draw(3) != 0) continue;
    cell.character = kCharacters[draw(std::size(kCharacters) - 1)];
    cell.ink = static_cast<Ink>(draw(static_cast<std::size_t>(Ink::waits) + 1));
    cell.heat = static_cast<float>(draw(9)) / 8;
    if (draw(4) == 0) cell.back = Ink::ball;
  }
  return canvas;
}

void expect_shows(const support::VtermScreen& screen, const Canvas& canvas, const Palette& palette,
                  int round) {
  for (int row = 0; row < canvas.rows; ++row) {
    for (int column = 0; column < canvas.columns; ++column) {
      const Cell& cell = canvas.at(column, row);
      const support::ShownCell shown = screen.at(column, row);
      ASSERT_EQ(shown.character, cell.character) << round << ": " << column << ' ' << row;
      const Look look = palette.look(cell);
      ASSERT_EQ(shown.reverse, look.reverse);
      ASSERT_EQ(shown.back, look.back);
      if (cell.character == U' ') continue;
      ASSERT_EQ(shown.bold, look.bold) << round << ": " << column << ' ' << row;
      ASSERT_EQ(shown.fore, look.fore) << round << ": " << column << ' ' << row;
    }
  }
}

TEST(Encoder, OneHundredRandomPicturesInTurnAreShownRight) {
  std::mt19937 random(7);
  for (const auto& [columns, rows] : {std::pair{40, 12}, {120, 40}, {1, 1}, {3, 200}}) {
    for (const Colors colors : {Colors::sixteen, Colors::many, Colors::true_color}) {
      const Palette palette(colors, Background::any);
      Encoder encoder(palette);
      support::VtermScreen screen(columns, rows);
      Canvas canvas = random_canvas(random, columns, rows);
      for (int round = 0; round < 30; ++round) {
        const Canvas other = random_canvas(random, columns, rows);
        for (std::size_t i = 0; i < canvas.cells.size(); ++i) {
          if (round % 3 != 0 ? random() % 20 == 0 : random() % 2 == 0)
            canvas.cells[i] = other.cells[i];
        }
        screen.write(encoder.show(canvas));
        expect_shows(screen, canvas, palette, round);
      }
    }
  }
}

TEST(Encoder, SendsNothingWhereNothingChanges) {
  std::mt19937 random(1);
  const Canvas canvas = random_canvas(random, 80, 24);
  Encoder encoder(many());
  EXPECT_NE(encoder.show(canvas), "");
  EXPECT_EQ(encoder.show(canvas), "");
  Canvas warmer = canvas;
  for (Cell& cell : warmer.cells) cell.heat += 1e-5F;  // the same colour
  EXPECT_EQ(encoder.show(warmer), "");
}

TEST(Encoder, OneCellTakesAJumpAColourAndTheCharacter) {
  Encoder encoder(many());
  Canvas canvas(80, 24);
  (void)encoder.show(canvas);
  canvas.put(9, 4, U'o', Ink::ball, 0);
  EXPECT_EQ(encoder.show(canvas), "\x1B[5;10H\x1B[38;5;62mo\x1B[m");
  canvas.put(9, 4, U' ', Ink::none);
  EXPECT_EQ(encoder.show(canvas), "\x1B[5;10H ");
}

TEST(Encoder, WithoutColoursNoneIsSent) {
  std::mt19937 random(3);
  Encoder encoder({Colors::none, Background::any});
  const std::string bytes = encoder.show(random_canvas(random, 80, 24));
  EXPECT_FALSE(std::regex_search(bytes, std::regex("\x1B\\[([0-9]+;)*[34][0-9](;[0-9]+)*m")));
  EXPECT_TRUE(std::regex_search(bytes, std::regex("\x1B\\[1m")));
}

}  // namespace
}  // namespace carom::encoder_test
