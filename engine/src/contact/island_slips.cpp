#include "contact/island_slips.hpp"

#include <algorithm>
#include <cmath>

#include "contact/island_contact.hpp"

namespace carom::contact {
namespace {

constexpr int kRevisions = 10;
constexpr int kLessenings = 2;       // that only make slips less
constexpr double kKnown = 0.5;       // of what is missed: a slip that is known
constexpr double kExactly = 0x1p-6;  // of what sticks: who misses no more slides as it will

}  // namespace

double sliding(const IslandContact& contact, const SurfaceMotion& a, const SurfaceMotion& b,
               double sticks) {
  return std::max(std::abs(slip_of(contact, a, b)) - sticks, 0.0);
}

void SlipRevision::operator()(const std::vector<double>& motion, double miss) {
  const bool ends = !(miss > sticks_);
  if (ends ? corrections_ == kLessenings || miss < kExactly * sticks_ : revisions_ == kRevisions) {
    return;
  }
  ++(ends ? corrections_ : revisions_);
  revise(motion, miss, ends);
}

SurfaceMotion SlipRevision::surface(const std::vector<double>& motion, int body) const {
  if (body < 0) return {};
  const double* change = motion.data() + index(body) * 3;
  const IslandBody& of = bodies_[index(body)];
  return {of.free + Vec2{change[0], change[1]}, of.turning + change[2]};
}

void SlipRevision::revise(const std::vector<double>& motion, double miss, bool ends) {
  std::size_t row = 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const IslandContact& c = contacts_[k];
    const std::size_t first = row;
    row += c.friction == 0 ? 1 : 2;
    if (c.friction == 0) continue;
    const SurfaceMotion a = surface(motion, c.a);
    const SurfaceMotion b = surface(motion, c.b);
    const double now = sliding(c, a, b, sticks_);
    const bool changes = now > slips_[k] ? !ends && !(now < kKnown * miss)
                                         : !ends || slips_[k] > sliding(c, a, b, sticks_ / 2);
    if (!changes || (ends && slips_[k] - now > miss)) continue;
    const double more = c.friction * (now - slips_[k]);
    for (std::size_t r = first; r < row; ++r) problem_.rows[r].q += more;
    slips_[k] = now;
  }
}

}  // namespace carom::contact
