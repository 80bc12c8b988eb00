#pragma once

#include <functional>

#include "carom/scene.hpp"
#include "carom/text_sink.hpp"

namespace carom {

/// A scene whose balls and saved flights are given one by one while it is written, so that a large
/// state is not copied.
///
/// Holds: as long as what it was taken from stays as it is.
struct SceneStream {
  using Balls = std::function<void(const Ball&)>;
  using Flights = std::function<void(const SavedFlight&)>;

  Scene head;                                       ///< all else; its own balls and flights too
  std::function<void(const Balls&)> each_ball;      ///< may be empty: there are none
  std::function<void(const Flights&)> each_flight;  ///< those of the continuation

  /// The same as a scene in memory.
  [[nodiscard]] Scene collect() const;
};

/// The scene as JSON text that `parse_scene` reads back to the same bits.
void write_scene(const SceneStream& scene, const TextSink& sink);

}  // namespace carom
