// Where the mouse points, when a ball meets something next, and a ball that gets another mass.
#include <gtest/gtest.h>

#include <cmath>

#include "carom/scene_file.hpp"
#include "view/change_mass.hpp"
#include "view/keys.hpp"
#include "view/next_event.hpp"
#include "view/pointer.hpp"

namespace carom::selection_test {
namespace {

TEST(Pointer, ZoomingKeepsThePointUnderIt) {
  const Box box{20, 10};
  for (const int column : {3, 40, 77}) {
    for (const int row : {1, 11, 20}) {
      Viewpoint view;
      for (int i = 0; i < 8; ++i) {
        const Camera before(box, 80, 22, view);
        const Vec2 point = point_at(before, column, row);
        view = zoomed_at(box, 80, 22, view, 1.25, column, row);
        const Camera after(box, 80, 22, view);
        // To the cell: a camera stands on whole cells, and the box is centred until it fills them.
        EXPECT_NEAR(after.x(point.x()), column + 0.5, 1) << column << ' ' << row;
        EXPECT_NEAR(after.y(point.y()), row + 0.5, i == 0 ? 2 : 1) << column << ' ' << row;
      }
    }
  }
}

TEST(Pointer, MeansTheBallThatIsNearestForItsSize) {
  Frame frame;
  frame.box = Box{20, 10};
  frame.box.periodic = {true, false};
  frame.balls = {
      {{5, 5}, 2, 0, false, 0}, {{7.3, 5}, 0.1, 0, false, 0}, {{0.1, 2}, 1, 0, false, 0}};
  const Camera camera(frame.box, 80, 22);
  const auto at = [&](double x, double y) {
    return ball_at(frame, camera, static_cast<int>(camera.x(x)), static_cast<int>(camera.y(y)));
  };
  EXPECT_EQ(at(5, 5), 0U);
  EXPECT_EQ(at(7.3, 5), 1U) << "in the same cell as the edge of the large one";
  EXPECT_EQ(at(6.5, 5), 0U);
  EXPECT_EQ(at(19.8, 2), 2U) << "across the periodic side";
  EXPECT_FALSE(at(12, 8));
}

TEST(NextEvent, IsTheImpactThatComes) {
  for (const Method method : {Method::event, Method::overlap}) {
    Scene scene;
    scene.effects.walls.emplace();
    scene.effects.collisions.emplace();
    // They are 7 apart, touch at 1 and approach at 2: they meet at 3 s, where the first is at 5.
    scene.balls = {{{2, 5}, {1, 0}}, {{9, 5}, {-1, 0}}};
    scene.solver.method = method;
    Session session(scene);
    NextEvent next;
    const auto always = [] { return true; };
    next.look(session, 0, always);
    ASSERT_TRUE(next.found());
    EXPECT_EQ(next.found()->b, 1U);
    EXPECT_NEAR(next.found()->time, 3, method == Method::event ? 1e-12 : 1.0 / 240);
    session.advance_clock_to(3.5);
    next.look(session, 0, always);
    ASSERT_TRUE(next.found());
    EXPECT_EQ(next.found()->wall, Side::left);
    // From 5 back to 0.5 at speed 1.
    EXPECT_NEAR(next.found()->time, 7.5, method == Method::event ? 1e-12 : 2.0 / 240);
    session.apply(command::Remove{1});
    next.look(session, 0, always);
    ASSERT_TRUE(next.found());
    EXPECT_EQ(next.found()->wall, Side::left);
  }
}

TEST(NextEvent, SaysThatABallMeetsNothing) {
  Scene scene;
  scene.effects.walls.emplace();
  scene.balls = {{{2, 5}, {0, 0}}};
  const Session session(scene);
  NextEvent next;
  next.look(session, 0, [] { return true; });
  EXPECT_TRUE(next.none());
  EXPECT_FALSE(next.found());
}

TEST(ChangeMass, KeepsPlaceAndVelocityAndIsPartOfTheLog) {
  Scene scene;
  scene.effects.walls.emplace();
  scene.effects.collisions.emplace();
  scene.balls = {{{2, 5}, {1, 0.5}}, {{9, 5}, {-1, 0}}};
  Session session(scene);
  session.advance_clock_to(0.37);
  const Ball before = session.simulation().state()[0];
  EXPECT_EQ(change_mass(session, 0, 2), "");
  const Ball after = session.simulation().state()[1];
  EXPECT_EQ(after.mass, 2 * before.mass);
  EXPECT_EQ(after.position, before.position);
  EXPECT_EQ(after.velocity, before.velocity);
  session.advance_clock_to(5);
  const Scene log = parse_scene(write_scene(session.log()), "log");
  Session again(log);
  again.advance_clock_to(log.duration);
  EXPECT_EQ(again.simulation().state_hash(), session.simulation().state_hash());
}

TEST(ChangeMass, OfABallThatTouchesAnotherChangesNothing) {
  Scene scene;
  scene.effects.walls.emplace();
  scene.effects.collisions.emplace();
  scene.balls = {{{2, 5}, {1, 0}}, {{3.001, 5}, {-1, 0}}};
  Session session(scene);
  const auto off = session.switch_of("collisions");
  session.apply(off->change);
  session.advance_clock_to(0.1);
  session.apply(session.switch_of("collisions")->change);
  const std::string hash = session.simulation().state_hash();
  EXPECT_NE(change_mass(session, 0, 2), "");
  EXPECT_EQ(session.simulation().state_hash(), hash);
}

TEST(Keys, AClickOnAHintIsItsKey) {
  const auto hints = key_hints(200, true, "wg");
  const std::string line = hint_line(hints);
  const auto at = [&](const std::string& words, int within) {
    return key_of_hint(hints, static_cast<int>(line.find(words)) + within);
  };
  EXPECT_EQ(at("space:go on", 3), ' ');
  EXPECT_EQ(at("q:quit", 5), 'q');
  EXPECT_EQ(at("+-:speed", 0), '+');
  EXPECT_EQ(at("+-:speed", 1), '-');
  EXPECT_EQ(at("wg:on/off", 0), 'w');
  EXPECT_EQ(at("wg:on/off", 1), 'g');
  EXPECT_EQ(at("wg:on/off", 4), 0);
  EXPECT_EQ(at(" q:quit", 0), 0) << "between two";
}

}  // namespace
}  // namespace carom::selection_test
