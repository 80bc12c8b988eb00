#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace carom::test {

/// A hundred decimal digits, to hold double against.
using Exact = boost::multiprecision::number<boost::multiprecision::backends::cpp_bin_float<100>,
                                            boost::multiprecision::et_off>;

/// The unit roundoff of double.
inline constexpr double kU = 0x1p-53;

/// |value - truth| / |truth| in units of u.
inline double error_in_u(double value, const Exact& truth) {
  const Exact error = abs(Exact(value) - truth) / abs(truth);
  return error.convert_to<double>() / kU;
}

}  // namespace carom::test
