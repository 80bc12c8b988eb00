#pragma once

#include <string>

#include "carom/fluid.hpp"
#include "export/frame_record.hpp"

namespace carom {

/// What is measured at each frame, a line of CSV each.
class SeriesText {
 public:
  explicit SeriesText(const Scene& scene)
      : meter_(scene),
        potential_(scene.effects.gravity.has_value() || scene.effects.attraction.has_value()) {}

  static std::string header();
  [[nodiscard]] std::string line(const FrameRecord& record);
  /// The next line is measured from this time on.
  void begin_at(double time) { meter_.begin_at(time); }

 private:
  FluidMeter meter_;
  bool potential_;  // there is such an energy
};

}  // namespace carom
