#include "contact/ball_contact.hpp"

#include <cmath>

namespace carom::contact {
namespace {

constexpr double kFar = 0x1p-8;  // a long way, by reach, squared

Vec2 touching_normal(const Vec2& r, const Vec2& way, double reach) {
  const double square = r.squaredNorm();
  const double along = r.dot(way);
  const double length = way.squaredNorm();
  if (square > reach * reach && along < 0 && length > kFar * reach * reach) {
    const double across = r.x() * way.y() - r.y() * way.x();
    const double root = length * reach * reach - across * across;
    if (root > 0) {
      const double part = (square - reach * reach) / (std::sqrt(root) - along);
      const Vec2 met = r + part * way;
      return met / met.norm();
    }
  }
  if (square > 0) return r / std::sqrt(square);
  return {0, 1};
}

}  // namespace

IslandContact ball_contact(const Vec2& r, const Vec2& way, double reach) {
  IslandContact contact;
  contact.normal = touching_normal(r, way, reach);
  contact.gap = contact.normal.dot(r) - reach;
  return contact;
}

}  // namespace carom::contact
