#pragma once

#include "carom/scene.hpp"

namespace carom::hard {

/// The scene with every ball listed, as it is at the start.
Scene listed(const Scene& scene);

/// Lengths, times and masses multiplied; by powers of two nothing is rounded.
Scene scaled(const Scene& scene, double length, double time, double mass);
std::vector<Ball> scaled(std::vector<Ball> balls, double length, double time, double mass);

/// Seen in a mirror; the origin of the box is its centre.
enum class Mirror { x, y, diagonal };
Scene mirrored(const Scene& scene, Mirror mirror);
std::vector<Ball> mirrored(std::vector<Ball> balls, Mirror mirror);

/// The balls in another order, drawn from the seed, and back.
class Shuffle {
 public:
  Shuffle(std::size_t balls, std::uint64_t seed);
  [[nodiscard]] std::vector<Ball> there(const std::vector<Ball>& balls) const;
  [[nodiscard]] std::vector<Ball> back(const std::vector<Ball>& balls) const;

 private:
  std::vector<std::size_t> from_;
};

}  // namespace carom::hard
