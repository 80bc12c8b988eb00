#include "peer.hpp"

#if __has_include(<box2d/box2d.h>)

#include <box2d/box2d.h>

namespace carom::peers {
namespace {

/// Elastic disks without friction, damping and sleep; what is left is the library's own.
class Box2d final : public Peer {
 public:
  struct Settings {
    int velocity_iterations;
    int position_iterations;
    bool every_bounce;  ///< slow impacts bounce, too; by default those below 1 m/s do not
  };

  Box2d(const Scene& scene, double step, const Settings& settings)
      : balls_(scene.balls), step_(static_cast<float>(step)), settings_(settings) {
    world_.SetAllowSleeping(false);
    add_walls(scene.box);
    for (const Ball& ball : scene.balls) add(ball);
  }

  void step() override {
    world_.Step(step_, settings_.velocity_iterations, settings_.position_iterations);
  }

  [[nodiscard]] std::vector<Ball> state() const override {
    std::vector<Ball> balls = balls_;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const b2Vec2 at = bodies_[i]->GetPosition();
      const b2Vec2 velocity = bodies_[i]->GetLinearVelocity();
      balls[i].position = {at.x, at.y};
      balls[i].velocity = {velocity.x, velocity.y};
    }
    return balls;
  }

 private:
  [[nodiscard]] b2FixtureDef elastic(const b2Shape& shape) const {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = 0;
    fixture.restitution = 1;
    if (settings_.every_bounce) fixture.restitutionThreshold = 0;
    return fixture;
  }

  void add_walls(const Box& box) {
    b2BodyDef at_rest;
    b2Body* const walls = world_.CreateBody(&at_rest);
    // An edge has a skin, which lies outside here, so that balls turn at the sides of the box.
    const float left = -b2_polygonRadius;
    const float right = static_cast<float>(box.width) + b2_polygonRadius;
    const float top = static_cast<float>(box.height) + b2_polygonRadius;
    const b2Vec2 corners[] = {{left, left}, {right, left}, {right, top}, {left, top}};
    for (std::size_t i = 0; i < 4; ++i) {
      b2EdgeShape edge;
      edge.SetTwoSided(corners[i], corners[(i + 1) % 4]);
      const b2FixtureDef fixture = elastic(edge);
      walls->CreateFixture(&fixture);
    }
  }

  void add(const Ball& ball) {
    b2BodyDef moving;
    moving.type = b2_dynamicBody;
    moving.position = {static_cast<float>(ball.position.x()),
                       static_cast<float>(ball.position.y())};
    moving.linearVelocity = {static_cast<float>(ball.velocity.x()),
                             static_cast<float>(ball.velocity.y())};
    moving.fixedRotation = true;
    b2Body* const body = world_.CreateBody(&moving);
    b2CircleShape disk;
    disk.m_radius = static_cast<float>(ball.radius);
    b2FixtureDef fixture = elastic(disk);
    fixture.density = static_cast<float>(ball.mass / (b2_pi * ball.radius * ball.radius));
    body->CreateFixture(&fixture);
    bodies_.push_back(body);
  }

  std::vector<Ball> balls_;
  float step_;
  Settings settings_;
  b2World world_{{0, 0}};
  std::vector<b2Body*> bodies_;  // of the world
};

constexpr int kUsual = 8;
constexpr int kUsualPositions = 3;
constexpr int kMany = 40;

std::unique_ptr<Peer> as_it_comes(const Scene& scene, double step) {
  return std::make_unique<Box2d>(scene, step, Box2d::Settings{kUsual, kUsualPositions, false});
}
std::unique_ptr<Peer> every_bounce(const Scene& scene, double step) {
  return std::make_unique<Box2d>(scene, step, Box2d::Settings{kUsual, kUsualPositions, true});
}
std::unique_ptr<Peer> many_iterations(const Scene& scene, double step) {
  return std::make_unique<Box2d>(scene, step, Box2d::Settings{kMany, kMany, true});
}

}  // namespace

std::vector<Entrant> box2d_entrants() {
  return {{"Box2D 2.4, as it comes", 1.0 / 60, as_it_comes},
          {"Box2D, every bounce", 1.0 / 60, every_bounce},
          {"Box2D, every bounce", 1.0 / 240, every_bounce},
          {"Box2D, every bounce", 1.0 / 960, every_bounce},
          {"Box2D, 40 iterations", 1.0 / 960, many_iterations}};
}

}  // namespace carom::peers

#else

std::vector<carom::peers::Entrant> carom::peers::box2d_entrants() {
  return {};
}

#endif
