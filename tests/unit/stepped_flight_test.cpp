#include "solvers/event/islands/stepped_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace carom::event::stepped_flight_test {
namespace {

// Under an acceleration of 1, v' = 1 - k v: from v0 a ball goes v0 w + (T - w) / k in a time T, and
// then has v0 exp(-k T) + w, w = (1 - exp(-k T)) / k.
TEST(SteppedFlight, EndsWhereAndAsFastAsOneUnderTheForceAllTheTime) {
  for (const double fading : {0.0, 1e-9, 1e-3, 0.3, 3.9, 4.1, 50.0}) {
    const double time = 1.0 / 128;
    const SteppedFlight flight{time, fading};
    const double z = fading * time;
    const double w = fading > 0 ? -std::expm1(-z) / fading : time;
    const double v0 = 0.375;
    const double start = v0 + flight.given();
    const double at_rest = z < 1e-4 ? time * time * (0.5 - z / 6) : (time - w) / fading;
    EXPECT_NEAR(start * flight.way(), v0 * w + at_rest, 1e-12 * time) << fading;
    const double end = start * std::exp(-z) + flight.owed(time);
    EXPECT_NEAR(end, v0 * std::exp(-z) + w, 1e-15) << fading;
  }
}

// From one flight to the next of the same length, of a ball that is free, the energy of their
// middles changes by less than drag, at second order: not at all without drag.
TEST(SteppedFlight, KeepsTheEnergyOfItsMiddle) {
  for (const double fading : {0.0, 0.125}) {
    const double time = 1.0 / 64;
    const SteppedFlight flight{time, fading};
    const double before = 0.75;  // at the end of a flight
    const double after = before + flight.owed(time) + flight.given();
    const double had = before * before / 2 - before * flight.ahead(time);
    const double has = after * after / 2 - after * flight.ahead(0);
    EXPECT_NEAR(has, had, fading == 0 ? 1e-17 : time * std::pow(fading * time, 2) / 8) << fading;
    EXPECT_GT(flight.ahead(0), 0);
    EXPECT_LT(flight.ahead(time), 0);
  }
}

}  // namespace
}  // namespace carom::event::stepped_flight_test
