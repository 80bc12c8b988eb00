#include "contact/contacts_last.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace carom::contact::contacts_last_test {
namespace {

// Elastic balls in a box with walls, under gravity.
Effects elastic() {
  Effects effects;
  effects.walls = Walls{1};
  effects.collisions = Collisions{1};
  effects.gravity = Gravity{{0, -1}};
  return effects;
}

bool last(const Effects& effects, double heavier = 1, bool fixed = false) {
  std::vector<Ball> balls(2);
  balls[1].mass = heavier;
  balls[1].fixed = fixed;
  return contacts_last(effects, Balls(balls, effects));
}

TEST(ContactsLast, WhereGravityPressesAndImpactsLoseEnergy) {
  EXPECT_FALSE(last(elastic()));
  Effects lossy = elastic();
  lossy.collisions->restitution = 0.5;
  EXPECT_TRUE(last(lossy));
  lossy = elastic();
  lossy.walls->restitution = 0.5;
  EXPECT_TRUE(last(lossy));
}

TEST(ContactsLast, WhereFrictionActsAtWalls) {
  Effects rough = elastic();
  rough.friction = Friction{0.3, 0.3};
  EXPECT_TRUE(last(rough));
}

TEST(ContactsLast, NotWithoutGravityOrAnythingToTouch) {
  Effects lossy = elastic();
  lossy.collisions->restitution = 0.5;
  Effects weightless = lossy;
  weightless.gravity->acceleration = {0, 0};
  EXPECT_FALSE(last(weightless));
  weightless.gravity.reset();
  EXPECT_FALSE(last(weightless));
  lossy.walls.reset();
  lossy.collisions->on = false;
  EXPECT_FALSE(last(lossy));
}

TEST(ContactsLast, WhereAttractionPressesAndImpactsLoseEnergy) {
  Effects pulled = elastic();
  pulled.gravity.reset();
  pulled.attraction = Attraction{1, 0.5};
  EXPECT_FALSE(last(pulled));
  EXPECT_FALSE(last(pulled, 17));
  pulled.collisions->restitution = 0.5;
  EXPECT_TRUE(last(pulled));
  EXPECT_FALSE(contacts_last(pulled, Balls(std::vector<Ball>(1), pulled)));
  pulled.attraction->strength = -1;
  EXPECT_FALSE(last(pulled));
}

TEST(ContactsLast, WhereAHeavyBallLiesOnALightOne) {
  EXPECT_FALSE(last(elastic(), 16));
  EXPECT_TRUE(last(elastic(), 17));
  EXPECT_FALSE(last(elastic(), 17, true));  // it does not fall
  Effects apart = elastic();
  apart.collisions.reset();
  EXPECT_FALSE(last(apart, 17));
}

}  // namespace
}  // namespace carom::contact::contacts_last_test
