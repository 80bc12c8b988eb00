#pragma once

#include <string>

#include "export/frame_record.hpp"

namespace carom {

/// Frames as extended XYZ, which OVITO, ASE and MDAnalysis read.
class TrajectoryText {
 public:
  /// `scene`: as it is run.
  explicit TrajectoryText(const Scene& scene);

  [[nodiscard]] std::string frame(const FrameRecord& record) const;

 private:
  std::string box_;   // before the depth
  std::string tail_;  // after the time and frame
  std::string pbc_;
  Vec2 lower_;
  bool spins_;
};

}  // namespace carom
