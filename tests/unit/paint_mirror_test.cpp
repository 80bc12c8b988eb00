// What is mirrored is drawn as its mirrored picture.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "unit/painted.hpp"
#include "view/camera.hpp"
#include "view/disk.hpp"

namespace carom::paint_mirror_test {
namespace {

char32_t mirrored(char32_t character, const std::u32string& from, const std::u32string& to) {
  const auto place = from.find(character);
  return place == std::u32string::npos ? character : to[place];
}

TEST(PaintMirror, DrawsAMirroredFrameAsTheMirroredPicture) {
  const std::vector<FrameBall> balls = {ball_at(3.1, 2.2), ball_at(7.3, 8.4, 1.3),
                                        ball_at(12, 5.05, 0.2), ball_at(13.2, 1.1, 0.7)};
  Frame frame = box_with(balls);
  Frame sideways = frame;
  Frame upside = frame;
  for (FrameBall& ball : sideways.balls) ball.position.x() = 20 - ball.position.x();
  for (FrameBall& ball : upside.balls) ball.position.y() = 10 - ball.position.y();
  const Canvas plain = painted(frame);
  const Canvas mirror = painted(sideways);
  const Canvas flip = painted(upside);
  const Camera camera(frame.box, 80, 24);
  for (int i = 0; i < camera.columns(); ++i) {
    for (int j = 0; j < camera.rows(); ++j) {
      const char32_t here = plain.at(camera.left() + i, camera.top() + j).character;
      const int opposite_column = camera.left() + camera.columns() - 1 - i;
      const int opposite_row = camera.top() + camera.rows() - 1 - j;
      EXPECT_EQ(
          mirrored(mirror.at(opposite_column, camera.top() + j).character, U"()dbqP", U")(bdPq"),
          here);
      if (here != 'o' && here != '"' && here != '\'' && here != '.' && here != '_') {
        EXPECT_EQ(mirrored(flip.at(camera.left() + i, opposite_row).character, U"dbqP", U"qPdb"),
                  here);
      }
    }
  }
}

TEST(PaintMirror, ChoosesTheMirroredCharacterForEveryMirroredCoverage) {
  for (int code = 0; code < 17 * 17 * 17 * 17; ++code) {
    Coverage plain;
    plain.quarters = {code % 17, code / 17 % 17, code / 289 % 17, code / 4913};
    Coverage mirror;
    mirror.quarters = {plain.quarters[1], plain.quarters[0], plain.quarters[3], plain.quarters[2]};
    ASSERT_EQ(mirrored(character_for(mirror), U"()dbqP", U")(bdPq"), character_for(plain)) << code;
  }
}

TEST(PaintMirror, DrawsASymmetricRackSymmetrically) {
  Frame frame;
  frame.walls = true;
  frame.box.origin = Box::Origin::center;
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i <= row; ++i)
      frame.balls.push_back(ball_at(i - row * 0.5, row * 0.8660254037844386 - 2));
  }
  const Canvas canvas = painted(frame);
  for (int row = 0; row < canvas.rows; ++row) {
    for (int column = 0; column < canvas.columns; ++column) {
      EXPECT_EQ(
          canvas.at(column, row).character,
          mirrored(canvas.at(canvas.columns - 1 - column, row).character, U"()dbqP", U")(bdPq"));
    }
  }
}

}  // namespace
}  // namespace carom::paint_mirror_test
