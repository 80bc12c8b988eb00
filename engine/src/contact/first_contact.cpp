#include "contact/first_contact.hpp"

namespace carom {
namespace {

constexpr double choose(std::size_t n, std::size_t k) {
  double value = 1;
  for (std::size_t i = 0; i < k; ++i) {
    value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
  }
  return value;
}

// The product of two polynomials, added to a third.
template <std::size_t kP, std::size_t kQ>
void add_product(const Bernstein<kP>& p, const Bernstein<kQ>& q, Bernstein<kP + kQ>& sum) {
  for (std::size_t k = 0; k <= kP + kQ; ++k) {
    double term = 0;
    for (std::size_t i = k > kQ ? k - kQ : 0; i <= k && i <= kP; ++i) {
      term += choose(kP, i) * choose(kQ, k - i) * p[i] * q[k - i];
    }
    sum[k] += term / choose(kP + kQ, k);
  }
}

}  // namespace

std::optional<double> first_contact(const Bernstein<5>& x, const Bernstein<5>& y,
                                    const Vec2& velocity, double reach) {
  // r.r - reach^2, so that x and y may change places
  Bernstein<10> beyond{};
  add_product<5, 5>(x, x, beyond);
  add_product<5, 5>(y, y, beyond);
  for (double& coefficient : beyond) coefficient -= reach * reach;
  Bernstein<9> slope{};  // r.v
  add_product<5, 4>(x, differences(x), slope);
  add_product<5, 4>(y, differences(y), slope);
  return first_meeting<10, 9>(beyond, slope, x[0] * velocity.x() + y[0] * velocity.y());
}

std::optional<double> first_landing(const Bernstein<5>& height, double velocity) {
  return first_meeting<5, 4>(height, differences(height), velocity);
}

}  // namespace carom
