#pragma once

#include <cmath>
#include <vector>

#include "carom/accuracy.hpp"

namespace carom::test {

/// Two equal disks that meet head-on and part: all that happens can be written down.
///
/// Disk 0 starts at 3 with velocity 1, disk 1 at 7.01 with velocity -1; both have radius 1/2, so
/// that they touch at kTouch, and from then on each flies back the way it came.
struct HeadOn {
  static constexpr double kTouch = 1.505;
  static constexpr double kTime = 3;
  static constexpr double kRadius = 0.5;

  static Scene scene() {
    Scene scene;
    scene.name = "head-on";
    scene.effects.collisions = Collisions{};
    for (const double side : {-1.0, 1.0}) {
      Ball ball;
      ball.position = {side < 0 ? 3 : 7.01, 5};
      ball.velocity = {-side, 0};
      ball.radius = kRadius;
      scene.balls.push_back(ball);
    }
    return scene;
  }

  /// Steps see the contact at the end of the one in which it is, and this much late.
  static double delay(double step) { return std::ceil(kTouch / step) * step - kTouch; }
};

/// A short study, with little spent on timing.
inline AccuracyStudy study_of(const Scene& scene, double time,
                              const std::vector<AccuracyCrew>& crews = {}) {
  AccuracyRequest request;
  request.time = time;
  request.crews = crews;
  request.share = 20;  // more than any machine needs
  return study_accuracy(scene, request);
}

}  // namespace carom::test
