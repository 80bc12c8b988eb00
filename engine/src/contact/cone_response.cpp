#include "contact/cone_response.hpp"

#include <algorithm>
#include <cmath>

#include "contact/cone_lanes.hpp"

namespace carom::event {

using cone::kLanes;
using cone::Lanes;
using cone::lanes;
using cone::larger_of;
using cone::largest;
using cone::size_of;

namespace {

/// As a part of how the bodies of a contact give way.
constexpr double kGive = 0x1p-24;

}  // namespace

ConeResponse::ConeResponse(const std::vector<ConeBody>& bodies,
                           const std::vector<ConeContact>& contacts)
    : contacts_(contacts.size()), size_((contacts.size() + kLanes - 1) / kLanes * kLanes) {
  for (const ConeBody& body : bodies) inverse_mass_.push_back(body.inverse_mass);
  inverse_mass_.push_back(0);
  const int wall = static_cast<int>(bodies.size());
  ends_.assign(size_, {wall, wall});
  for (Column* column : {&normal_x_, &normal_y_, &friction_}) column->assign(size_, 0);
  scale_.assign(size_, 1);
  bool has_friction = false;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const ConeContact& c = contacts[k];
    ends_[k] = {c.a, c.b == kWall ? wall : c.b};
    normal_x_[k] = c.normal.x;
    normal_y_[k] = c.normal.y;
    friction_[k] = c.friction;
    has_friction = has_friction || c.friction != 0;
  }
  edges_ = has_friction ? 2 * size_ : size_;
  totals_.resize(inverse_mass_.size());
  for (Column* column : {&push_x_, &push_y_, &push_turning_}) column->assign(size_, 0);
  scale_edges();
}

// Every edge in units in which its own response is the same.
void ConeResponse::scale_edges() {
  std::vector<int> at_body(inverse_mass_.size(), 0);
  for (std::size_t k = 0; k < contacts_; ++k) {
    for (const int body : ends_[k]) ++at_body[index(body)];
  }
  at_body.back() = 0;
  const auto response = [this](std::size_t k, double mobility) {
    return mobility * (1 + 3 * friction_[k] * friction_[k]);
  };
  double most = 0;
  for (std::size_t k = 0; k < contacts_; ++k) {
    const auto [a, b] = ends_[k];
    most = std::max(most, response(k, inverse_mass_[index(a)] + inverse_mass_[index(b)]));
    most_at_body_ = std::max({most_at_body_, 1.0 * at_body[index(a)], 1.0 * at_body[index(b)]});
  }
  if (!(most > 0)) return;
  give_ = kGive * most;
  double steepest = 0;
  for (std::size_t k = 0; k < contacts_; ++k) {
    const auto [a, b] = ends_[k];
    const double in_a = inverse_mass_[index(a)];
    const double in_b = inverse_mass_[index(b)];
    const double own = response(k, in_a + in_b);
    if (own > 0) scale_[k] = 1 / std::sqrt(own / most);
    const double all = response(k, in_a * at_body[index(a)] + in_b * at_body[index(b)]);
    const double edges = edges_ > size_ ? 2 : 1;
    steepest = std::max(steepest, edges * all * (scale_[k] * scale_[k]) + give_);
  }
  step_ = 1 / steepest;
}

// The impulses of the contacts, and what they do to the bodies.
void ConeResponse::pass_on(const double* impulses) {
  Lanes most{};
  for (std::size_t k = 0; k < size_; k += kLanes) {
    const Lanes& nx = lanes(&normal_x_[k]);
    const Lanes& ny = lanes(&normal_y_[k]);
    const Lanes& s = lanes(&scale_[k]);
    const Lanes& one = lanes(impulses + k);
    if (has_friction()) {
      const Lanes& other = lanes(impulses + size_ + k);
      const Lanes push = s * (one + other);
      const Lanes apply_friction = s * (lanes(&friction_[k]) * (one - other));
      lanes(&push_x_[k]) = push * nx - apply_friction * ny;
      lanes(&push_y_[k]) = push * ny + apply_friction * nx;
      lanes(&push_turning_[k]) = apply_friction;
      most = larger_of(most, size_of(apply_friction));
    } else {
      const Lanes push = s * one;
      lanes(&push_x_[k]) = push * nx;
      lanes(&push_y_[k]) = push * ny;
    }
    most = larger_of(most, larger_of(size_of(lanes(&push_x_[k])), size_of(lanes(&push_y_[k]))));
  }
  const OrderlessSum<double> grid(largest(most) * most_at_body_);
  std::fill(totals_.begin(), totals_.end(), Total{});
  for (std::size_t k = 0; k < contacts_; ++k) {
    const double x = grid.rounded(push_x_[k]);
    const double y = grid.rounded(push_y_[k]);
    Total& a = totals_[static_cast<std::size_t>(ends_[k][0])];
    Total& b = totals_[static_cast<std::size_t>(ends_[k][1])];
    a.x -= x;
    a.y -= y;
    b.x += x;
    b.y += y;
    if (!has_friction()) continue;
    const double turning = grid.rounded(push_turning_[k]);
    a.turning -= turning;
    b.turning -= turning;
  }
  for (std::size_t k = 0; k < totals_.size(); ++k) {
    Total& t = totals_[k];
    const double m = inverse_mass_[k];
    t = {m * t.x, m * t.y, 2 * m * t.turning};
  }
}

// How fast the ends of each contact part along its edges, moving as `totals_` says.
void ConeResponse::part(double* result) {
  for (std::size_t k = 0; k < contacts_; ++k) {
    const Total& a = totals_[static_cast<std::size_t>(ends_[k][0])];
    const Total& b = totals_[static_cast<std::size_t>(ends_[k][1])];
    push_x_[k] = b.x - a.x;
    push_y_[k] = b.y - a.y;
    if (has_friction()) push_turning_[k] = a.turning + b.turning;
  }
  for (std::size_t k = 0; k < size_; k += kLanes) {
    const Lanes& nx = lanes(&normal_x_[k]);
    const Lanes& ny = lanes(&normal_y_[k]);
    const Lanes& x = lanes(&push_x_[k]);
    const Lanes& y = lanes(&push_y_[k]);
    const Lanes& s = lanes(&scale_[k]);
    const Lanes apart = x * nx + y * ny;
    if (has_friction()) {
      const Lanes slip = lanes(&friction_[k]) * ((y * nx - x * ny) - lanes(&push_turning_[k]));
      lanes(result + k) = s * (apart + slip);
      lanes(result + size_ + k) = s * (apart - slip);
    } else {
      lanes(result + k) = s * apart;
    }
  }
}

void ConeResponse::times(const double* impulses, double* result) {
  pass_on(impulses);
  part(result);
  for (std::size_t k = 0; k < edges_; k += kLanes) {
    lanes(result + k) += give_ * lanes(impulses + k);
  }
}

}  // namespace carom::event
