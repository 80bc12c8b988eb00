#pragma once

#include "solvers/event/disk.hpp"

namespace carom::event {

/// The end of a flight: with what, and when.
template <class P>
struct Meeting {
  typename P::Time time = P::Clock::never();
  Index partner = kUnknown;
};

}  // namespace carom::event
