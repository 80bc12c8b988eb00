#pragma once

#include "solvers/event/disk.hpp"
#include "solvers/event/fixed_time.hpp"
#include "solvers/event/rules.hpp"
#include "trajectory/damped_law.hpp"
#include "trajectory/flight.hpp"

namespace carom::event {

/// What the method is compiled for: the number it computes with and the law its balls fly by.
/// Whether contacts can come to rest, balls have friction, or some are fixed is asked where it
/// matters.
template <class S, template <class> class FlightLaw>
struct Physics {
  using Scalar = S;
  using Law = FlightLaw<S>;
  using Clock = event::Clock<S>;
  using Time = typename Clock::Time;
  using At = typename Clock::At;
  using Disk = BasicDisk<S>;

  static Law law(const BasicRules<S>& rules) { return law_of(rules, static_cast<Law*>(nullptr)); }

 private:
  static Law law_of(const BasicRules<S>& rules, BallisticLaw<S>*) { return {gravity(rules)}; }
  template <class WithDrag>
  static Law law_of(const BasicRules<S>& rules, WithDrag*) {
    return {gravity(rules), S(rules.drag_rate)};
  }

  static Vec<S> gravity(const BasicRules<S>& rules) {
    return {S(rules.gravity[0]), S(rules.gravity[1])};
  }
};

// All there are.
using Ballistic = Physics<double, BallisticLaw>;  ///< straight where there is no gravity
using Drag = Physics<double, DampedLaw>;

}  // namespace carom::event
