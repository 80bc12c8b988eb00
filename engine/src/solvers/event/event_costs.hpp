#pragma once

#include <cstdint>

namespace carom::event {

/// Wall-clock seconds of what effects do.
struct Costs {
  double collisions = 0;  ///< pairs: who meets next, impacts between balls, islands
  double walls = 0;       ///< when a ball meets a wall, and impacts there
  double friction = 0;    ///< of single impacts
  double bending = 0;     ///< of flights, to their impacts, by gravity and drag

  Costs& operator+=(const Costs& other) {
    collisions += other.collisions;
    walls += other.walls;
    friction += other.friction;
    bending += other.bending;
    return *this;
  }
  /// Of all but pairs.
  [[nodiscard]] double beside_pairs() const { return walls + friction + bending; }
};

/// One event in so many is timed: reading the clock in all would cost more than they.
inline constexpr std::uint32_t kEventsOfSample = 127;

/// What the events of one event loop cost, from those that were timed.
class EventCosts {
 public:
  /// Asked before every event: whether it is one that is timed.  Then `add` follows it.
  [[nodiscard]] bool is_timed() { return untimed_-- == 0; }
  void add(const Costs& event) {
    untimed_ = kEventsOfSample - 1;
    ++samples_;
    sampled_ += event;
  }
  /// Seconds of all steps and impacts of islands, each of which is timed.
  [[nodiscard]] double& island_seconds() { return island_seconds_; }

  /// Scaled to all events since this was made.
  [[nodiscard]] Costs total() const {
    Costs costs;
    if (samples_ > 0) {
      const auto samples = static_cast<double>(samples_);
      const double scale = (samples * kEventsOfSample - untimed_) / samples;
      costs = {sampled_.collisions * scale, sampled_.walls * scale, sampled_.friction * scale,
               sampled_.bending * scale};
    }
    costs.collisions += island_seconds_;
    return costs;
  }

 private:
  Costs sampled_;              ///< of the events that were timed
  std::uint64_t samples_ = 0;  ///< how many they are
  std::uint32_t untimed_ = 0;  ///< events before the next one that is
  double island_seconds_ = 0;
};

}  // namespace carom::event
