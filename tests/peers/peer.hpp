#pragma once

#include <memory>
#include <string>
#include <vector>

#include "carom/scene.hpp"

namespace carom::peers {

/// A simulator of balls in a walled box, as another library makes it.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  virtual void step() = 0;
  /// Positions and velocities in the order of the scene's balls.
  [[nodiscard]] virtual std::vector<Ball> state() const = 0;
};

/// A way to run the scene: what it is called, its step, and how it begins.
struct Entrant {
  std::string name;
  double step = 0;
  std::unique_ptr<Peer> (*make)(const Scene& scene, double step) = nullptr;
};

/// None where the library was not there when this was built.
std::vector<Entrant> box2d_entrants();
std::vector<Entrant> chipmunk_entrants();

}  // namespace carom::peers
