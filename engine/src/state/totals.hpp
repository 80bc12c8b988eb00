#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "state/balls.hpp"

namespace carom {

/// How often each ball has gone round a periodic axis: upwards counts up.  Empty where it is not
/// needed.
using Turns = std::array<std::vector<std::int64_t>, 2>;

/// Of one ball, with that of its spin if it has one; of a fixed ball 0.
double kinetic_energy(const Ball& ball, bool spins);
/// Kinetic energy of the balls that move, and their potential energy in a uniform field.
/// Sums run in ball order.
double kinetic_energy(const Balls& balls);
/// Of uniform disks, m r^2 w^2 / 4; there must be a column of spins.
double spin_energy(const Balls& balls);
double potential_energy(const Balls& balls, const Vec2& gravity, const Vec2& periods,
                        const Turns& turns);
Vec2 momentum(const Balls& balls);

/// Sixteen hexadecimal digits over the exact bits of positions, velocities and, where there are
/// any, spins in ball order.
std::string state_hash(const Balls& balls);

/// The same sums of balls that are given one by one, in their order.
class Totals {
 public:
  /// `spins`: the balls have spins.  `turns`: as long as they are summed.
  Totals(bool spins, const Vec2& gravity, const Vec2& periods, const Turns& turns)
      : spins_(spins), gravity_(gravity), periods_(periods), turns_(turns) {}

  void add(const Ball& ball);
  [[nodiscard]] double energy() const {
    return kinetic_ + (spins_ ? spin_ : 0) + (potential_.x() + potential_.y());
  }
  [[nodiscard]] const Vec2& momentum() const { return momentum_; }

 private:
  bool spins_;
  Vec2 gravity_;
  Vec2 periods_;
  const Turns& turns_;
  std::size_t number_ = 0;
  double kinetic_ = 0;
  double spin_ = 0;
  Vec2 potential_;
  Vec2 momentum_;
};

/// The state's hash of balls that are given one by one, in their order.
class StateHash {
 public:
  StateHash(std::size_t balls, bool spins) : spins_(spins), digest_(balls) {}

  void add(const Ball& ball);
  [[nodiscard]] std::string text() const;

 private:
  bool spins_;
  std::uint64_t digest_;
};

}  // namespace carom
