#include "contact/cone_island.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/interior_point.hpp"
#include "numbers/orderless_sum.hpp"

// How lanes are passed depends on the processor's registers; they never leave this file.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace carom::event {

namespace {

/// How far contacts give way to an impulse, as a part of how their bodies do: it makes the loads of
/// islands with more contacts than freedoms definite.
constexpr double kGive = 0x1p-24;
/// How often what they gave way is taken back: at most.
constexpr int kMostRefinements = 64;
constexpr int kMostDescents = 1000;
/// How often the slip is looked at again, with what its contacts carry then.
constexpr int kSlides = 3;
/// What may open so is not looked at again, in goals.
constexpr double kOpens = 256;

// Columns are whole numbers of these: maxima, and sums of terms that are on one grid, have the
// same bits in any order.
constexpr std::size_t kLanes = 8;
// NOLINTNEXTLINE(modernize-use-using): `using` drops the attribute
typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double)), aligned(8), may_alias));

const Lanes& lanes(const double* at) {
  return *reinterpret_cast<const Lanes*>(at);
}
Lanes& lanes(double* at) {
  return *reinterpret_cast<Lanes*>(at);
}
Lanes size_of(const Lanes& a) {
  return a < 0 ? -a : a;
}
Lanes larger_of(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
double largest(const Lanes& a) {
  double result = a[0];
  for (std::size_t k = 1; k < kLanes; ++k) result = std::max(result, a[k]);
  return result;
}
double sum(const Lanes& a) {
  double result = 0;
  for (std::size_t k = 0; k < kLanes; ++k) result += a[k];
  return result;
}

/// Terms of two sums.
struct Two {
  Lanes one;
  Lanes other;
};

/// Two sums over n terms each.
template <class Terms>
std::array<double, 2> sums(std::size_t n, const Terms& terms) {
  Two most{};
  for (std::size_t k = 0; k < n; k += kLanes) {
    const Two now = terms(k);
    most.one = larger_of(most.one, size_of(now.one));
    most.other = larger_of(most.other, size_of(now.other));
  }
  const auto count = static_cast<double>(n);
  const double one = OrderlessSum<double>(largest(most.one) * count).grid();
  const double other = OrderlessSum<double>(largest(most.other) * count).grid();
  Two total{};
  for (std::size_t k = 0; k < n; k += kLanes) {
    const Two now = terms(k);
    total.one += (now.one + one) - one;
    total.other += (now.other + other) - other;
  }
  return {sum(total.one), sum(total.other)};
}

}  // namespace

ConeIsland::ConeIsland(const Bodies& bodies, const Contacts& contacts) : contacts_(contacts) {
  size_ = (contacts.size() + kLanes - 1) / kLanes * kLanes;
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
  for (Column* column :
       {&start_, &parting_, &impulses_, &anchor_, &slope_, &way_, &free_, &change_}) {
    column->assign(edges_, 0);
  }
  scale();
}

// Every edge in units in which its own response is the same.
void ConeIsland::scale() {
  std::vector<int> at_body(inverse_mass_.size(), 0);
  const auto index = [](int body) { return static_cast<std::size_t>(body); };
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    for (const int body : ends_[k]) ++at_body[index(body)];
  }
  at_body.back() = 0;
  const auto response = [this](std::size_t k, double mobility) {
    return mobility * (1 + 3 * friction_[k] * friction_[k]);
  };
  double most = 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto [a, b] = ends_[k];
    most = std::max(most, response(k, inverse_mass_[index(a)] + inverse_mass_[index(b)]));
    most_at_body_ = std::max({most_at_body_, 1.0 * at_body[index(a)], 1.0 * at_body[index(b)]});
  }
  if (!(most > 0)) return;
  give_ = kGive * most;
  double steepest = 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
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
void ConeIsland::pass_on(const double* impulses) {
  const bool has_friction = edges_ > size_;
  Lanes most{};
  for (std::size_t k = 0; k < size_; k += kLanes) {
    const Lanes& nx = lanes(&normal_x_[k]);
    const Lanes& ny = lanes(&normal_y_[k]);
    const Lanes& s = lanes(&scale_[k]);
    const Lanes& one = lanes(impulses + k);
    if (has_friction) {
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
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const double x = grid.rounded(push_x_[k]);
    const double y = grid.rounded(push_y_[k]);
    Total& a = totals_[static_cast<std::size_t>(ends_[k][0])];
    Total& b = totals_[static_cast<std::size_t>(ends_[k][1])];
    a.x -= x;
    a.y -= y;
    b.x += x;
    b.y += y;
    if (!has_friction) continue;
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
void ConeIsland::part(double* result) const {
  const bool has_friction = edges_ > size_;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Total& a = totals_[static_cast<std::size_t>(ends_[k][0])];
    const Total& b = totals_[static_cast<std::size_t>(ends_[k][1])];
    push_x_[k] = b.x - a.x;
    push_y_[k] = b.y - a.y;
    if (has_friction) push_turning_[k] = a.turning + b.turning;
  }
  for (std::size_t k = 0; k < size_; k += kLanes) {
    const Lanes& nx = lanes(&normal_x_[k]);
    const Lanes& ny = lanes(&normal_y_[k]);
    const Lanes& x = lanes(&push_x_[k]);
    const Lanes& y = lanes(&push_y_[k]);
    const Lanes& s = lanes(&scale_[k]);
    const Lanes apart = x * nx + y * ny;
    if (has_friction) {
      const Lanes slip = lanes(&friction_[k]) * ((y * nx - x * ny) - lanes(&push_turning_[k]));
      lanes(result + k) = s * (apart + slip);
      lanes(result + size_ + k) = s * (apart - slip);
    } else {
      lanes(result + k) = s * apart;
    }
  }
}

void ConeIsland::times(const double* impulses, double* result) {
  pass_on(impulses);
  part(result);
  for (std::size_t k = 0; k < edges_; k += kLanes) {
    lanes(result + k) += give_ * lanes(impulses + k);
  }
}

void ConeIsland::expand(double room) {
  for (std::size_t k = 0; k < edges_; k += kLanes) {
    const Lanes at = lanes(&impulses_[k]) - room * lanes(&way_[k]);
    const Lanes slope = lanes(&slope_[k]) - room * lanes(&change_[k]);
    const Lanes down = at - step_ * slope;
    lanes(&impulses_[k]) = at > 0 && down > 0 ? down : Lanes{};
  }
  times(impulses_.data(), slope_.data());
  for (std::size_t k = 0; k < edges_; k += kLanes) {
    lanes(&slope_[k]) += lanes(&parting_[k]);
    lanes(&way_[k]) = lanes(&impulses_[k]) > 0 ? lanes(&slope_[k]) : Lanes{};
  }
}

// Many contacts of a pile are nearly dependent: conjugate gradients take ever more rounds, an
// interior point hardly more than for few.
template <int D>
bool ConeIsland::solve_many(double goal) {
  double largest_inverse = 0;
  for (const double inverse : inverse_mass_) largest_inverse = std::max(largest_inverse, inverse);
  const double unit = std::ldexp(1.0, -std::ilogb(largest_inverse));
  contact::ContactProblem<D> problem;
  for (std::size_t i = 0; i + 1 < inverse_mass_.size(); ++i) {
    for (int c = 0; c < D; ++c) {
      problem.inverse_mass.push_back((c < 2 ? 1 : 2) * unit * inverse_mass_[i]);
    }
  }
  const auto sides = [this](std::size_t k) { return D == 3 && friction_[k] != 0 ? 2U : 1U; };
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    for (std::size_t side = 0; side < sides(k); ++side) {
      const double mu = (side == 0 ? 1 : -1) * friction_[k];
      contact::Row<D> row;
      row.a = contacts_[k].a;
      row.b = contacts_[k].b == kWall ? -1 : contacts_[k].b;
      row.j[0] = normal_x_[k] - mu * normal_y_[k];
      row.j[1] = normal_y_[k] + mu * normal_x_[k];
      if (D == 3) row.j[D - 1] = -mu;
      row.q = parting_[side * size_ + k] / scale_[k];
      problem.rows.push_back(row);
    }
  }
  problem.weigh();
  std::vector<double> impulses;
  // Kept for its memory; nothing of one problem shows in the next.
  thread_local contact::InteriorPoint<D> solver;
  if (!solver.solve(problem, goal, impulses).solved) return false;
  std::fill(impulses_.begin(), impulses_.end(), 0);
  std::size_t row = 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    for (std::size_t side = 0; side < sides(k); ++side) {
      impulses_[side * size_ + k] = unit * impulses[row++] / scale_[k];
    }
  }
  return true;
}

// Contacts give way from where the last solution left them (proximal point method), so that in the
// end they give way to nothing, however heavy what they carry is.
void ConeIsland::solve(double goal) {
  if (contacts_.size() > kFewContacts) {
    if (edges_ > size_ ? solve_many<3>(goal / 2) : solve_many<2>(goal / 2)) return;
  }
  std::fill(anchor_.begin(), anchor_.end(), 0);
  for (int round = 0; round < kMostRefinements; ++round) {
    descend(goal);
    Lanes most{};
    for (std::size_t k = 0; k < edges_; k += kLanes) {
      most = larger_of(most, size_of(give_ * (lanes(&impulses_[k]) - lanes(&anchor_[k]))));
    }
    if (!(largest(most) > goal / 4)) return;
    for (std::size_t k = 0; k < edges_; k += kLanes) {
      lanes(&parting_[k]) -= give_ * (lanes(&impulses_[k]) - lanes(&anchor_[k]));
      lanes(&anchor_[k]) = lanes(&impulses_[k]);
    }
  }
}

void ConeIsland::descend(double goal) {
  const double to_bound = 1 / step_;
  times(impulses_.data(), slope_.data());
  const auto onto = [this](std::size_t k) {
    const Lanes& slope = lanes(&slope_[k]);
    return lanes(&impulses_[k]) > 0 || slope > 0 ? Lanes{} : slope;
  };
  const auto free = [this](std::size_t k) {
    return lanes(&impulses_[k]) > 0 ? lanes(&slope_[k]) : Lanes{};
  };
  for (std::size_t k = 0; k < edges_; k += kLanes) {
    lanes(&slope_[k]) += lanes(&parting_[k]);
    lanes(&way_[k]) = free(k);
  }
  // The step along the way that descends farthest, and how the slope bends on it.
  const auto look_along = [&]() -> std::array<double, 2> {
    times(way_.data(), change_.data());
    const auto [fall, curvature] = sums(edges_, [&](std::size_t k) -> Two {
      const Lanes& way = lanes(&way_[k]);
      return {lanes(&slope_[k]) * way, way * lanes(&change_[k])};
    });
    return {fall / curvature, curvature};
  };
  const auto descend = [this](double length, std::size_t k) {
    lanes(&impulses_[k]) -= length * lanes(&way_[k]);
    lanes(&slope_[k]) -= length * lanes(&change_[k]);
  };
  for (int round = 0; round < kMostDescents; ++round) {
    Lanes remains{};
    for (std::size_t k = 0; k < edges_; k += kLanes) {
      remains = larger_of(remains, size_of(free(k) + onto(k)));
    }
    if (!(largest(remains) > goal)) return;
    const auto [off, along] = sums(edges_, [&](std::size_t k) -> Two {
      const Lanes down = onto(k);
      const Lanes inside = free(k);
      const Lanes most = to_bound * lanes(&impulses_[k]);
      return {down * down, inside * (inside < most ? inside : most)};
    });
    if (off > along) {
      for (std::size_t k = 0; k < edges_; k += kLanes) lanes(&way_[k]) = onto(k);
      const double length = look_along()[0];
      for (std::size_t k = 0; k < edges_; k += kLanes) {
        descend(length, k);
        lanes(&way_[k]) = free(k);
      }
      continue;
    }
    const auto [length, curvature] = look_along();
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Lanes nearest = Lanes{} + kFar;
    for (std::size_t k = 0; k < edges_; k += kLanes) {
      const Lanes& way = lanes(&way_[k]);
      const Lanes until = way > 0 ? lanes(&impulses_[k]) / way : Lanes{} + kFar;
      nearest = nearest < until ? nearest : until;
    }
    const double room = -largest(-nearest);
    if (!(length < room)) {
      expand(room);
      continue;
    }
    for (std::size_t k = 0; k < edges_; k += kLanes) descend(length, k);
    const auto turned = sums(edges_, [&](std::size_t k) -> Two {
      return {free(k) * lanes(&change_[k]), Lanes{}};
    });
    const double turn = turned[0] / curvature;
    for (std::size_t k = 0; k < edges_; k += kLanes) {
      lanes(&way_[k]) = free(k) - turn * lanes(&way_[k]);
    }
  }
}

// A contact that slides would open by the coefficient times its slip.  One with something that
// never moves, which slid before, too, is given that much to close: what is thrown along a floor
// stays on it.
void ConeIsland::close_slides(double goal) {
  Column given(size_, 0);
  const auto slip = [this](std::size_t k) {
    return std::abs((start_[k] + change_[k]) - (start_[size_ + k] + change_[size_ + k])) / 2;
  };
  for (int round = 0; round < kSlides; ++round) {
    pass_on(impulses_.data());
    part(change_.data());
    double most = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      if (contacts_[k].b != kWall) continue;
      const double before = std::abs(start_[k] - start_[size_ + k]) / 2;
      double now = std::min(before, slip(k));
      if (round > 0) now = std::min(now, given[k]);
      // What stops sliding would sink in by as much: in the end it is given nothing.
      if (round + 1 == kSlides && given[k] - now > kOpens * goal) now = 0;
      const double more = now - given[k];
      most = std::max(most, std::abs(more));
      given[k] = now;
      parting_[k] += more;
      parting_[size_ + k] += more;
    }
    if (!(most > kOpens * goal)) return;
    solve(goal);
  }
}

std::vector<double> ConeIsland::resolve(Bodies& motion, double rate, double goal, bool slides) {
  for (std::size_t k = 0; k < motion.size(); ++k) {
    totals_[k] = {motion[k].velocity.x, motion[k].velocity.y, motion[k].turning};
  }
  totals_.back() = {};
  part(start_.data());
  parting_ = start_;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const ConeContact& c = contacts_[k];
    const double room = c.parting > 0 ? -c.parting : std::max(c.gap * rate, 0.0);
    for (std::size_t at = k; at < edges_; at += size_) parting_[at] += scale_[k] * room;
  }
  std::fill(impulses_.begin(), impulses_.end(), 0);
  solve(goal);
  if (slides && edges_ > size_) close_slides(goal);
  pass_on(impulses_.data());
  for (std::size_t k = 0; k < motion.size(); ++k) {
    motion[k].velocity = motion[k].velocity + Vec<double>{totals_[k].x, totals_[k].y};
    motion[k].turning += totals_[k].turning;
  }
  std::vector<double> loads;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    double load = impulses_[k];
    if (edges_ > size_) load += impulses_[size_ + k];
    loads.push_back(scale_[k] * load);
  }
  return loads;
}

}  // namespace carom::event
