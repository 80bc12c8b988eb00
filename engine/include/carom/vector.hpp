#pragma once

#include <cmath>
#include <cstddef>

namespace carom {

/// A point, velocity or acceleration of the plane: x to the right, y up.
class Vec2 {
 public:
  constexpr Vec2() = default;
  constexpr Vec2(double x, double y) : of_{x, y} {}

  [[nodiscard]] constexpr double x() const { return of_[0]; }
  [[nodiscard]] constexpr double y() const { return of_[1]; }
  constexpr double& x() { return of_[0]; }
  constexpr double& y() { return of_[1]; }
  /// By axis: 0 for x, 1 for y.
  constexpr double operator[](std::size_t axis) const { return of_[axis]; }
  constexpr double& operator[](std::size_t axis) { return of_[axis]; }

  constexpr Vec2& operator+=(const Vec2& b) { return *this = *this + b; }
  constexpr Vec2& operator-=(const Vec2& b) { return *this = *this - b; }
  constexpr Vec2& operator*=(double k) { return *this = k * *this; }
  constexpr Vec2& operator/=(double k) { return *this = *this / k; }

  friend constexpr Vec2 operator+(const Vec2& a, const Vec2& b) {
    return {a.x() + b.x(), a.y() + b.y()};
  }
  friend constexpr Vec2 operator-(const Vec2& a, const Vec2& b) {
    return {a.x() - b.x(), a.y() - b.y()};
  }
  friend constexpr Vec2 operator-(const Vec2& a) { return {-a.x(), -a.y()}; }
  friend constexpr Vec2 operator*(double k, const Vec2& a) { return {k * a.x(), k * a.y()}; }
  friend constexpr Vec2 operator*(const Vec2& a, double k) { return k * a; }
  friend constexpr Vec2 operator/(const Vec2& a, double k) { return {a.x() / k, a.y() / k}; }
  friend constexpr bool operator==(const Vec2& a, const Vec2& b) {
    return a.x() == b.x() && a.y() == b.y();
  }

  [[nodiscard]] constexpr double dot(const Vec2& b) const { return x() * b.x() + y() * b.y(); }
  [[nodiscard]] constexpr double squaredNorm() const { return dot(*this); }
  [[nodiscard]] double norm() const { return std::sqrt(squaredNorm()); }
  [[nodiscard]] bool allFinite() const { return std::isfinite(x()) && std::isfinite(y()); }

 private:
  double of_[2] = {0, 0};
};

}  // namespace carom
