#pragma once

#include <array>

#include "support/exact_number.hpp"
#include "support/random_numbers.hpp"
#include "trajectory/fixed_disk_time.hpp"

namespace carom::test {

/// A ball's way past a fixed ball, as fixed_disk_time() takes it.
struct FixedDiskCase {
  event::Vec<double> r;
  event::Vec<double> v;
  event::Vec<double> g;
  double s;
  bool from_contact;
};

/// How many real roots of the squared gap lie in a stretch of time, by Sturm's theorem in a hundred
/// digits: it shares nothing with the method under test.  Of a flight that starts at contact the
/// root at 0 is divided out.
class FixedDiskTruth {
 public:
  explicit FixedDiskTruth(const FixedDiskCase& c) {
    const Exact rx(c.r.x), ry(c.r.y), vx(c.v.x), vy(c.v.y), gx(c.g.x), gy(c.g.y);
    const std::array<Exact, 5> quartic{
        rx * rx + ry * ry - Exact(c.s) * c.s, 2 * (rx * vx + ry * vy),
        vx * vx + vy * vy + rx * gx + ry * gy, vx * gx + vy * gy, (gx * gx + gy * gy) / 4};
    const int skip = c.from_contact ? 1 : 0;
    degree_[0] = 4 - skip;
    for (int k = 0; k <= degree_[0]; ++k)
      chain_[0][k] = quartic[static_cast<std::size_t>(k) + static_cast<std::size_t>(skip)];
    degree_[1] = degree_[0] - 1;
    for (int k = 0; k < degree_[0]; ++k) chain_[1][k] = chain_[0][k + 1] * (k + 1);
    length_ = 2;
    while (degree_[length_ - 1] > 0) {
      if (!add_remainder()) break;
    }
  }

  /// Sign changes of Sturm's chain at t; their difference between two times counts the roots
  /// between.
  int changes(const Exact& t) const {
    int count = 0;
    int last = 0;
    for (int n = 0; n < length_; ++n) {
      Exact value = chain_[n][degree_[n]];
      for (int k = degree_[n] - 1; k >= 0; --k) value = value * t + chain_[n][k];
      count_change(value.sign(), last, count);
    }
    return count;
  }
  int changes_at_infinity() const {
    int count = 0;
    int last = 0;
    for (int n = 0; n < length_; ++n) count_change(chain_[n][degree_[n]].sign(), last, count);
    return count;
  }

 private:
  static void count_change(int sign, int& last, int& count) {
    if (sign == 0) return;
    if (last != 0 && sign != last) ++count;
    last = sign;
  }

  bool add_remainder() {
    std::array<Exact, 5> rest = chain_[length_ - 2];
    const auto& by = chain_[length_ - 1];
    const int m = degree_[length_ - 1];
    for (int k = degree_[length_ - 2]; k >= m; --k) {
      const Exact factor = rest[k] / by[m];
      for (int n = 0; n <= m; ++n) rest[k - m + n] -= factor * by[n];
      rest[k] = 0;
    }
    int top = m - 1;
    while (top >= 0 && rest[top] == 0) --top;
    if (top < 0) return false;
    for (int k = 0; k <= top; ++k) chain_[length_][k] = -rest[k];
    degree_[length_] = top;
    ++length_;
    return true;
  }

  std::array<std::array<Exact, 5>, 6> chain_{};
  std::array<int, 6> degree_{};
  int length_ = 0;
};

/// A parabola made backwards from a contact somewhere on it: square, slanting or near tangent, of
/// short flights and long ones; some start at contact; of some the distance of contact is the
/// distance the way just passes at.
inline FixedDiskCase random_fixed_disk_case(RandomNumbers& random) {
  using event::Vec;
  const auto polar = [](double length, double angle) {
    return Vec<double>{length * std::cos(angle), length * std::sin(angle)};
  };
  FixedDiskCase c{};
  c.s = random.between(0.1, 2);
  c.g = polar(std::exp(random.between(-3, 3)), random.angle());
  const double normal = random.angle();
  const double near_tangent = std::pow(10.0, -random.between(0, 17)) * random.sign();
  const double slant = random.below(2) == 0 ? random.angle() : std::acos(0.0) + near_tangent;
  const Vec<double> v_contact = polar(std::exp(random.between(-3, 3)), normal + slant);
  const double t = std::exp(random.between(-6, 4));
  c.v = v_contact - t * c.g;
  c.r = polar(c.s, normal) - t * c.v - (t * t / 2) * c.g;
  if (random.below(8) == 0) {
    c.from_contact = true;
    c.r = polar(c.s, normal);
    c.v = v_contact;
    if (event::sharp_dot(c.r, c.v) < 0) c.v = -c.v;
  }
  return c;
}

/// Nothing, or what is wrong with the answer: a root before it, none at it, or one that was missed.
inline const char* fixed_disk_fault(const FixedDiskCase& c, double t) {
  const FixedDiskTruth truth(c);
  const int start = truth.changes(Exact(0));
  if (t == event::never<double>()) {
    return start == truth.changes_at_infinity() ? nullptr : "missed a root";
  }
  const Exact before = Exact(t) * (1 - 4 * Exact(kU));
  const Exact behind = Exact(t) * (1 + 4 * Exact(kU));
  if (truth.changes(before) != start) return "there is an earlier root";
  return truth.changes(behind) == start ? "there is no root here" : nullptr;
}

}  // namespace carom::test
