#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "carom/vector.hpp"

namespace carom {

/// Polynomials on [0, 1] in Bernstein form: their coefficients bound them, the first and the last
/// are their values at the ends, and halving the interval is a matter of means.
/// Source: Farin,
/// Curves and Surfaces for CAGD, chapters 4 to 6.
template <std::size_t kDegree>
using Bernstein = std::array<double, kDegree + 1>;

/// The parts of a polynomial below and above `at`, each on [0, 1] again (de Casteljau).
template <std::size_t kDegree>
void split(const Bernstein<kDegree>& p, double at, Bernstein<kDegree>& below,
           Bernstein<kDegree>& above) {
  above = p;
  for (std::size_t k = 0; k <= kDegree; ++k) {
    below[k] = above[0];
    for (std::size_t i = 0; i + k < kDegree; ++i) above[i] += at * (above[i + 1] - above[i]);
  }
}

/// Where a polynomial first becomes negative, to the last bits of [0, 1]; nothing where it does
/// not.
template <std::size_t kDegree>
std::optional<double> first_negative(const Bernstein<kDegree>& p, double begin = 0,
                                     double width = 1) {
  constexpr double kNarrow = 0x1p-52;
  bool negative = false;
  for (const double c : p) negative |= c < 0;
  if (!negative) return std::nullopt;
  if (p[0] < 0 || width < kNarrow) return begin;
  Bernstein<kDegree> below;
  Bernstein<kDegree> above;
  split<kDegree>(p, 0.5, below, above);
  if (const auto found = first_negative<kDegree>(below, begin, width / 2)) return found;
  return first_negative<kDegree>(above, begin + width / 2, width / 2);
}

/// Where what falls along `distance` first meets 0 from above, given the direction in which it
/// starts and the polynomial `slope` with the sign of its derivative.  What starts at or below 0
/// and comes nearer meets at once; what goes away cannot meet before it has turned.
template <std::size_t kDegree, std::size_t kSlopeDegree>
std::optional<double> first_meeting(const Bernstein<kDegree>& distance,
                                    const Bernstein<kSlopeDegree>& slope, double direction) {
  double turned = 0;
  Bernstein<kDegree> rest = distance;
  if (direction >= 0) {
    const auto turn = first_negative<kSlopeDegree>(slope);
    if (!turn) return std::nullopt;
    turned = *turn;
    Bernstein<kDegree> before;
    if (turned > 0) split<kDegree>(distance, turned, before, rest);
  }
  if (rest[0] <= 0) return turned;
  const auto met = first_negative<kDegree>(rest);
  if (!met) return std::nullopt;
  return turned + (1 - turned) * *met;
}

/// The quintic that has a position, velocity and acceleration at both ends of a step of h seconds:
/// the path in between to the sixth order in h.
inline Bernstein<5> quintic(double h, double x0, double v0, double a0, double x1, double v1,
                            double a1) {
  const double hh = h * h / 20;
  return {x0,
          x0 + h / 5 * v0,
          x0 + 2 * h / 5 * v0 + hh * a0,
          x1 - 2 * h / 5 * v1 + hh * a1,
          x1 - h / 5 * v1,
          x1};
}

/// The derivative, by a factor of the degree.
inline Bernstein<4> differences(const Bernstein<5>& p) {
  return {p[1] - p[0], p[2] - p[1], p[3] - p[2], p[4] - p[3], p[5] - p[4]};
}

/// Where a point that moves along (x, y) first comes as near to the origin as `reach`; `velocity`
/// is that with which it starts.
std::optional<double> first_contact(const Bernstein<5>& x, const Bernstein<5>& y,
                                    const Vec2& velocity, double reach);

/// Where a point on a line first comes down to 0.
std::optional<double> first_landing(const Bernstein<5>& height, double velocity);

}  // namespace carom
