#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "carom/ball.hpp"
#include "carom/effects.hpp"

namespace carom {

/// The balls of a running scene, one array for each property.
///
/// Holds: columns of one length, in the order of the scene's balls, its fills and later additions;
/// a fixed ball has inverse mass 0 and velocity 0.  There is no column for a property that no
/// effect needs.
struct Balls {
  using Column = std::vector<double>;

  std::array<Column, 2> position;  ///< x and y
  std::array<Column, 2> velocity;
  Column radius;
  Column mass;
  Column inverse_mass;
  Column spin;                 ///< with friction
  std::array<Column, 2> pull;  ///< with attraction: the acceleration it makes where the balls are
  std::vector<char> glyph;

  explicit Balls(const std::vector<Ball>& balls = {}, const Effects& effects = {});

  [[nodiscard]] std::size_t size() const { return glyph.size(); }
  [[nodiscard]] bool fixed(std::size_t i) const { return inverse_mass[i] == 0; }
  [[nodiscard]] Vec2 at(std::size_t i) const { return {position[0][i], position[1][i]}; }
  [[nodiscard]] Ball ball(std::size_t i) const;
  [[nodiscard]] std::vector<Ball> to_vector() const;
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t i = 0; i < size(); ++i) visit(ball(i));
  }
};

}  // namespace carom
