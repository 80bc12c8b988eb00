#include "peer.hpp"

#if __has_include(<chipmunk/chipmunk.h>)

#include <chipmunk/chipmunk.h>

namespace carom::peers {
namespace {

/// Elastic disks without friction, damping and spin; what is left is the library's own.
class Chipmunk final : public Peer {
 public:
  Chipmunk(const Scene& scene, double step, int iterations)
      : balls_(scene.balls), step_(step), space_(cpSpaceNew()) {
    cpSpaceSetIterations(space_, iterations);
    add_walls(scene.box);
    for (const Ball& ball : scene.balls) add(ball);
  }
  ~Chipmunk() override {
    for (cpShape* const shape : shapes_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    for (cpBody* const body : bodies_) {
      cpSpaceRemoveBody(space_, body);
      cpBodyFree(body);
    }
    cpSpaceFree(space_);
  }
  Chipmunk(const Chipmunk&) = delete;
  Chipmunk& operator=(const Chipmunk&) = delete;

  void step() override { cpSpaceStep(space_, step_); }

  [[nodiscard]] std::vector<Ball> state() const override {
    std::vector<Ball> balls = balls_;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const cpVect at = cpBodyGetPosition(bodies_[i]);
      const cpVect velocity = cpBodyGetVelocity(bodies_[i]);
      balls[i].position = {at.x, at.y};
      balls[i].velocity = {velocity.x, velocity.y};
    }
    return balls;
  }

 private:
  void keep(cpShape* shape) {
    cpShapeSetElasticity(shape, 1);
    cpShapeSetFriction(shape, 0);
    shapes_.push_back(cpSpaceAddShape(space_, shape));
  }

  void add_walls(const Box& box) {
    const cpVect corners[] = {{0, 0}, {box.width, 0}, {box.width, box.height}, {0, box.height}};
    for (std::size_t i = 0; i < 4; ++i) {
      keep(cpSegmentShapeNew(cpSpaceGetStaticBody(space_), corners[i], corners[(i + 1) % 4], 0));
    }
  }

  void add(const Ball& ball) {
    cpBody* const body = cpSpaceAddBody(space_, cpBodyNew(ball.mass, INFINITY));
    cpBodySetPosition(body, {ball.position.x(), ball.position.y()});
    cpBodySetVelocity(body, {ball.velocity.x(), ball.velocity.y()});
    bodies_.push_back(body);
    keep(cpCircleShapeNew(body, ball.radius, {0, 0}));
  }

  std::vector<Ball> balls_;
  double step_;
  cpSpace* space_;
  std::vector<cpBody*> bodies_;
  std::vector<cpShape*> shapes_;
};

constexpr int kUsual = 10;
constexpr int kMany = 30;

std::unique_ptr<Peer> as_it_comes(const Scene& scene, double step) {
  return std::make_unique<Chipmunk>(scene, step, kUsual);
}
std::unique_ptr<Peer> many_iterations(const Scene& scene, double step) {
  return std::make_unique<Chipmunk>(scene, step, kMany);
}

}  // namespace

std::vector<Entrant> chipmunk_entrants() {
  return {{"Chipmunk 7, as it comes", 1.0 / 60, as_it_comes},
          {"Chipmunk, 30 iterations", 1.0 / 60, many_iterations},
          {"Chipmunk, 30 iterations", 1.0 / 240, many_iterations},
          {"Chipmunk, 30 iterations", 1.0 / 960, many_iterations}};
}

}  // namespace carom::peers

#else

std::vector<carom::peers::Entrant> carom::peers::chipmunk_entrants() {
  return {};
}

#endif
